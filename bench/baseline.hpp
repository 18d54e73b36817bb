// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "quadcut/map/clearance.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/rooms/basins.hpp"
#include "quadcut/rooms/fuse.hpp"
#include "quadcut/rooms/region_graph.hpp"
#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {

/// Joins regions, the widest opening for the narrower of the two first, while one has more than
/// `max_ratio` of that region's width, or is wider than `max_width_m`.
inline void fuse_by_ratio(RegionGraph& regions, double max_ratio, double max_width_m) {
    const auto ratio_of = [&](std::uint32_t a, std::uint32_t b) {
        const auto half_m = static_cast<double>(regions.saddles(a).at(b).clearance_m);
        const double narrower_m = std::min(regions.peak_m(a), regions.peak_m(b));
        return 2.0 * half_m > max_width_m ? HUGE_VAL : half_m / narrower_m;
    };
    while (true) {
        double widest = max_ratio;
        std::pair<std::uint32_t, std::uint32_t> pair;
        for (std::uint32_t a = 1; a <= regions.num_pieces(); ++a) {
            if (!regions.is_region(a)) continue;
            for (const auto& [b, saddle] : regions.saddles(a)) {
                const double ratio = a < b ? ratio_of(a, b) : 0.0;
                if (ratio <= widest) continue;
                widest = ratio;
                pair = {a, b};
            }
        }
        if (pair.first == 0) return;
        const bool a_larger = regions.area_m2(pair.first) >= regions.area_m2(pair.second);
        if (!a_larger) std::swap(pair.first, pair.second);
        regions.join(pair.first, pair.second);
    }
}

/// The watershed of the clearance alone: every obstacle counts, and regions are fused when the
/// narrowest place between them has three quarters of the smaller width, or is 3 m wide. What the
/// door model and the treatment of furniture are measured against. Regions smaller than a room join
/// a neighbour before the ratio is asked, as they do by default.
[[nodiscard]] inline Raster<std::uint32_t> watershed_baseline(const GridMap& map,
                                                              std::span<const Point> trajectory) {
    constexpr double kMaxRatio = 0.75;
    constexpr double kMaxWidthM = 3.0;
    const RoomsOptions rooms;
    const Raster<float> clearance =
        clearance_m(inside(map, trajectory, rooms.min_component_m2), map.resolution_m);
    Basins basins = build_basins(clearance, map.resolution_m);
    const Raster<std::uint32_t> pieces = basins.labels;
    const WallLines no_lines;
    RegionGraph regions(pieces, basins.count,
                        {clearance, clearance, map.states, no_lines, map.resolution_m});
    // What is one room whatever the ratio.
    fuse_by_ratio(regions, 2.0 * kMaxRatio, kMaxWidthM);
    fuse_small_regions(regions, rooms.min_room_m2, rooms.min_passable_m);
    fuse_by_ratio(regions, kMaxRatio, kMaxWidthM);
    relabel(regions, basins.labels);
    return std::move(basins.labels);
}

}  // namespace quadcut
