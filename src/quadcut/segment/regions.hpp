// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/map/raster.hpp"

namespace quadcut {

/// Makes every region of `labels` (0 = none) one 4-connected whole: its largest part keeps the
/// label, every other part takes the label that it shares the longest border with. Parts that touch
/// no other label are removed. O(cells).
void connect_regions(Raster<std::uint32_t>& labels);

/// Removes regions that are nowhere `min_width_m` wide: no robot fits. O(cells).
void drop_impassable(Raster<std::uint32_t>& labels, const Raster<float>& clearance_m,
                     double min_width_m);

/// Gives free pockets that are too small to be rooms to the room around them: the free inside of a
/// cupboard, bin or table that is drawn as an outline. A pocket counts when at least a quarter of
/// its border lies behind an outline at most 0.1 m thick from one room, a larger one, up to five
/// times the size, when three fifths do and no other room is behind the rest. The outline between
/// goes to that room, too, so that it stays connected.
/// `free`: 1 = free in the map. Connected free space of at most `max_pocket_m2` is a pocket, with
/// or without a label, and so are free cells without a label. O(cells).
/// Returns whether any was given away.
bool adopt_pockets(Raster<std::uint32_t>& labels, const Raster<std::uint8_t>& free,
                   double resolution_m, double max_pocket_m2);

/// Removes regions without a free cell: the furniture of a pocket that was adopted. O(cells).
void drop_without_floor(Raster<std::uint32_t>& labels, const Raster<std::uint8_t>& free);

}  // namespace quadcut
