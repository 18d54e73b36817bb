// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "sim/building.hpp"
#include "sim/robot.hpp"

namespace quadcut::sim {

/// The true room of each free cell of a map that a robot has made; 0 outdoors, in walls and
/// furniture that the map shows as free, and in rooms of which next to nothing was seen: less than
/// 1.5 m2, or than a tenth.
///
/// The map is bent as the robot's poses were wrong: a cell is looked up where it truly lies by the
/// scan that was taken nearest to it over free cells. O(cells + scans). @pre there is a scan.
[[nodiscard]] Raster<std::uint32_t> surveyed_truth(const Building& building,
                                                   const Exploration& exploration,
                                                   const GridMap& map);

}  // namespace quadcut::sim
