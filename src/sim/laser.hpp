// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut::sim {

/// A planar laser range finder. The defaults are those of the paper's robot.
struct LaserOptions {
    double field_of_view_rad = 1.5 * 3.14159265358979323846;
    double angle_step_rad = 0.25 * 3.14159265358979323846 / 180.0;
    double max_range_m = 30.0;
    /// Standard deviation of a range.
    double range_noise_m = 0.01;
    /// How often a beam returns nothing although something is in range.
    double dropout = 0.005;

    [[nodiscard]] int num_beams() const;
};

/// Casts rays on a grid. Occupied cells stop a ray; unknown cells do not, and beyond the map there
/// is nothing.
class RayCaster {
public:
    /// O(cells), one byte a cell.
    explicit RayCaster(const GridMap& world);

    /// The distance from `from` (map frame) to the border of the first occupied cell on the ray,
    /// exact to rounding; `max_range_m` when there is none within it. 0 inside an occupied cell.
    /// About fifteen steps: each crosses the largest empty square around a cell.
    [[nodiscard]] double cast(const Point& from, double angle_rad, double max_range_m) const;

private:
    double resolution_m_;
    Pose image_from_map_;
    // Chessboard distance to the nearest occupied cell, at most 255; 0 in occupied cells.
    Raster<std::uint8_t> reach_;
};

/// One sweep at a pose. A beam without a return has max_range_m. About 0.1 ms for 1081 beams.
[[nodiscard]] Scan simulate_scan(const RayCaster& world, const Pose& world_from_sensor,
                                 const LaserOptions& options, Random& random);

}  // namespace quadcut::sim
