// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/parallel.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/basins.hpp"
#include "quadcut/rooms/options.hpp"
#include "quadcut/spectral/pieces.hpp"

namespace quadcut {

/// What is fused into rooms, as options.pieces has it: the basins of the clearance, or the
/// spectral over-cut of the quadtree's leaves, whose borders are moved to the basins' unless they
/// are to stay. Rasters of one rectangle from cell (0, 0) on. What was solved goes to the report.
[[nodiscard]] Basins find_pieces(Raster<std::uint8_t> open, const Raster<float>& clearance_m,
                                 double resolution_m, const RoomsOptions& options,
                                 std::uint64_t seed, StageClock& clock, const Executor& executor,
                                 CutReport& report);

}  // namespace quadcut
