// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <vector>

#include "io/scan_source.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/integrate.hpp"

namespace quadcut::io {

/// A map made of scans.
struct ScannedMap {
    GridMap map;
    /// Where the laser was at each scan, metres in the map frame.
    std::vector<Point> trajectory;
    std::size_t num_leaves = 0;
};

/// Maps what is left of a source. Throws InputError when nothing comes of it.
[[nodiscard]] ScannedMap map_scans(ScanSource& source, double resolution_m,
                                   const IntegrateOptions& integrate,
                                   const ScanProgress& progress = {});

}  // namespace quadcut::io
