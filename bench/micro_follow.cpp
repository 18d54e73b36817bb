// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Follows logs and compares with the batch result on the same map.
//   micro_follow [LOG ...]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/cases.hpp"
#include "io/carmen.hpp"
#include "io/score.hpp"
#include "quadcut/segment/follow.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
namespace {

void compare(const Follower& follower, const std::vector<Point>& trajectory, const char* when) {
    const GridMap map = follower.map().to_grid();
    SegmentOptions options;
    const auto start = std::chrono::steady_clock::now();
    const Segmentation batch = segment(map, options, trajectory);
    const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
    const Segmentation followed = follower.rooms();
    const io::RoomScore score =
        io::score_rooms(as_label_image(followed.labels), as_label_image(batch.labels));
    std::printf(
        "  %s: PQ %.1f, ARI %.3f; %zu rooms followed, %zu in the batch (%.0f ms, %zu pieces)\n",
        when, 100.0 * score.pq, score.ari, followed.rooms.size(), batch.rooms.size(), ms.count(),
        batch.report.num_leaves);
    std::fflush(stdout);
}

void follow(const std::filesystem::path& log) {
    const io::LogFile file = io::read_carmen_log(log);
    std::printf("%s: %zu scans\n", log.filename().c_str(), file.scans.size());
    Follower follower;
    std::vector<Point> trajectory;
    std::vector<double> segment_ms;
    std::vector<double> relabelled;
    double integrate_ms = 0.0;
    std::size_t largest = 0;
    std::size_t next_tenth = 1;
    std::size_t num_events = 0;
    for (const Scan& scan : file.scans) {
        const FollowUpdate update = follower.add_scan(scan);
        trajectory.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
        integrate_ms += update.integrate_ms;
        num_events += update.events.size();
        if (update.segment_ms > 0.0) {
            segment_ms.push_back(update.segment_ms);
            relabelled.push_back(update.relabelled_m2);
        }
        largest = std::max(largest, update.graph_nodes);
        if (trajectory.size() * 10 >= next_tenth * file.scans.size() && next_tenth < 10) {
            compare(follower, trajectory, (std::to_string(next_tenth) + "/10").c_str());
            ++next_tenth;
        }
    }
    compare(follower, trajectory, "end");
    follower.finish();
    compare(follower, trajectory, "finished");
    double sum_ms = 0.0;
    for (const double ms : segment_ms) sum_ms += ms;
    std::sort(segment_ms.begin(), segment_ms.end());
    std::sort(relabelled.begin(), relabelled.end());
    std::printf(
        "  integrate %.0f ms, segment %.0f ms in %zu updates (median %.1f, 99 %% %.1f), "
        "largest graph %zu, median relabelled %.2f m2, %zu events\n",
        integrate_ms, sum_ms, segment_ms.size(), quantile(segment_ms, 0.5),
        quantile(segment_ms, 0.99), largest, quantile(relabelled, 0.5), num_events);
}

int run(int argc, char** argv) {
    const std::filesystem::path logs = std::filesystem::path(QUADCUT_SHARED_DIR) / "data/logs";
    std::vector<std::string> names(argv + 1, argv + argc);
    if (names.empty()) {
        names = {"intel_dense.log.gz", "mit_csail_dense.log.gz", "aces_dense.log.gz",
                 "mit_killian_dense.log.gz"};
    }
    for (const std::string& name : names) follow(logs / name);
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
