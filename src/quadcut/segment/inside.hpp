// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// 1 where the map has the given state.
[[nodiscard]] Raster<std::uint8_t> mask_of(const GridMap& map, CellState state);

/// The cells of the map that a trajectory (metres, map frame) touches, in order; points outside the
/// map are left out.
[[nodiscard]] std::vector<Cell> visited_cells(const GridMap& map,
                                              std::span<const Point> trajectory);

/// Labels that none of the cells has become 0; nothing is done without cells.
void drop_uncrossed(Raster<std::uint32_t>& labels, std::span<const Cell> way);

/// The part that covers more than half of the raster's border, if there is one and the others
/// together have at least a twentieth of its cells: the ground around a building. Otherwise it is
/// the building itself, in a map with leaky walls or a tight frame, and the answer is 0. Parts of
/// fewer than `min_cells` do not count as something else. O(runs).
[[nodiscard]] std::uint32_t find_outside(const ConnectedParts& free, std::size_t min_cells);

/// The free space to be cut, 1 = inside: connected free cells (4 neighbours) of at least
/// `min_area_m2` together. A component that covers more than half of the image's border is the
/// ground outside and left out, unless the trajectory enters it, or nothing else is left. O(cells).
[[nodiscard]] Raster<std::uint8_t> inside(const GridMap& map, std::span<const Point> trajectory,
                                          double min_area_m2, const Executor& executor = {});

/// The ground outside once more, when it is cut from the building in which an open door leads:
/// along the border of the map, `box`, more than half of it, there is nothing but floor. The
/// regions there become 0, but where the robot was, and if the others have at least a twentieth of
/// their cells. `labels` and `way` are laid out. O(cells).
void drop_outside(Raster<std::uint32_t>& labels, const Layout& layout, const Box& box,
                  std::span<const Cell> way);

}  // namespace quadcut
