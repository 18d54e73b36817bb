// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

// Floors that show one thing that users report, in all sizes: a corridor that enters halls at its
// full width, cubicles in a hall, walls of which only posts are seen.
namespace quadcut {

/// A drawn map and its true rooms.
struct FieldCase {
    GridMap map;
    Raster<std::uint32_t> truth;
};

/// Draws floors, walls and rooms; lengths in cells of 5 cm.
class FieldPainter {
public:
    FieldPainter(std::int32_t width, std::int32_t height, std::uint64_t seed)
        : random_(seed), truth_({0, 0}, width, height) {
        map_.states = Raster<CellState>({0, 0}, width, height);
    }
    /// From low to high, inclusive.
    [[nodiscard]] std::int32_t between(std::int32_t low, std::int32_t high) {
        return std::uniform_int_distribution<std::int32_t>(low, high)(random_);
    }
    void room(std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
              std::uint32_t label) {
        for_each(x - 3, y - 3, width + 6, height + 6, [&](std::size_t i) {
            if (map_.states.values[i] == CellState::unknown) {
                map_.states.values[i] = CellState::occupied;
            }
        });
        open(x, y, width, height, label);
    }
    void open(std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
              std::uint32_t label) {
        for_each(x, y, width, height, [&](std::size_t i) {
            map_.states.values[i] = CellState::free;
            truth_.values[i] = label;
        });
    }
    void wall(std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height) {
        for_each(x, y, width, height,
                 [&](std::size_t i) { map_.states.values[i] = CellState::occupied; });
    }
    [[nodiscard]] FieldCase take() { return {std::move(map_), std::move(truth_)}; }

private:
    template <typename Paint>
    void for_each(std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
                  const Paint& paint) {
        for (std::int32_t v = std::max(0, y); v < std::min(truth_.height, y + height); ++v) {
            for (std::int32_t u = std::max(0, x); u < std::min(truth_.width, x + width); ++u) {
                paint(truth_.offset({u, v}));
            }
        }
    }

    std::mt19937_64 random_;
    GridMap map_;
    Raster<std::uint32_t> truth_;
};

/// Two halls, and a corridor between them that is as wide all along.
inline FieldCase halls_and_corridor(std::uint64_t seed) {
    FieldPainter paint(900, 300, seed);
    const std::int32_t corridor_width = paint.between(28, 64);
    const std::int32_t length = paint.between(80, 420);
    const std::array<std::int32_t, 2> height{paint.between(3 * corridor_width / 2 + 20, 260),
                                             paint.between(3 * corridor_width / 2 + 20, 260)};
    const std::array<std::int32_t, 2> width{paint.between(90, 200), paint.between(90, 200)};
    const std::int32_t y = 150 - corridor_width / 2;
    std::int32_t x = 10;
    for (std::size_t k = 0; k < 2; ++k) {
        const std::int32_t spare = height[k] - corridor_width;
        const std::int32_t below =
            std::clamp(paint.between(0, spare), std::max(0, spare - 130), std::min(spare, 130));
        paint.room(x, y - below, width[k], height[k], static_cast<std::uint32_t>(k + 1));
        x += width[k] + length;
    }
    const std::int32_t begin = 10 + width[0];
    paint.room(begin, y, length, corridor_width, 3);
    for (std::int32_t door = begin + 20; paint.between(0, 2) > 0 && door + 90 < begin + length;
         door += 100) {
        paint.room(door - 10, y + corridor_width + 3, 80, paint.between(50, 100),
                   static_cast<std::uint32_t>(4 + door));
        paint.open(door, y + corridor_width, paint.between(16, 22), 3, 3);
    }
    return paint.take();
}

/// A hall with rows of desks between partitions, and a corridor beside it.
inline FieldCase cubicles(std::uint64_t seed) {
    FieldPainter paint(700, 700, seed);
    const std::int32_t pitch = paint.between(32, 50);
    const std::int32_t depth = paint.between(24, 36);
    const std::int32_t aisle = paint.between(24, 44);
    const std::int32_t num_desks = paint.between(3, 8);
    const std::int32_t num_rows = paint.between(1, 3);
    const std::int32_t width = num_desks * pitch + 2 * aisle;
    const std::int32_t height = num_rows * (2 * depth + aisle) + aisle;
    paint.room(10, 10, width, height, 1);
    paint.room(10, 13 + height, width, paint.between(30, 50), 2);
    const std::int32_t door = 10 + paint.between(10, width - 30);
    paint.open(door, 10 + height, paint.between(16, 22), 3, 2);
    for (std::int32_t row = 0; row < num_rows; ++row) {
        const std::int32_t spine = 10 + aisle + depth + row * (2 * depth + aisle);
        paint.wall(10 + aisle, spine, num_desks * pitch, 2);
        for (std::int32_t k = 0; k <= num_desks; ++k) {
            paint.wall(10 + aisle + k * pitch, spine - depth, 2, 2 * depth);
        }
    }
    return paint.take();
}

/// Two rooms and a door in the wall between, of which only posts, or bits, are seen.
inline FieldCase wall_of_posts(std::uint64_t seed) {
    FieldPainter paint(500, 300, seed);
    const std::int32_t height = paint.between(80, 260);
    const std::int32_t first = paint.between(80, 220);
    const std::int32_t second = paint.between(80, 220);
    const std::int32_t post = paint.between(1, 3);
    const std::int32_t gap = paint.between(1, 4);
    paint.room(10, 10, first + second + post, height, 1);
    paint.open(10 + first + post, 10, second, height, 2);
    const std::int32_t door = 10 + paint.between(10, height - 40);
    for (std::int32_t y = 10; y < 10 + height; y += post + gap) {
        if (y + post > door && y < door + 19) continue;
        paint.wall(10 + first, y, post, post);
    }
    return paint.take();
}

}  // namespace quadcut
