// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstdint>
#include <queue>
#include <span>
#include <tuple>
#include <utility>

#include "quadcut/map/clearance.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/basins.hpp"
#include "quadcut/segment/fuse.hpp"
#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/region_graph.hpp"

// The distance transform alone: what the door model, the spectral cut and the treatment of
// furniture are measured against.
namespace quadcut {

/// Regions are fused when the narrowest place between them has this share of the smaller peak.
inline constexpr double kBaselineMinRatio = 0.75;
/// And when it is more than this from the walls on both sides.
inline constexpr double kBaselineMaxSaddleM = 1.5;

/// Fuses the basins of the clearance, the least narrowing first.
class BaselineFusion {
public:
    BaselineFusion(const Basins& basins, const Raster<float>& clearance, double resolution_m)
        : regions_(basins.labels, basins.count, clearance, resolution_m) {}

    void join_across_wide_saddles() {
        for (std::uint32_t region = 1; region <= regions_.num_pieces(); ++region) push(region);
        while (!queue_.empty() && queue_.top().ratio >= kBaselineMinRatio) {
            const Candidate top = queue_.top();
            queue_.pop();
            if (!regions_.is_region(top.a) || !regions_.is_region(top.b) ||
                regions_.version(top.a) != top.version_a ||
                regions_.version(top.b) != top.version_b) {
                continue;
            }
            join(top.a, top.b);
            push(regions_.region_of(top.a));
        }
    }

    void join_small_regions(double min_area_m2) { fuse_small_regions(regions_, min_area_m2, 0.0); }

    [[nodiscard]] std::uint32_t region_of(std::uint32_t basin) const {
        return basin == 0 ? 0 : regions_.region_of(basin);
    }

private:
    struct Candidate {
        double ratio = 0.0;
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        std::uint32_t version_a = 0;
        std::uint32_t version_b = 0;
        /// Largest ratio first; ties by region.
        friend bool operator<(const Candidate& p, const Candidate& q) {
            return std::make_tuple(p.ratio, q.a, q.b) < std::make_tuple(q.ratio, p.a, p.b);
        }
    };

    void push(std::uint32_t region) {
        for (const auto& [other, saddle] : regions_.saddles(region)) {
            const auto height_m = static_cast<double>(saddle.clearance_m);
            const double peak_m = std::min(regions_.peak_m(region), regions_.peak_m(other));
            const double ratio = height_m > kBaselineMaxSaddleM ? 1.0 : height_m / peak_m;
            queue_.push({ratio, region, other, regions_.version(region), regions_.version(other)});
        }
    }
    void join(std::uint32_t a, std::uint32_t b) {
        if (regions_.area_m2(a) < regions_.area_m2(b)) std::swap(a, b);
        regions_.join(a, b);
    }

    RegionGraph regions_;
    std::priority_queue<Candidate> queue_;
};

/// Rooms by the distance transform: every free cell that is inside gets a label, 0 elsewhere.
/// Labels are not dense. What is inside is decided as `rooms` decides it. O(cells log cells).
inline Raster<std::uint32_t> distance_baseline(const GridMap& map,
                                               std::span<const Point> trajectory = {}) {
    const RoomsOptions defaults;
    const Raster<std::uint8_t> kept = inside(map, trajectory, defaults.min_component_m2);
    const Raster<float> clearance = clearance_m(kept, map.resolution_m);
    const Basins basins = build_basins(clearance, map.resolution_m);
    BaselineFusion fusion(basins, clearance, map.resolution_m);
    fusion.join_across_wide_saddles();
    fusion.join_small_regions(defaults.min_room_m2);
    Raster<std::uint32_t> labels = basins.labels;
    for (std::uint32_t& label : labels.values) label = fusion.region_of(label);
    return labels;
}

}  // namespace quadcut
