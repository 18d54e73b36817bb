// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "sim/building.hpp"
#include "sim/robot.hpp"

namespace quadcut::sim {

/// A building as people use it and as a robot finds it.
struct RealityOptions {
    std::uint64_t seed = 1;
    /// As of BuildingOptions.
    int num_rooms = 20;
    double resolution_m = 0.05;
    /// 0: tidy, doors open, no glass, everything visited; 1: as real maps look.
    double clutter = 1.0;
};

/// What the robot has brought home. The building is in its own truth: rooms are those of its
/// architect whatever stands in them.
struct RealMap {
    BuildingOptions building_options;
    Building building;
    /// Scans with the poses that a SLAM system reports, and the true ones.
    Exploration exploration;
    GridMap map;
    /// The room of each free cell of `map`; 0 outdoors and in rooms of which next to nothing was
    /// seen.
    Raster<std::uint32_t> truth;
    /// Where the robot says that it has been.
    std::vector<Point> trajectory;
};

/// Draws a building, lets people move in and a robot through: the corridors and some of the rooms,
/// once. Laser, mapping, people, glass and doors differ from seed to seed. The same options give
/// the same bytes. Throws InputError as generate_building(). About 1 s for 20 rooms.
[[nodiscard]] RealMap scan_as_robots_do(const RealityOptions& options);

}  // namespace quadcut::sim
