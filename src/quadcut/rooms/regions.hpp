// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// Makes every region of `labels` (0 = none) one 4-connected whole: its largest part keeps the
/// label, every other part takes the label that it shares the longest border with. Parts that touch
/// no other label are removed. Regions that go on beyond the raster (by label) are connected there.
/// O(cells).
void connect_regions(Raster<std::uint32_t>& labels, const std::vector<bool>& goes_on = {},
                     const Executor& executor = {});

/// Removes regions that are nowhere `min_width_m` wide: no robot fits. Not those that go on beyond
/// the raster (by label). O(cells).
void drop_impassable(Raster<std::uint32_t>& labels, const Raster<float>& clearance_m,
                     double min_width_m, const std::vector<bool>& goes_on = {},
                     const Executor& executor = {});

/// A larger pocket, one region, with several regions around it: when these are one room it is no
/// room of its own.
struct Enclosure {
    std::uint32_t pocket = 0;
    std::vector<std::uint32_t> around;
};

struct Adoption {
    bool is_any = false;
    std::vector<Enclosure> enclosures;
};

/// Gives pockets to the room around them: connected free space, with or without a label, that may
/// be the free inside of a cupboard, bin or table that is drawn as an outline. They have at most
/// `max_pocket_m2` (small ones), or up to five times that. `states`: of the map. A small
/// pocket is given when at least a quarter of its border lies behind an outline at most 0.1 m thick
/// from one room, a larger one when three fifths do and no other room is behind the rest. The
/// outline between goes to that room, too, so that it stays connected; that of an enclosure goes to
/// the pocket. O(cells).
Adoption adopt_pockets(Raster<std::uint32_t>& labels, const Raster<CellState>& states,
                       double resolution_m, double max_pocket_m2, const Executor& executor = {});

/// Removes regions without a free cell: the furniture of a pocket that was adopted. O(cells).
void drop_without_floor(Raster<std::uint32_t>& labels, const Raster<CellState>& states,
                        const Executor& executor = {});

}  // namespace quadcut
