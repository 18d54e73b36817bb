// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/outline.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "quadcut/map/connected_parts.hpp"

namespace quadcut::io {
namespace {

// Directions in counter-clockwise order.
constexpr int kEast = 0;
constexpr int kNumDirections = 4;
constexpr std::array<Cell, kNumDirections> kStep = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// A bit for each cell: whether its lower edge has been walked along.
class WalkedEdges {
public:
    explicit WalkedEdges(std::size_t num_cells) : words_(num_cells / kBitsPerWord + 1, 0) {}
    void mark(std::size_t place) { words_[place / kBitsPerWord] |= bit(place); }
    [[nodiscard]] bool at(std::size_t place) const {
        return (words_[place / kBitsPerWord] & bit(place)) != 0;
    }

private:
    static constexpr std::size_t kBitsPerWord = 64;
    static std::uint64_t bit(std::size_t place) {
        return std::uint64_t{1} << (place % kBitsPerWord);
    }
    std::vector<std::uint64_t> words_;
};

/// Walks along the borders of regions. Cells beside each other are in one region if their values
/// are equal, so that numbers of regions are needed only where but a corner joins two cells.
template <typename T>
class Tracer {
public:
    Tracer(const Raster<T>& values, T diagonal_value, const ConnectedParts& parts)
        : values_(values),
          diagonal_value_(diagonal_value),
          parts_(parts),
          walked_(values.values.size()) {}

    /// Whether a ring starts at the lower edge of this cell, which is of a region.
    [[nodiscard]] bool starts_ring(std::int32_t x, std::int32_t y) const {
        const std::size_t place = place_of(x, y);
        const bool has_edge =
            y == 0 || values_.values[place - static_cast<std::size_t>(values_.width)] !=
                          values_.values[place];
        return has_edge && !walked_.at(place);
    }

    /// @pre `part` is the one of the cell.
    OutlineRing walk(std::int32_t x, std::int32_t y, std::uint32_t part) {
        const T value = value_at(x, y);
        const Cell start{x, y};
        OutlineRing ring;
        Cell corner = start;
        int direction = kEast;
        do {
            if (direction == kEast) walked_.mark(place_of(corner.x, corner.y));
            corner.x += kStep[static_cast<std::size_t>(direction)].x;
            corner.y += kStep[static_cast<std::size_t>(direction)].y;
            const std::array<T, kNumDirections> cells = around(corner);
            const int turned = turn(cells, corner, direction, value, part);
            const bool junction = is_junction(cells);
            if (turned != direction || junction) {
                ring.push_back(
                    {corner.x + values_.origin.x, corner.y + values_.origin.y, junction});
            }
            direction = turned;
        } while (corner != start || direction != kEast);
        return ring;
    }

private:
    [[nodiscard]] std::size_t place_of(std::int32_t x, std::int32_t y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(values_.width) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] T value_at(std::int32_t x, std::int32_t y) const {
        if (x < 0 || y < 0 || x >= values_.width || y >= values_.height) return 0;
        return values_.values[place_of(x, y)];
    }
    [[nodiscard]] bool joins_diagonally(T value) const {
        return value != 0 && value == diagonal_value_;
    }

    /// The values of the four cells around a corner, counter-clockwise from the upper right one.
    [[nodiscard]] std::array<T, kNumDirections> around(Cell corner) const {
        return {value_at(corner.x, corner.y), value_at(corner.x - 1, corner.y),
                value_at(corner.x - 1, corner.y - 1), value_at(corner.x, corner.y - 1)};
    }

    /// Where to go on from a corner with the region on the left. Where only the corner joins two
    /// cells of the region, right: then a hole that touches the outside there stays a hole, and
    /// no ring passes a point twice. But left, if the corner joins cells of the diagonal value.
    [[nodiscard]] int turn(const std::array<T, kNumDirections>& cells, Cell corner, int direction,
                           T value, std::uint32_t part) const {
        const auto cell = [&](int side) {
            return cells[static_cast<std::size_t>((side + kNumDirections) % kNumDirections)];
        };
        // Travelling in direction d, cell d is ahead on the left, d - 1 ahead on the right, d - 2
        // behind on the right.
        const bool left_ahead = cell(direction) == value;
        bool right_ahead = cell(direction - 1) == value;
        if (right_ahead && !left_ahead && !joins_diagonally(value)) {
            right_ahead = part_around(corner, direction - 1) == part;
        }
        const bool parted = !left_ahead && cell(direction) == cell(direction - 2) &&
                            joins_diagonally(cell(direction));
        if (right_ahead && !parted) return (direction + kNumDirections - 1) % kNumDirections;
        return left_ahead ? direction : (direction + 1) % kNumDirections;
    }

