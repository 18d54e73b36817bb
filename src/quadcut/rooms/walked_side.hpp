// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

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

}  // namespace quadcut
