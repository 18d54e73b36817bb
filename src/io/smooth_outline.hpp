// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "io/outline.hpp"

namespace quadcut::io {

/// A point in units of half a cell: smoothing never needs finer ones.
struct HalfCell {
    std::int32_t x = 0;
    std::int32_t y = 0;
    friend bool operator==(const HalfCell&, const HalfCell&) = default;
};

/// A ring drawn as one would by hand: stairs that slanted walls leave on a grid become lines, true
/// corners stay. Within half a cell of the exact outline nearly everywhere, one cell at most.
/// The result along a border depends on the border alone, so regions that share one still share
/// it exactly: no gaps, no overlaps. O(n log n) for the usual outline. May fold a ring of a few
/// cells into fewer than three points.
[[nodiscard]] std::vector<HalfCell> smooth_ring(const OutlineRing& ring);

/// The length of a closed ring, in cells.
[[nodiscard]] double length_cells(const std::vector<HalfCell>& ring);

}  // namespace quadcut::io
