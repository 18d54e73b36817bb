// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/map/raster.hpp"

namespace quadcut {

/// What is known of a cell. Unknown blocks sight and passage like an obstacle, but is none.
enum class CellState : std::uint8_t { unknown = 0, free = 1, occupied = 2 };

/// A finished map as a plain image of states: what a map file holds.
/// `map_from_image` is the pose of the lower left corner of cell (0, 0) in the map frame; with a
/// yaw, the image is turned about that corner.
struct GridMap {
    double resolution_m = 0.05;
    Pose map_from_image;
    Raster<CellState> states;
};

}  // namespace quadcut
