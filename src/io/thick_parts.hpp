// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/map/raster.hpp"

namespace quadcut::io {

/// The cells that lie in a square of side_cells x side_cells set cells (a morphological opening).
/// What is outside of the raster counts as set. O(cells), whatever the side.
[[nodiscard]] Raster<std::uint8_t> find_thick_parts(const Raster<std::uint8_t>& mask,
                                                    std::int32_t side_cells);

/// The cells around which a square of 2 * margin_cells + 1 cells a side is all set (an erosion).
/// What is outside of the raster counts as set. O(cells), whatever the margin.
[[nodiscard]] Raster<std::uint8_t> find_deep_parts(const Raster<std::uint8_t>& mask,
                                                   std::int32_t margin_cells);

}  // namespace quadcut::io
