// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>

#include "quadcut/map/raster.hpp"
#include "quadcut/map/room.hpp"
#include "quadcut/rooms/fuse.hpp"
#include "quadcut/rooms/region_graph.hpp"

namespace quadcut {

/// Fuses regions below the log-odds, as the fuser does, but not into fewer than `least` of those
/// that `labels` hold. O(joins * regions) beside the fuser's own.
void fuse_to_number(Fuser& fuser, const RegionGraph& regions, const Raster<std::uint32_t>& labels,
                    std::span<const Enclosure> enclosures, double min_log_odds, std::size_t least);

/// The levels of granularity 0, 0.1 .. 1, each with the highest one that has the same regions, from
/// regions that are fused as far as the highest one fuses; `labels` holds their numbers, each
/// cell's region. The graph is a copy to go on with. Positions are those of `labels`. Throws
/// InputError when there are more than 65535 regions. O(cells, and what fusing costs).
[[nodiscard]] Hierarchy build_hierarchy(const Raster<std::uint32_t>& labels, RegionGraph regions,
                                        double max_width_m,
                                        std::span<const Enclosure> enclosures = {},
                                        EarlierDecisions earlier = {});

/// What `rooms` have of a region of the finest level becomes a region of its own where several have
/// some, so that every room is a union of regions again; coarser levels stay as they are. O(cells).
void keep_nested(Hierarchy& hierarchy, const Raster<std::uint32_t>& rooms);

}  // namespace quadcut
