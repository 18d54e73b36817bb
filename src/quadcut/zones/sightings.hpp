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

/// A scan sees a room when it sees so much of its floor, or half of it if that is less: what comes
/// through the gap of a door, or beside a wall that a robot's pose is wrong about, is no sight of
/// it.
inline constexpr double kLeastSeenM2 = 1.0;

[[nodiscard]] constexpr bool is_seen(double seen_m2, double room_m2) {
    return seen_m2 > 0.0 && (seen_m2 >= kLeastSeenM2 || seen_m2 >= room_m2 / 2.0);
}

/// What a scan saw of the rooms of a finished map.
struct Sighting {
    /// The sensor, metres in the map frame.
    Point at;
    /// The label that it stood on; 0: none.
    std::uint32_t own = 0;
    /// By label (Segmentation::labels), ascending.
    std::vector<SeenFloor> floors;
};

/// The scans of a log, seen again once the rooms of their map are known. A cell is seen when it is
/// free by the scan alone (cells_of() in map/scan_cells.hpp), has no end point and belongs to a
/// room. In order; the same on any number of threads. O(cells in sight of each scan / 64 + their
/// mixed tiles), memory for what is returned: 40 bytes a scan and 8 a room in sight. Errors as
/// evidence_of().
[[nodiscard]] std::vector<Sighting> sightings_of(const NextScan& next, const GridMap& map,
                                                 const Segmentation& rooms,
                                                 const IntegrateOptions& options = {},
                                                 const Executor& executor = {});

/// The labels of the rooms that a scan sees (is_seen), ascending.
[[nodiscard]] std::vector<std::uint32_t> labels_seen(const Sighting& sighting, const GridMap& map,
                                                     const Segmentation& rooms);

/// By the ids of the rooms.
[[nodiscard]] Covisibility covisibility_of(std::span<const Sighting> sightings,
                                           const Segmentation& rooms);

}  // namespace quadcut
