// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/segment/result.hpp"
#include "quadcut/zones/covisibility.hpp"

namespace quadcut {

/// Floor of a room that a scan saw.
struct SeenFloor {
    /// As in Segmentation::labels: its place + 1.
    std::uint16_t label = 0;
    std::uint32_t num_cells = 0;
    friend bool operator==(const SeenFloor&, const SeenFloor&) = default;
};

/// What a scan saw of the rooms of a finished map.
struct Sighting {
    /// The sensor, metres in the map frame.
    Point at;
    /// The room that it stood in; 0: none.
    std::uint16_t own = 0;
    /// Labels ascending.
    std::vector<SeenFloor> floors;
};

/// The scans of a log, seen again once the rooms of their map are known. A cell is seen when it is
/// free by the scan alone (cells_of() in map/scan_cells.hpp) and belongs to a room. In order; the
/// same on any number of threads. O(cells in sight of each scan / 64 + their mixed tiles), memory
/// for what is returned: 40 bytes a scan and 8 a room in sight. Errors as evidence_of().
[[nodiscard]] std::vector<Sighting> sightings_of(const NextScan& next, const GridMap& map,
                                                 const Segmentation& rooms,
                                                 const IntegrateOptions& options = {},
                                                 const Executor& executor = {});

/// The labels of the rooms that a scan sees (is_seen), ascending.
[[nodiscard]] std::vector<std::uint16_t> labels_seen(const Sighting& sighting, const GridMap& map,
                                                     const Segmentation& rooms);

/// Scans counted by the ids of the rooms that they see, which ascend with their labels.
[[nodiscard]] Covisibility covisibility_of(std::span<const Sighting> sightings, const GridMap& map,
                                           const Segmentation& rooms);

}  // namespace quadcut
