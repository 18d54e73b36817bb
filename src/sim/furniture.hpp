// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/base/random.hpp"
#include "quadcut/map/raster.hpp"
#include "sim/plan.hpp"

namespace quadcut::sim {

/// One thing that a laser near the floor sees: a box or a round post.
struct Obstacle {
    Polygon box;
    Point center;
    /// Of a post; its box is empty.
    double radius_m = 0.0;
};

struct FurnitureOptions {
    /// 0: empty, 1: every place is taken.
    double density = 0.5;
    /// The share of doors whose leaf stands open.
    double open_leaves = 0.3;
    /// 0: as architects draw it, 1: as people leave it.
    double clutter = 0.0;
};

/// Furniture and open door leaves of a room, in the plan's frame.
///
/// Everything is placed as at density 1 and then thinned out, so that a higher density only adds.
/// No piece stands in a doorway, and at any density a robot of 0.25 m radius gets to every place
/// of the room that it could reach without furniture, save pockets under and between pieces.
/// With clutter there is more of it, and no regard for the robot's ways: see clutter.hpp.
/// `labels` (of the bare building) and `grid` say where the room's floor is.
[[nodiscard]] std::vector<Obstacle> furnish(const Plan& plan, std::size_t room,
                                            const FurnitureOptions& options,
                                            const Raster<std::uint16_t>& labels,
                                            const CellGrid& grid, Random random);

}  // namespace quadcut::sim
