// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

namespace quadcut {

struct OptionField;

/// What a scan does to the map.
struct IntegrateOptions {
    double usable_range_m = 30.0;   ///< longer readings clear that far and hit nothing
    double widest_gap_m = 0.2;      ///< and no further than where beams are this far apart
    double margin_cells = 1.0;      ///< how far before its end point a beam stops to clear
    double trusted_range_m = 2.5;   ///< up to here, a scan is believed against sure walls
    double wall_tolerance_m = 0.3;  ///< an end point so far behind a sure wall still is the wall
    int sure = 6;                   ///< log-odds from which on the map is sure of a wall
    int hit = 3;                    ///< added to the log-odds of a cell with an end point
    int miss = -1;                  ///< added where the scan saw free space
};

/// Adds the options of scans, bound to the members of `options`, which must outlive the list.
void add_fields(IntegrateOptions& options, std::vector<OptionField>& fields);

/// One hit marks and one miss clears, as in the paper's "Dynamic construction of quadtree"; the
/// rest as it was.
[[nodiscard]] IntegrateOptions latest_scan_wins(IntegrateOptions options = {});

}  // namespace quadcut
