// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

/// The square that the quadtree divides: 2^level x 2^level cells from `lower_left` on. Every block
/// inside is aligned relative to cell (0, 0), so a root that grows moves none of them.
struct Root {
    Cell lower_left;
    std::uint8_t level = 0;

    [[nodiscard]] std::int32_t side_cells() const { return std::int32_t{1} << level; }
    /// Where the block of side 2^block_level that holds a cell lies, counted in such blocks from
    /// `lower_left`.
    [[nodiscard]] Cell position(int block_level, Cell cell) const {
        return {(cell.x - lower_left.x) >> block_level, (cell.y - lower_left.y) >> block_level};
    }
    /// The block at such a position.
    [[nodiscard]] Root block(int block_level, Cell position) const {
        return {{lower_left.x + (position.x << block_level),
                 lower_left.y + (position.y << block_level)},
                static_cast<std::uint8_t>(block_level)};
    }
    friend bool operator==(const Root&, const Root&) = default;
};

}  // namespace quadcut
