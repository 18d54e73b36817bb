// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "sim/building.hpp"

namespace quadcut::sim {

/// Shares, 0..1 each.
struct WorldOptions {
    std::uint64_t seed = 1;
    /// Of the doors with a leaf.
    double closed_doors = 0.0;
    double doors_ajar = 0.0;
    /// Of the outer walls, and of the walls between corridors and rooms.
    double windows = 0.0;
    double glass_walls = 0.0;
};

/// What a laser meets in a building and around it: beside walls and furniture closed doors, glass,
/// and behind the windows trees, cars and the house across the street. In the map frame of the
/// building, with 12 m of ground around it.
struct World {
    /// Glass is occupied.
    GridMap map;
    /// 0: no glass, else one more than the direction of its normal, degrees in 0..179; kThin: a leg
    /// of furniture, which fills a part of its cell.
    Raster<std::uint8_t> glass;
    static constexpr std::uint8_t kThin = 255;
};

/// The same building and options give the same bytes.
[[nodiscard]] World draw_world(const Building& building, const WorldOptions& options);

}  // namespace quadcut::sim
