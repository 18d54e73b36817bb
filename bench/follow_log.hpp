// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/cases.hpp"
#include "bench/flat_ray_caster.hpp"
#include "bench/id_switches.hpp"
#include "eval/labels.hpp"
#include "eval/score.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/follow/follower.hpp"
#include "quadcut/segment/segment.hpp"
#include "reproduce/kd_tree.hpp"
#include "reproduce/plot.hpp"
#include "reproduce/timing.hpp"

namespace quadcut {

/// A follower's rooms against those of segment() on the same map.
struct Agreement {
    double pq = 0.0;
    double ari = 0.0;
    std::size_t num_rooms = 0;
    std::size_t num_batch_rooms = 0;
    std::size_t batch_nodes = 0;
};

inline Agreement compare_with_batch(const Follower& follower, std::span<const Point> way,
                                    const SegmentOptions& options = {},
                                    const RunOptions& run = {}) {
    const Segmentation batch = segment(follower.map().to_grid(), options, run, way);
    const Segmentation followed = follower.rooms();
    const eval::RoomScore score =
        eval::score_rooms(as_label_image(followed.labels), as_label_image(batch.labels));
    return {100.0 * score.pq, score.ari, followed.rooms.size(), batch.rooms.size(),
            batch.report.num_leaves};
}

/// All that is measured while a log is followed; curves over scans.
struct FollowedLog {
    std::vector<Agreement> tenths;
    Agreement at_end;
    Agreement finished;
    std::vector<FollowUpdate> updates;
    std::vector<double> ray_caster_ms;
    /// Every so many scans the obstacles' KD-tree is built anew.
    Curve kd_tree_ms{"KD-tree built anew, ms", {}};
    Curve batch_nodes{"batch", {}};
    Curve switches{"id switches in 100 scans", {}};
    Curve bytes_per_m2{"bytes a mapped m2", {}};
    std::size_t num_switches = 0;
    double mapped_m2 = 0.0;
    double log_s = 0.0;
    double follow_s = 0.0;
};

namespace follow_log {

inline double known_m2(const OccupancyMap& map) {
    std::size_t cells = 0;
    const Box tiles = map.written_tiles();
    for (Cell tile = tiles.low; tile.y <= tiles.high.y; ++tile.y) {
        for (tile.x = tiles.low.x; tile.x <= tiles.high.x; ++tile.x) {
            for (const std::int8_t value : map.tile(tile).values) {
                if (value != 0) ++cells;
            }
        }
    }
    return static_cast<double>(cells) * map.resolution_m() * map.resolution_m();
}

}  // namespace follow_log

inline FollowedLog follow_log_of(std::span<const Scan> scans, const FollowOptions& options = {}) {
    using follow_log::known_m2;
    constexpr std::size_t kWindow = 100;
    const std::size_t sample = std::max<std::size_t>(1, scans.size() / 200);
    FollowedLog result;
    FlatRayCaster caster(scans, options.resolution_m, options.integrate.usable_range_m);
    Follower follower(options);
    std::vector<Point> way;
    RoomCells then;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const auto start = std::chrono::steady_clock::now();
        FollowUpdate update = follower.add_scan(scans[i]);
        result.follow_s += ms_since(start) / 1000.0;
        update.events.clear();
        result.updates.push_back(std::move(update));
        way.push_back({scans[i].world_from_sensor.x, scans[i].world_from_sensor.y});
        const auto cast = std::chrono::steady_clock::now();
        caster.add(scans[i]);
        result.ray_caster_ms.push_back(ms_since(cast));
        const auto at = static_cast<double>(i + 1);
        if ((i + 1) % sample == 0) {
            const std::vector<Cell> points = obstacles_of(follower.map());
            result.kd_tree_ms.points.push_back({at, elapsed_ms([&] { build_kd_tree(points); })});
            if ((i + 1) % (10 * sample) == 0) {
                result.bytes_per_m2.points.push_back(
                    {at, static_cast<double>(follower.bytes()) / known_m2(follower.map())});
            }
        }
        if ((i + 1) % kWindow == 0) {
            const std::size_t switches =
                count_id_switches(then, follower.state().cells, follower.map().written_tiles());
            result.num_switches += switches;
            result.switches.points.push_back({at, static_cast<double>(switches)});
            then = follower.state().cells;
        }
        if ((i + 1) * 10 >= (result.tenths.size() + 1) * scans.size() && result.tenths.size() < 9) {
            result.tenths.push_back(compare_with_batch(follower, way));
            result.batch_nodes.points.push_back(
                {at, static_cast<double>(result.tenths.back().batch_nodes)});
            std::fprintf(stderr, "  %zu/10: PQ %.1f\n", result.tenths.size(),
                         result.tenths.back().pq);
        }
    }
    result.at_end = compare_with_batch(follower, way);
    result.batch_nodes.points.push_back(
        {static_cast<double>(scans.size()), static_cast<double>(result.at_end.batch_nodes)});
    follower.finish();
    result.finished = compare_with_batch(follower, way);
    result.mapped_m2 = known_m2(follower.map());
    if (!scans.empty()) result.log_s = scans.back().time_s - scans.front().time_s;
    return result;
}

}  // namespace quadcut
