// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/followed.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "quadcut/follow/followed_map.hpp"
#include "quadcut/segment/segment.hpp"
#include "reproduce/partition.hpp"
#include "reproduce/timing.hpp"

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

/// Cuts the map of each moment anew.
void cut_anew(Followed& followed, const SegmentOptions& options, const RunOptions& run) {
    for (const draw::Moment& moment : followed.moments) {
        const auto at = static_cast<double>(moment.way.size());
        const double ms =
            elapsed_ms([&] { followed.at_once = segment(moment.map, options, run, moment.way); });
        followed.basic_ms.push_back({at, ms});
        followed.basic_nodes.push_back(
            {at, static_cast<double>(followed.at_once.report.num_leaves)});
    }
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
            result.cut_nodes.push_back({at, static_cast<double>(update.graph_nodes)});
            result.cut_ms.push_back({at, update.segment_ms});
        }
        result.updates.push_back(std::move(update));
    };
    const std::size_t num_scans = world.scans.size();
    const std::size_t sample = std::max<std::size_t>(1, num_scans / kNumSamples);
    for (std::size_t i = 0; i < num_scans; ++i) {
        const auto at = static_cast<double>(i + 1);
        keep(follower.add_scan(world.scans[i]), at);
        if ((i + 1) % sample == 0 || i + 1 == num_scans) {
            result.whole_leaves.push_back({at, count_free_leaves(follower.map())});
        }
        const std::size_t next = num_scans * (result.moments.size() + 1) / num_moments;
        if (i + 1 == next && i + 1 != num_scans) {
            result.moments.push_back(moment_of(follower, world.trajectory, options.preset));
        }
    }
    keep(follower.finish(), static_cast<double>(num_scans));
    result.moments.push_back(moment_of(follower, world.trajectory, options.preset));
    cut_anew(result, options, run);
    return result;
}

std::size_t count_uncrossed(const draw::Moment& moment) {
    std::vector<bool> is_crossed(moment.rooms.rooms.size() + 1, false);
    const Pose image_from_map = inverse(moment.map.map_from_image);
    const auto visit = [&](const Point& at) {
        const Point in_image = transform(image_from_map, at);
        const Cell cell{
            static_cast<std::int32_t>(std::floor(in_image.x / moment.map.resolution_m)),
            static_cast<std::int32_t>(std::floor(in_image.y / moment.map.resolution_m))};
        if (moment.rooms.labels.contains(cell)) is_crossed[moment.rooms.labels.at(cell)] = true;
    };
    for (std::size_t i = 0; i < moment.way.size(); ++i) {
        const Point& to = moment.way[i];
        const Point& from = moment.way[i == 0 ? 0 : i - 1];
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        // Twice a cell, so that no cell is stepped over but at its corner.
        const double num_steps = std::ceil(2.0 * length / moment.map.resolution_m);
        for (double step = 1.0; step <= num_steps; ++step) {
            const double share = step / num_steps;
            visit({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
        }
        visit(to);
    }
    return static_cast<std::size_t>(std::count(is_crossed.begin() + 1, is_crossed.end(), false));
}

std::vector<double> heights(const std::vector<Point>& points) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const Point& point : points) values.push_back(point.y);
    return values;
}

double mean(const std::vector<Point>& points) {
    double sum = 0.0;
    for (const Point& point : points) sum += point.y;
    return points.empty() ? 0.0 : sum / static_cast<double>(points.size());
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace quadcut::reproduce
