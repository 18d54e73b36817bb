// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/followed.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "quadcut/follow/followed_map.hpp"
#include "reproduce/partition.hpp"

namespace quadcut::reproduce {
namespace {

constexpr std::size_t kNumSamples = 40;

draw::Moment moment_of(const Follower& follower, const std::vector<Point>& way, Preset preset) {
    const std::size_t num_rooms = follower.num_rooms();
    draw::Moment moment{"scan " + std::to_string(follower.num_scans()) + ", " +
                            std::to_string(num_rooms) + (num_rooms == 1 ? " region" : " regions"),
                        follower.map().to_grid(), follower.rooms(), way};
    moment.way.resize(follower.num_scans());
    if (preset == Preset::paper) moment.rooms = as_submaps(std::move(moment.rooms));
    return moment;
}

double count_free_leaves(const OccupancyMap& map) {
    const std::vector<Leaf> leaves = map.leaves();
    return static_cast<double>(std::count_if(leaves.begin(), leaves.end(), [](const Leaf& leaf) {
        return leaf.state == CellState::free;
    }));
}

}  // namespace

Followed follow(const World& world, const SegmentOptions& options, const RunOptions& run,
                double resolution_m, std::size_t num_moments) {
    FollowOptions follow_options;
    follow_options.segment = options;
    follow_options.resolution_m = resolution_m;
    Follower follower(follow_options, run);
    Followed result;
    const auto keep = [&result](FollowUpdate update, double at) {
        update.events.clear();
        if (update.graph_nodes > 0) {
            result.local_nodes.push_back({at, static_cast<double>(update.graph_nodes)});
            result.cuts_ms.push_back(update.segment_ms);
        }
        result.updates.push_back(std::move(update));
    };
    const std::size_t num_scans = world.scans.size();
    const std::size_t sample = std::max<std::size_t>(1, num_scans / kNumSamples);
    for (std::size_t i = 0; i < num_scans; ++i) {
        const auto at = static_cast<double>(i + 1);
        keep(follower.add_scan(world.scans[i]), at);
        if ((i + 1) % sample == 0 || i + 1 == num_scans) {
            result.whole_nodes.push_back({at, count_free_leaves(follower.map())});
        }
        const std::size_t next = num_scans * (result.moments.size() + 1) / num_moments;
        if (i + 1 == next && i + 1 != num_scans) {
            result.moments.push_back(moment_of(follower, world.trajectory, options.preset));
        }
    }
    keep(follower.finish(), static_cast<double>(num_scans));
    result.moments.push_back(moment_of(follower, world.trajectory, options.preset));
    return result;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace quadcut::reproduce
