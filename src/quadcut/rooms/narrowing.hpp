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
#include "quadcut/rooms/walked_side.hpp"

namespace quadcut {

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
