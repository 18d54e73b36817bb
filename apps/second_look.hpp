// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "io/scan_source.hpp"
#include "quadcut/base/run_options.hpp"
#include "quadcut/zones/sightings.hpp"

namespace quadcut {

/// What all scans of a source see of the rooms of their map, which are known only when it is made:
/// they are read once more.
[[nodiscard]] std::vector<Sighting> look_again(io::ScanSource& source, const GridMap& map,
                                               const Segmentation& rooms,
                                               const IntegrateOptions& options,
                                               const RunOptions& run);

}  // namespace quadcut
