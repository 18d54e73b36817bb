// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "quadcut/map/occupancy_map.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut {

/// What a scan does to the map.
struct IntegrateOptions {
    double usable_range_m = 30.0;  ///< longer readings clear that far and hit nothing
    double widest_gap_m = 0.2;     ///< the space between two beams is seen while it is no wider
    double margin_cells = 1.0;     ///< how far before an end point a beam stops to clear
    int hit = 3;                   ///< added to the log-odds of a cell with an end point
    int miss = -1;                 ///< added where the scan saw free space
};

/// One hit marks and one miss clears, as in the paper (READING.md item 20).
[[nodiscard]] IntegrateOptions latest_scan_wins();

/// Adds a scan to the map: one miss for each cell in its free sector, one hit for each cell with an
/// end point; the hit wins. cells_of() says what the free sector is.
/// O(cells of the bounding box / 64 + tiles that change).
/// Throws InputError when the scan's pose is not finite or beyond the map's limits, or the
/// resolution is finer than usable_range_m / 8192; the map is then unchanged.
MapUpdate integrate_scan(OccupancyMap& map, const Scan& scan, const IntegrateOptions& options = {});

/// Called after each scan with how many are done.
using ScanProgress = std::function<void(std::size_t num_done)>;

/// The map of a whole log: the same as integrate_scan one by one. Errors name the scan, from 0 on.
[[nodiscard]] OccupancyMap map_from_scans(std::span<const Scan> scans, double resolution_m,
                                          const IntegrateOptions& options = {},
                                          const ScanProgress& progress = {});

}  // namespace quadcut
