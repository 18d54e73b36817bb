// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut::io {

/// A point on the outline of a region: the lower left corner of cell (x, y).
struct OutlinePoint {
    std::int32_t x = 0;
    std::int32_t y = 0;
    /// Three or more regions (0 counts as one) meet here: where shared borders begin and end.
    bool is_junction = false;
    friend bool operator==(const OutlinePoint&, const OutlinePoint&) = default;
};

/// A closed line along cell edges, the region on its left; the first point is not repeated. Holds
/// every turn, and the junctions that lie on straight runs.
using OutlineRing = std::vector<OutlinePoint>;

/// A 4-connected region of cells of one value. rings[0] runs around it counter-clockwise, the
/// others run clockwise around its holes. No ring meets itself; two rings may touch in a point.
/// (With a diagonal value, both may.)
struct RegionOutline {
    std::uint32_t value = 0;
    std::size_t num_cells = 0;
    std::vector<OutlineRing> rings;
};

/// Traces the 4-connected regions of equal values, in order of their first cell (row by row from
/// the lowest). Cells of value 0 belong to none. O(cells), with an eighth of a byte a cell and 12
/// bytes a run of cells. Points are in the raster's cell coordinates.
/// Cells of `diagonal_value` (0: none) are joined where only their corners meet, too, and part
/// what lies on either side: thin slanted walls.
[[nodiscard]] std::vector<RegionOutline> trace_outlines(const Raster<std::uint16_t>& values,
                                                        std::uint32_t diagonal_value = 0,
                                                        const Executor& executor = {});
[[nodiscard]] std::vector<RegionOutline> trace_outlines(const Raster<std::uint8_t>& values,
                                                        std::uint32_t diagonal_value = 0,
                                                        const Executor& executor = {});

/// The turns of a ring only: its exact polygon, without straight junctions.
[[nodiscard]] std::vector<Cell> corners_of(const OutlineRing& ring);

}  // namespace quadcut::io
