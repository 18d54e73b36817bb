// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// The catchment basins of the clearance: labels 1 .. count, 0 where the clearance is 0.
struct Basins {
    Raster<std::uint32_t> labels;
    std::uint32_t count = 0;
};

/// Follows the clearance uphill from every cell, to the steepest of its eight neighbours, after
/// smoothing it a little (sigma = 0.05 m) so that the ridges of a raster do not make basins of
/// their own. Each basin is 8-connected and has one summit; basins meet at the narrow places.
/// O(cells). Deterministic.
[[nodiscard]] Basins build_basins(const Raster<float>& clearance_m, double resolution_m,
                                  const Executor& executor = {});

}  // namespace quadcut