    /// The region of a cell of around(corner).
    [[nodiscard]] std::uint32_t part_around(Cell corner, int side) const {
        constexpr std::array<Cell, kNumDirections> kFromCorner = {
            {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
        const Cell step =
            kFromCorner[static_cast<std::size_t>((side + kNumDirections) % kNumDirections)];
        return parts_.part_at(static_cast<std::uint32_t>(corner.x + step.x),
                              static_cast<std::size_t>(corner.y + step.y));
    }

    [[nodiscard]] bool is_junction(const std::array<T, kNumDirections>& cells) const {
        int num_edges = 0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (cells[i] != cells[(i + 1) % cells.size()]) ++num_edges;
        }
        // Borders pass on either side of cells that are joined at the corner.
        const bool joined = (cells[0] == cells[2] && joins_diagonally(cells[0])) ||
                            (cells[1] == cells[3] && joins_diagonally(cells[1]));
        return num_edges > 2 && !joined;
    }

    const Raster<T>& values_;
    T diagonal_value_;
    const ConnectedParts& parts_;
    WalkedEdges walked_;
};

/// A region's outline, and the place of its first cell.
struct PlacedOutline {
    std::size_t first = 0;
    RegionOutline outline;
};

template <typename T>
std::vector<PlacedOutline> trace_parts(const Raster<T>& values, T diagonal_value,
                                       const ConnectedParts& parts) {
    std::vector<PlacedOutline> outlines(parts.count);
    Tracer<T> tracer(values, diagonal_value, parts);
    parts.for_each_run([&](const CellRun& run, std::size_t first) {
        PlacedOutline& placed = outlines[run.part - 1];
        RegionOutline& outline = placed.outline;
        if (outline.num_cells == 0) {
            placed.first = first;
            outline.value = values.values[first];
        }
        outline.num_cells += run.end - run.begin;
        const auto y = static_cast<std::int32_t>(first / static_cast<std::size_t>(values.width));
        for (std::uint32_t column = run.begin; column < run.end; ++column) {
            const auto x = static_cast<std::int32_t>(column);
            if (tracer.starts_ring(x, y)) outline.rings.push_back(tracer.walk(x, y, run.part));
        }
    });
    return outlines;
}

template <typename T>
std::vector<RegionOutline> trace(const Raster<T>& values, std::uint32_t diagonal_value,
                                 const Executor& executor) {
    const auto diagonal = static_cast<T>(diagonal_value);
    const auto& cells = values.values;
    const ConnectedParts parts = connected_parts(
        values, [&](std::size_t i) { return cells[i] == diagonal ? T{0} : cells[i]; },
        Connectivity::four, executor);
    std::vector<PlacedOutline> placed = trace_parts(values, diagonal, parts);
    if (diagonal != 0) {
        const ConnectedParts joined = connected_parts(
            values, [&](std::size_t i) { return cells[i] == diagonal ? 1 : 0; },
            Connectivity::eight, executor);
        std::vector<PlacedOutline> others = trace_parts(values, diagonal, joined);
        std::move(others.begin(), others.end(), std::back_inserter(placed));
        std::sort(placed.begin(), placed.end(),
                  [](const PlacedOutline& a, const PlacedOutline& b) { return a.first < b.first; });
    }
    std::vector<RegionOutline> outlines;
    outlines.reserve(placed.size());
    for (PlacedOutline& each : placed) outlines.push_back(std::move(each.outline));
    return outlines;
}

}  // namespace

std::vector<RegionOutline> trace_outlines(const Raster<std::uint8_t>& values,
                                          std::uint32_t diagonal_value, const Executor& executor) {
    return trace(values, diagonal_value, executor);
}

std::vector<RegionOutline> trace_outlines(const Raster<std::uint16_t>& values,
                                          std::uint32_t diagonal_value, const Executor& executor) {
    return trace(values, diagonal_value, executor);
}

std::vector<Cell> corners_of(const OutlineRing& ring) {
    std::vector<Cell> corners;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const OutlinePoint& before = ring[(i + ring.size() - 1) % ring.size()];
        const OutlinePoint& here = ring[i];
        const OutlinePoint& after = ring[(i + 1) % ring.size()];
        const bool straight =
            (before.x == here.x && here.x == after.x) || (before.y == here.y && here.y == after.y);
        if (!straight) corners.push_back({here.x, here.y});
    }
    return corners;
}

}  // namespace quadcut::io
