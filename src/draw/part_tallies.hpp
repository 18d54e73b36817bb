// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut::draw {

/// The bounds of each part, as columns and rows of the raster; nothing at 0. O(runs).
[[nodiscard]] std::vector<Box> bounds_of(const ConnectedParts& parts);

/// What lies along the border of a 4-connected region. There may be as many as half the cells.
struct BorderTally {
    std::uint32_t num_cells = 0;
    std::uint32_t num_edges = 0;
    std::uint32_t num_room_edges = 0;
    std::uint32_t num_wall_edges = 0;
};

/// The borders of the 4-connected parts of a mask of `ground` that are `wanted`; nothing at 0.
/// O(cells of those). @pre no cell of the mask is of a room or a wall.
[[nodiscard]] std::vector<BorderTally> tally_borders(const Raster<std::uint16_t>& ground,
                                                     const Raster<std::uint8_t>& mask,
                                                     const ConnectedParts& parts,
                                                     const std::vector<bool>& wanted);

}  // namespace quadcut::draw
