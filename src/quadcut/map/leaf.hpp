// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"

namespace quadcut {

/// A leaf of the quadtree: the largest aligned square block of one state. A leaf of level l covers
/// 2^l x 2^l cells. Levels count from the single cell up, so that they do not change when the root
/// grows; the paper's layer is root_level - level.
/// Eq. (1): a cell, the smallest unit, has the area x_map y_map / 4^l, where l = root_level.
struct Leaf {
    Cell lower_left;
    std::uint8_t level = 0;
    CellState state = CellState::unknown;

    [[nodiscard]] std::int32_t side_cells() const { return std::int32_t{1} << level; }
    /// Its cells.
    [[nodiscard]] Box box() const {
        return {lower_left, {lower_left.x + (side_cells() - 1), lower_left.y + (side_cells() - 1)}};
    }
    friend bool operator==(const Leaf&, const Leaf&) = default;
};

/// A point of the lattice of half cells: cell (x, y) covers [2x, 2x + 2] x [2y, 2y + 2]. The centre
/// of every leaf is such a point, so that sight between leaves is decided without rounding.
struct HalfCell {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend bool operator==(const HalfCell&, const HalfCell&) = default;
};

[[nodiscard]] inline HalfCell centre(const Leaf& leaf) {
    return {2 * std::int64_t{leaf.lower_left.x} + leaf.side_cells(),
            2 * std::int64_t{leaf.lower_left.y} + leaf.side_cells()};
}

}  // namespace quadcut
