// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/fuse.hpp"

#include <algorithm>
#include <queue>
#include <tuple>
#include <vector>

#include "quadcut/segment/door_model.hpp"
#include "quadcut/segment/region_graph.hpp"

namespace quadcut {
namespace {

/// From granularity 0 to 1 the threshold falls by so much: the range in which rooms differ.
constexpr double kLogOddsOfGranularity = 12.0;
constexpr double kNoDoor = -100.0;

/// A saddle with the numbers of joins that its two regions had seen when it was last measured.
struct Candidate {
    double key = 0.0;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t version_a = 0;
    std::uint32_t version_b = 0;
    /// Lowest key first; ties by region, so that the order is the same everywhere.
    friend bool operator<(const Candidate& p, const Candidate& q) {
        return std::tie(p.key, p.a, p.b) > std::tie(q.key, q.a, q.b);
    }
};

/// The log-odds of a door; that of no door at all when the opening is too wide for one.
double door_likeness(RegionGraph& regions, std::uint32_t a, std::uint32_t b, double max_width_m) {
    const Saddle& saddle = regions.saddles(a).at(b);
    if (2.0 * static_cast<double>(saddle.clearance_m) > max_width_m) return kNoDoor;
    return door_log_odds(regions.measure(a, b));
}

void push_saddles(RegionGraph& regions, std::uint32_t region, double max_width_m,
                  std::priority_queue<Candidate>& queue) {
    for (const auto& [other, saddle] : regions.saddles(region)) {
        queue.push({door_likeness(regions, region, other, max_width_m), region, other,
                    regions.version(region), regions.version(other)});
    }
}

/// Joins across the least door-like saddle until every one left is a door.
void join_across_wide_saddles(RegionGraph& regions, const FuseOptions& options) {
    std::priority_queue<Candidate> queue;
    for (std::uint32_t region = 1; region <= regions.num_pieces(); ++region) {
        for (const auto& [other, saddle] : regions.saddles(region)) {
            if (other < region) continue;
            queue.push({door_likeness(regions, region, other, options.max_width_m), region, other, 0, 0});
        }
    }
    while (!queue.empty() && queue.top().key < options.min_log_odds) {
        const Candidate top = queue.top();
        queue.pop();
        if (!regions.is_region(top.a) || !regions.is_region(top.b) ||
            regions.version(top.a) != top.version_a || regions.version(top.b) != top.version_b) {
            continue;
        }
        const bool a_larger = regions.area_m2(top.a) >= regions.area_m2(top.b);
        const std::uint32_t heir = a_larger ? top.a : top.b;
        regions.join(heir, a_larger ? top.b : top.a);
        push_saddles(regions, heir, options.max_width_m, queue);
    }
}

/// Smallest first, through the widest saddle; a small region without a neighbour stays.
void join_small_regions(RegionGraph& regions, double min_area_m2) {
    std::vector<std::uint32_t> small;
    for (std::uint32_t region = 1; region <= regions.num_pieces(); ++region) {
        if (regions.is_region(region) && regions.area_m2(region) < min_area_m2) {
            small.push_back(region);
        }
    }
    std::stable_sort(small.begin(), small.end(), [&](std::uint32_t p, std::uint32_t q) {
        return regions.area_m2(p) < regions.area_m2(q);
    });
    for (const std::uint32_t region : small) {
        if (!regions.is_region(region) || regions.area_m2(region) >= min_area_m2) continue;
        const auto& saddles = regions.saddles(region);
        const auto widest =
            std::max_element(saddles.begin(), saddles.end(), [](const auto& p, const auto& q) {
                return p.second.clearance_m < q.second.clearance_m;
            });
        if (widest != saddles.end()) regions.join(widest->first, region);
    }
}

}  // namespace

double fuse_threshold(double granularity) { return kLogOddsOfGranularity * (0.5 - granularity); }

FusedRegions fuse(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                  const Raster<float>& clearance_m, double resolution_m,
                  const FuseOptions& options) {
    RegionGraph regions(pieces, num_pieces, clearance_m, resolution_m);
    join_across_wide_saddles(regions, options);
    join_small_regions(regions, options.min_area_m2);

    FusedRegions fused;
    std::vector<std::uint32_t> label(num_pieces + 1, 0);
    for (std::uint32_t region = 1; region <= num_pieces; ++region) {
        if (regions.is_region(region)) label[region] = ++fused.count;
    }
    fused.labels = Raster<std::uint32_t>(pieces.origin, pieces.width, pieces.height);
    for (std::size_t i = 0; i < pieces.values.size(); ++i) {
        if (pieces.values[i] != 0)
            fused.labels.values[i] = label[regions.region_of(pieces.values[i])];
    }
    return fused;
}

}  // namespace quadcut
