// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

/// Renumbers regions 1 .. count by their first cells on the page, from the upper left, however the
/// raster is laid out; without gaps. Returns the new count. O(cells).
std::uint32_t number_by_first_cells(Raster<std::uint32_t>& labels, const Layout& layout,
                                    const Executor& executor = {});

/// Renumbers rooms, and with them labels and doors, as one reads the page on which the map's image
/// is: row by row from the top, from left to right, rooms before glimpses. Rooms get their default
/// names. O(cells).
void number_in_reading_order(Segmentation& result, const GridMap& map,
                             const Executor& executor = {});

}  // namespace quadcut
