// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut::draw {

/// The cells, 1, that lie in a square of side_cells x side_cells set cells, 1 (a morphological
/// opening). What is outside of the raster counts as set. O(cells), whatever the side.
[[nodiscard]] Raster<std::uint8_t> find_thick_parts(const Raster<std::uint8_t>& mask,
                                                    std::int32_t side_cells,
                                                    const Executor& executor = {});

/// The cells, 1, around which a square of 2 * margin_cells + 1 cells a side is all set (an
/// erosion). What is outside of the raster counts as set. O(cells), whatever the margin.
[[nodiscard]] Raster<std::uint8_t> find_deep_parts(const Raster<std::uint8_t>& mask,
                                                   std::int32_t margin_cells,
                                                   const Executor& executor = {});

}  // namespace quadcut::draw
