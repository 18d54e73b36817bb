// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

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

/// Which region each cell is in: pieces that have been joined into regions.
struct RegionsView {
    const Raster<std::uint32_t>& pieces;
    /// The region of each piece; 0 = none.
    std::span<const std::uint32_t> region_of_piece;

    [[nodiscard]] std::uint32_t region_at(std::size_t offset) const {
        return region_of_piece[pieces.values[offset]];
    }
};

/// Measures saddles; keeps its working memory (a window of 5 m around the saddle) between calls.
class NarrowingGauge {
public:
    /// `clearance_m` must outlive the gauge.
    NarrowingGauge(const Raster<float>& clearance_m, double resolution_m);

    /// Paths stay inside the region that they start in. O(cells within 5 m).
    [[nodiscard]] Narrowing measure(const Saddle& saddle, const RegionsView& regions);

private:
    /// What lies on one side of a saddle.
    struct Side {
        double peak_near_m = 0.0;
        double peak_far_m = 0.0;
        double reach_m = 0.0;
    };

    Side walk_outward(Cell seed, double half_width_m, const RegionsView& regions);
    void visit(Cell cell, std::size_t steps, Cell seed, std::uint32_t region,
               const RegionsView& regions, Side& side);

    const Raster<float>& clearance_;
    double resolution_m_;
    /// Path lengths count in fifths of a cell: 5 straight, 7 diagonal.
    double unit_m_;
    std::int32_t radius_;
    std::size_t side_;
    /// A cell of the window has been seen in this walk when it holds the walk's number.
    std::vector<std::uint32_t> seen_;
    std::uint32_t walk_ = 0;
    std::vector<std::vector<Cell>> buckets_;
};

/// How clearly a narrowing is a door: the logarithm of the odds. Positive: keep the cut.
[[nodiscard]] double door_log_odds(const Narrowing& narrowing);

}  // namespace quadcut
