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

}  // namespace quadcut::io
