// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/wall_lines.hpp"

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

/// Cuts basins where walls would go on: each connected part that is left has a label of its own,
/// the cells of the lines have none. Returns the number of labels. O(cells).
std::uint32_t split_at_lines(const WallLines& lines, Raster<std::uint32_t>& labels,
                             const Executor& executor = {});

/// Gives the cells of `open` that have no label that of the nearest one, step by step: what stands
/// on the floor belongs to what is around it. O(cells).
void spread_labels(const Raster<std::uint8_t>& open, Raster<std::uint32_t>& labels);

}  // namespace quadcut
