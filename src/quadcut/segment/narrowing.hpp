// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "quadcut/map/raster.hpp"

namespace quadcut {

/// Where two regions meet at their widest: the pair of touching cells, one in each region, whose
/// smaller clearance is the largest of the common border.
struct Saddle {
    Cell a;
    Cell b;
    float clearance_m = 0.0F;
};

/// What tells a doorway from a bulge, measured at a saddle of half-width h (its clearance).
struct Narrowing {
    /// ln(largest clearance / h) on the narrower side, within 5 m of the saddle; 0 .. ln 1.6.
    double narrower_side = 0.0;
    /// The same on the wider side, within 3 m; 0 .. ln 2.2.
    double wider_side = 0.0;
    /// How far the narrower side reaches from the saddle, in opening widths (2 h); at most 4.
    double depth = 0.0;
    /// Length of thin wall behind both jambs: obstacle with free space on both faces, 0 .. 0.8 m.
    double jamb_m = 0.0;
    /// Length of wall flush with the opening on one side, at the shorter end, 0 .. 0.5 m.
    double flush_m = 0.0;
    /// The obstacle points on both sides of the opening, in cells (centres at + 0.5).
    std::array<Cell, 2> jambs{};
    bool has_jambs = false;
};

/// Measures a saddle between regions. `region_of(offset)` names the region of a cell of
/// `clearance_m`; paths stay inside the region that they start in. O(cells within 5 m).
[[nodiscard]] Narrowing measure_narrowing(
    const Raster<float>& clearance_m, double resolution_m, const Saddle& saddle,
    const std::function<std::uint32_t(std::size_t offset)>& region_of);

/// How clearly a narrowing is a door: the logarithm of the odds. Positive: keep the cut.
[[nodiscard]] double door_log_odds(const Narrowing& narrowing);

}  // namespace quadcut
