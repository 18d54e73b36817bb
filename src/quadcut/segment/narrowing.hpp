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
    /// How far the free space within 3 and 5 m lies from the saddle in the direction of the
    /// opening, root mean square: little in a corridor that goes straight on.
    std::array<double, 2> spread_m{};
    /// The length of the longest path; at most 5 m.
    double reach_m = 0.0;
    /// Of the whole region: its area, its largest clearance, and how many openings it has that a
    /// robot fits through. Only a RegionGraph knows them.
    double region_area_m2 = 0.0;
    double region_peak_m = 0.0;
    std::size_t num_openings = 0;
};

/// What tells a doorway from a bulge, measured at a saddle.
struct Narrowing {
    /// Half the width of the opening: the clearance of the saddle.
    double half_width_m = 0.0;
    /// The side with the smaller peak within 5 m, and the other one.
    SideOfSaddle narrower;
    SideOfSaddle wider;
    /// Whether the narrower side is that of the saddle's cell a.
    bool is_a_narrower = true;
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

/// Paths from a saddle end here, metres.
inline constexpr double kNarrowingReachM = 5.0;

/// Measures saddles; keeps its working memory (a window of 5 m around the saddle) between calls.
class NarrowingGauge {
public:
    /// `clearance_m` must outlive the gauge.
    NarrowingGauge(const Raster<float>& clearance_m, double resolution_m);

    /// Paths stay inside the region that they start in, and go in steps of 0.1 m whatever the
    /// resolution. O(area within 5 m).
    [[nodiscard]] Narrowing measure(const Saddle& saddle, const RegionsView& regions);

private:
    /// What a walk knows of a place, if it holds the walk's number.
    struct Place {
        std::uint32_t walk = 0;
        /// Of the shortest path so far, in fifths of a step; 0 where no path leads on.
        std::uint32_t length = 0;
        float clearance_m = 0.0F;
        /// How far it lies from the saddle along the opening, in steps.
        float aside = 0.0F;
    };

    SideOfSaddle walk_outward(Cell seed, const Direction& along, const RegionsView& regions);

    const Raster<float>& clearance_;
    double resolution_m_;
    std::int32_t stride_cells_;
    double step_m_;
    /// Of the window of places around the saddle; its rows are a power of two long.
    std::int32_t radius_;
    unsigned row_bits_;
    std::vector<Place> places_;
    std::uint32_t walk_ = 0;
    /// The places to visit by path length, in fifths of a step: 5 straight, 7 diagonal.
    std::vector<std::vector<std::uint32_t>> buckets_;
};

}  // namespace quadcut
