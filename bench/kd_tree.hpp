// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

/// A KD-tree of obstacle points, one node a point, in the place of its median: the map that the
/// paper compares its quadtree with (Fig 13). It is not changed but built anew for each scan.
class KdTree {
public:
    explicit KdTree(std::vector<Cell> points) : points_(std::move(points)) {
        build(0, points_.size(), true);
    }
    [[nodiscard]] std::size_t num_nodes() const { return points_.size(); }
    [[nodiscard]] const std::vector<Cell>& points() const { return points_; }

private:
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

    std::vector<Cell> points_;
};

}  // namespace quadcut
