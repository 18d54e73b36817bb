// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/map/raster.hpp"
#include "quadcut/map/room.hpp"
#include "quadcut/map/zone.hpp"
#include "quadcut/spectral/pieces.hpp"

namespace quadcut {

/// What a run did; written to report.json.
struct SegmentReport : CutReport {
    /// Wall time by stage, milliseconds, in order of first use.
    std::vector<std::pair<std::string, double>> stages_ms;
    std::vector<std::string> warnings;
};

/// A map cut into rooms. `labels` covers the map's cells: 0 = no room, otherwise the room is
/// rooms[label - 1], whatever its id. Every free cell that was kept has exactly one room; rooms are
/// connected (4-neighbours) and in the order of their ids. segment() gives the ids 1 .. n, track()
/// those of an earlier result.
struct Segmentation {
    Raster<std::uint16_t> labels;
    std::vector<Room> rooms;
    std::vector<Door> doors;
    /// No room of this map has ever had this id or a higher one.
    std::uint32_t next_id = 1;
    Hierarchy hierarchy;
    Zones zones;
    SegmentReport report;
};

}  // namespace quadcut
