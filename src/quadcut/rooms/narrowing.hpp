// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/opening.hpp"

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
    /// The share of the border in gaps of walls' lines, and the walls at their ends, on the mean.
    double share_in_line = 0.0;
    double less_wall_m = 0.0;
    double more_wall_m = 0.0;
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

/// Obstacles are judged twice: among walls alone, where furniture is open, and among all of them.
enum class Among : std::uint8_t { walls, all };

/// What a walk inside a region from one of its cells came by, in both clearances. All zero where
/// the cell belongs to no region.
struct WalkedSide {
    /// What lies up to a length of path; sums over the distances from the seed, in steps.
    struct Within {
        /// Among walls, among all.
        std::array<float, 2> peak_m{};
        std::int64_t count = 0;
        std::int64_t sum_xx = 0;
        std::int64_t sum_xy = 0;
        std::int64_t sum_yy = 0;
    };
    /// 1.5, 3 and 5 m.
    std::array<Within, 3> within{};
    double step_m = 0.0;
    double reach_m = 0.0;
    /// The other regions that the walk came up against, each once: as long as none of them becomes
    /// a part of the region walked in, the walk stays as it is.
    std::vector<std::uint32_t> met;
};

/// What a walk says of a saddle with an opening that runs `along`.
[[nodiscard]] SideOfSaddle side_of(const WalkedSide& walked, Among obstacles,
                                   const Direction& along);

/// Walks out from saddles; keeps its working memory (a window of 5 m around) between calls.
class NarrowingGauge {
public:
    /// The clearances among walls and among all obstacles, which must outlive the gauge.
    NarrowingGauge(const Raster<float>& clearance_m, const Raster<float>& free_clearance_m,
                   double resolution_m);

    /// What lies on the side of a saddle's cell `seed`. Paths stay inside the seed's region, and go
    /// in steps of 0.1 m whatever the resolution. O(area within 5 m).
    [[nodiscard]] WalkedSide walk_outward(Cell seed, const RegionsView& regions);

private:
    /// A place of the window around the seed, and the direction of the last step to it.
    struct Reached {
        std::uint16_t place = 0;
        std::uint16_t way = 0;
    };
    /// A way on from a settled place.
    struct Start {
        unsigned length = 0;
        unsigned place = 0;
        unsigned way = 0;
    };
    class Walk;

    const Raster<float>& clearance_;
    const Raster<float>& free_clearance_;
    std::int32_t stride_cells_;
    double step_m_;
    /// Of the window of places; its rows are a power of two long.
    std::int32_t radius_;
    unsigned row_bits_;
    /// In fifths of a step: the longest path, and those up to which something is noted.
    unsigned longest_;
    std::array<unsigned, 3> noted_at_{};
    /// By place, the length of the shortest path so far.
    std::vector<std::uint16_t> length_;
    /// The places to visit next by path length: no step is longer than 7.
    std::array<std::vector<Reached>, 8> fronts_;
    /// The largest length beside each place of a row.
    std::vector<std::uint16_t> most_around_;
    std::vector<Start> starts_;
};

/// Both sides and the opening of a saddle put together.
[[nodiscard]] Narrowing put_together(const Saddle& saddle, const Opening& opening,
                                     const SideOfSaddle& side_a, const SideOfSaddle& side_b,
                                     double resolution_m);

}  // namespace quadcut
