// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/graph/graph.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/basins.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segmentation.hpp"

namespace quadcut {

/// The number of a graph's edges, without loops.
[[nodiscard]] std::size_t num_edges(const Graph& graph);

/// What is fused into rooms, as options.rooms.pieces has it: the basins of the clearance, or the
/// spectral over-cut of the quadtree's leaves, whose borders are moved to the basins' unless they
/// are to stay. Rasters of one rectangle from cell (0, 0) on. What was solved goes to the report.
[[nodiscard]] Basins find_pieces(Raster<std::uint8_t> open, const Raster<float>& clearance_m,
                                 double resolution_m, const SegmentOptions& options,
                                 StageClock& clock, const Executor& executor,
                                 SegmentReport& report);

}  // namespace quadcut
