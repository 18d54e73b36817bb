// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/follow/followed_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// The rooms with cells in a box, numbered; rasters from cell (0, 0) on.
struct RoomsInBox {
    /// 1 + the room's place in `rooms`; 0 = none. What stands in a locked room does not open its
    /// border.
    Raster<std::uint32_t> labels;
    /// Of the map.
    Raster<CellState> states;
    /// 1 = free, and a room's.
    Raster<std::uint8_t> free;
    /// By id.
    std::vector<std::uint32_t> rooms;
    /// In the box.
    std::vector<std::size_t> num_cells;
};

/// O(cells of the box).
[[nodiscard]] RoomsInBox rooms_in_box(const FollowedMap& followed, const Box& box);

}  // namespace quadcut
