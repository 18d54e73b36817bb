// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <optional>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// By how many cells the rooms of an earlier result (0 = none) have to be moved to lie on the free
/// cells of a map of the same resolution and direction: for images that have grown to the left or
/// downwards and still say that they begin at the same place. Found by the floor that is free again
/// and the border around it that is none again; nothing where no place fits well.
/// O(2^14 places x cells of 2^13), and the cells.
[[nodiscard]] std::optional<Cell> find_shift(const Raster<std::uint16_t>& earlier,
                                             const Raster<CellState>& states);

}  // namespace quadcut
