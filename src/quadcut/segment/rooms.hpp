// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/fuse.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/region_graph.hpp"
#include "quadcut/segment/segmentation.hpp"

namespace quadcut {

/// What rooms are fused from; rasters of one rectangle.
struct RoomsInput {
    const Raster<std::uint32_t>& pieces;
    const Raster<float>& clearance_m;
    /// 1 = free in the map.
    const Raster<std::uint8_t>& free;
    double resolution_m = 0.05;
};

/// Where only a window of a map is cut anew.
struct Window {
    /// Cuts whose saddle lies outside are kept as they are.
    std::optional<Box> decided;
    /// Pieces that stand for rooms which go on beyond the window; by piece, nothing = none do.
    std::vector<bool> goes_on;
};

/// Fuses pieces unless a door is between them: first as far as at the highest granularity, of whose
/// regions all rooms are unions; there, small regions, slivers and pockets find their room. Labels
/// come out with regions of any number, the numbers of `regions`. With `hierarchy`: all levels,
/// too. O(cells + 5 m around each saddle, as often as what lies there changes).
[[nodiscard]] Raster<std::uint32_t> fuse_into_rooms(const RoomsInput& input,
                                                    const RoomsOptions& options,
                                                    const Window& window, const Executor& executor,
                                                    RegionGraph& regions,
                                                    Hierarchy* hierarchy = nullptr);

}  // namespace quadcut
