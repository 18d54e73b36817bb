// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// Walls in one direction: stretches of bands across it, in cells.
struct WallsAlong {
    struct Stretch {
        double begin = 0.0;
        double end = 0.0;
    };
    Point along{1.0, 0.0};
    double step_cells = 1.0;
    std::int32_t lowest = 0;
    /// By band from the lowest one on; ascending.
    std::vector<std::vector<Stretch>> bands;

    [[nodiscard]] bool contains(const Point& at) const;
};

/// Walls, and where they would go on: a free cell that lies in line with a wall, in a gap of it.
struct WallLines {
    std::vector<WallsAlong> walls;
    /// The walls at both ends of the gap, decimetres, at most 25 m; 0 off all lines. A wall that
    /// goes up to another one that crosses it has nothing at that end.
    Raster<std::uint8_t> less_dm;
    Raster<std::uint8_t> more_dm;

    /// Whether an obstacle at this place, in cells, is a piece of a wall.
    [[nodiscard]] bool is_wall(const Point& at) const;
};

/// The directions of a building, radians in 0 .. pi / 2, the strongest first: those in which the
/// surfaces of obstacles project onto the fewest lines, or onto lines orthogonal to these. At most
/// four. `free`: 1 = free. O(cells + 8000 * 90).
[[nodiscard]] std::vector<double> main_directions(const Raster<std::uint8_t>& free,
                                                  double resolution_m);

/// Walls in these directions: aligned surfaces of obstacles, however small each is, that no robot
/// fits between. A wall goes on across a gap of at most `max_gap_m`, up to whatever is next.
/// O(cells + surfaces log surfaces).
[[nodiscard]] WallLines find_wall_lines(const Raster<std::uint8_t>& free, double resolution_m,
                                        double max_gap_m, const Executor& executor = {});

}  // namespace quadcut
