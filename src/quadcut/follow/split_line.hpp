// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/follow/edit.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// Where a room can be cut in two by a straight line.
struct SplitPlan {
    /// From wall to wall, and a little into the walls; nothing when the room cannot be cut there.
    std::optional<SplitLine> line;
    /// The smaller part.
    std::vector<Cell> part;
    /// Why not.
    std::string reason;
};

/// The cells of a line, each beside the next.
[[nodiscard]] std::vector<Cell> cells_of(const SplitLine& line);

/// Cuts the room (1 in `room`) between two points, in cells: the line is drawn on to the walls, if
/// they are within a metre, and has to leave two parts of 4 m^2 at least. Walls that it crosses are
/// part of it; or else it is what lies between two walls. O(cells of the room).
[[nodiscard]] SplitPlan plan_split(const Raster<std::uint8_t>& room, const Point& from,
                                   const Point& to, double resolution_m);

/// The nearest line between the middles of two cells, within 3 m, where plan_split() cuts the room;
/// nothing when there is none. O(cells of the room) for each of at most some thousand places.
[[nodiscard]] std::optional<SplitLine> nearest_split(const Raster<std::uint8_t>& room,
                                                     const Point& from, const Point& to,
                                                     double resolution_m);

}  // namespace quadcut
