// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/occupancy_map.hpp"

namespace quadcut {

/// The occupied cells of a map.
inline std::vector<Cell> obstacles_of(const OccupancyMap& map) {
    std::vector<Cell> cells;
    const Box tiles = map.written_tiles();
    for (Cell tile = tiles.low; tile.y <= tiles.high.y; ++tile.y) {
        for (tile.x = tiles.low.x; tile.x <= tiles.high.x; ++tile.x) {
            const Tile& values = map.tile(tile);
            const Cell low = first_cell_of(tile);
            for (std::size_t i = 0; i < kTileCells; ++i) {
                if (values.values[i] <= 0) continue;
                cells.push_back({low.x + static_cast<std::int32_t>(i % kTileSide),
                                 low.y + static_cast<std::int32_t>(i / kTileSide)});
            }
        }
    }
    return cells;
}

/// The squared distance of two cells.
inline std::int64_t squared_distance(Cell a, Cell b) {
    const std::int64_t dx = std::int64_t{a.x} - b.x;
    const std::int64_t dy = std::int64_t{a.y} - b.y;
    return dx * dx + dy * dy;
}

/// A KD-tree of obstacle points, one node a point, in the place of its median: the map that the
/// paper compares its quadtree with (Fig 13). It is not changed but built anew for each scan.
class KdTree {
public:
    explicit KdTree(std::vector<Cell> points) : points_(std::move(points)) {
        build(0, points_.size(), true);
    }
    [[nodiscard]] std::size_t num_nodes() const { return points_.size(); }
    [[nodiscard]] const std::vector<Cell>& points() const { return points_; }
    /// A point that no other is nearer than; nothing in an empty tree. O(log points) mostly.
    [[nodiscard]] std::optional<Cell> nearest(Cell to) const {
        if (points_.empty()) return std::nullopt;
        Best best{points_.front(), std::numeric_limits<std::int64_t>::max()};
        search(0, points_.size(), true, to, best);
        return best.point;
    }

private:
    struct Best {
        Cell point;
        std::int64_t squared = 0;
    };

    void build(std::size_t first, std::size_t last, bool by_x) {
        if (last - first < 2) return;
        const std::size_t middle = first + (last - first) / 2;
        const auto at = [&](std::size_t i) {
            return points_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(at(first), at(middle), at(last),
                         [&](Cell p, Cell q) { return by_x ? p.x < q.x : p.y < q.y; });
        build(first, middle, !by_x);
        build(middle + 1, last, !by_x);
    }
    void search(std::size_t first, std::size_t last, bool by_x, Cell to, Best& best) const {
        if (first == last) return;
        const std::size_t middle = first + (last - first) / 2;
        const Cell point = points_[middle];
        const std::int64_t squared = squared_distance(point, to);
        if (squared < best.squared) best = {point, squared};
        const std::int64_t beyond =
            by_x ? std::int64_t{to.x} - point.x : std::int64_t{to.y} - point.y;
        const auto left = [&] { search(first, middle, !by_x, to, best); };
        const auto right = [&] { search(middle + 1, last, !by_x, to, best); };
        beyond < 0 ? left() : right();
        // Points on the line itself lie on either side.
        if (beyond * beyond > best.squared) return;
        beyond < 0 ? right() : left();
    }

    std::vector<Cell> points_;
};

}  // namespace quadcut
