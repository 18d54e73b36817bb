// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/map/raster.hpp"
#include "quadcut/segment/opening.hpp"

namespace quadcut {

/// What lies on one side of a saddle, measured along paths inside the region of that side.
struct SideOfSaddle {
    /// The largest clearance within 1.5, 3 and 5 m of the saddle, metres.
    std::array<double, 3> peak_m{};
    /// The free area within 3 and 5 m.
    std::array<double, 2> area_m2{};
    /// The length of the longest path; at most 5 m.
    double reach_m = 0.0;
};

/// What tells a doorway from a bulge, measured at a saddle.
struct Narrowing {
    /// Half the width of the opening: the clearance of the saddle.
    double half_width_m = 0.0;
    /// The side with the smaller peak within 5 m, and the other one.
    SideOfSaddle narrower;
    SideOfSaddle wider;
    /// The length of the border between the two regions, over the width of the opening.
    double border_ratio = 0.0;
    Opening opening;
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
    SideOfSaddle walk_outward(Cell seed, const RegionsView& regions);

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

}  // namespace quadcut
