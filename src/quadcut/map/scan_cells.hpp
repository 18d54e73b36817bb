// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/bit_raster.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut {

/// What one scan says about the cells around the sensor; the rest it says nothing about.
struct ScanCells {
    BitRaster free;
    BitRaster hit;  ///< cells with an end point; these may be in `free` as well
};

/// How a scan is turned into cells. Lengths in cells.
struct SightModel {
    double usable_range = 600.0;  ///< longer readings clear that far and hit nothing
    double widest_gap = 4.0;      ///< the space between two beams is seen while it is no wider
    double margin = 1.0;          ///< how far before an end point a beam stops to clear
};

/// Classifies cells against a scan. `map_from_sensor` in cells and radians; of the scan, only its
/// beams are used, divided by `resolution_m`.
///
/// Between neighbouring beams the cells whose centres are nearer than both readings (less the
/// margin) are free, as long as the beams are no more than `widest_gap` apart; beyond, each beam
/// clears the cells that it crosses. So nothing behind the nearer of two readings is cleared but
/// by the beam that went there. Beams without a return and invalid ones clear nothing.
/// O(beams + cells on the outline + cells of the bounding box / 64).
/// @pre usable_range <= 8192 and the pose is within 2^28 cells.
[[nodiscard]] ScanCells cells_of(const Scan& scan, double resolution_m, const Pose& map_from_sensor,
                                 const SightModel& model);

}  // namespace quadcut
