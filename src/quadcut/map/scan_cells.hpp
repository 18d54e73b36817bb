// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/bit_raster.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut {

/// What one beam saw. Lengths in cells.
struct Beam {
    Point direction;     ///< unit vector in the map
    double range = 0.0;  ///< up to where it is used; 0 when it says nothing
    double reach = 0.0;  ///< up to where it saw free space
    bool hits = false;   ///< something stands at `range`
};

/// How far beams are used, in cells.
struct BeamLimits {
    double usable_range = 600.0;  ///< longer readings clear that far and hit nothing
    double widest_gap = 4.0;      ///< and no further than where neighbours are this far apart
    double margin = 1.0;          ///< how far before its end point a beam stops to clear
};

/// The beams of a scan whose sensor has the given yaw in the map. Invalid readings and those
/// without a return say nothing.
[[nodiscard]] std::vector<Beam> beams_of(const Scan& scan, double sensor_yaw_rad,
                                         double resolution_m, const BeamLimits& limits);

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
