// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/map/raster.hpp"

namespace quadcut::io {

/// A raster's connected regions of equal values: each cell holds the number of its region, 1, 2,
/// ... in order of first cells (row by row from the lowest), or 0.
struct CellRegions {
    Raster<std::uint32_t> numbers;
    /// Region i + 1 has the value values[i] on num_cells[i] cells.
    std::vector<std::uint32_t> values;
    std::vector<std::size_t> num_cells;
};

/// Numbers the 4-connected regions; those of `diagonal_value` (0: none) are 8-connected. Cells of
/// value 0 belong to none. O(cells), in place. Throws std::logic_error when there would be 2^31
/// regions.
[[nodiscard]] CellRegions number_connected(Raster<std::uint32_t> values,
                                           std::uint32_t diagonal_value = 0);

}  // namespace quadcut::io
