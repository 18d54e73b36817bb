// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/bit_raster.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut {

/// What one beam saw. Lengths in cells.
struct Beam {
    Point direction;     ///< unit vector in the map
    double range = 0.0;  ///< up to where it is used; 0 when it says nothing
    double reach = 0.0;  ///< up to where it saw free space
    bool hits = false;   ///< something stands at `range`
};

/// The beams of a scan whose sensor has the given yaw in the map. Invalid readings and those
/// without a return say nothing. Throws InputError when the usable range is no positive number of
/// cells or more than 8192.
[[nodiscard]] std::vector<Beam> beams_of(const Scan& scan, double sensor_yaw_rad,
                                         double resolution_m, const IntegrateOptions& options);

/// What one scan says about the cells around the sensor; of the rest it says nothing.
struct ScanCells {
    BitRaster free;
    BitRaster hit;  ///< cells with an end point; these may be in `free` as well
};

/// Classifies cells against beams that start at `sensor`, in cells, `angle_step_rad` apart.
///
/// Between neighbouring beams the cells whose centres are nearer than both of their reaches are
/// free; beyond, a beam clears the cells that it crosses. So what lies behind the nearer of two end
/// points is cleared by nothing but the beam that went there.
/// O(beams + cells on the outline + cells of the bounding box / 64).
/// @pre the sensor is within 2^28 cells and no beam is longer than 2^13.
[[nodiscard]] ScanCells cells_of(const std::vector<Beam>& beams, const Point& sensor,
                                 double angle_step_rad);

}  // namespace quadcut
