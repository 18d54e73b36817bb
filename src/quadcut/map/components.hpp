// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// The connected parts (4 neighbours) of the free space. There may be as many as half the cells.
/// O(cells).
[[nodiscard]] ConnectedParts free_parts(const Raster<CellState>& states,
                                        const Executor& executor = {});

/// The part that covers more than half of the raster's border, if there is one and the others
/// together have at least a twentieth of its cells: the ground around a building. Otherwise it is
/// the building itself, in a map with leaky walls or a tight frame, and the answer is 0. Parts of
/// fewer than `min_cells` do not count as something else. O(runs).
[[nodiscard]] std::uint32_t find_outside(const ConnectedParts& free, std::size_t min_cells);

}  // namespace quadcut
