// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Loop closure by rooms: how many pairs of poses a back end need not match, against all pairs
// within the sensor's range, and how many of the true closures (within 2 m and in sight of each
// other on the map) are left. On the dense logs.
//   measure_closure [-o FILE.json] [LOG ...]
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench/cases.hpp"
#include "bench/cpu_time.hpp"
#include "bench/result_file.hpp"
#include "bench/shared_folder.hpp"
#include "io/input.hpp"
#include "io/scan_source.hpp"
#include "io/scanned_map.hpp"
#include "quadcut/map/line_walk.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "quadcut/zones/closure.hpp"

namespace quadcut {
namespace {

constexpr double kTrueM = 2.0;
constexpr double kResolutionM = 0.05;

/// Whether nothing but free cells lies between two points, in cells.
bool is_in_sight(const GridMap& map, const Point& a, const Point& b) {
    bool is_free = true;
    walk_line(a, b, [&](Cell cell, double) {
        is_free = map.states.contains(cell) && map.states.at(cell) == CellState::free;
        return is_free;
    });
    return is_free;
}

struct Counts {
    std::size_t in_range = 0;
    std::size_t candidates = 0;
    std::size_t true_pairs = 0;
    std::size_t kept = 0;
    std::size_t of_other_rooms = 0;
    double ms = 0.0;
};

/// All pairs of poses, by rooms and by range alone.
Counts count_pairs(const io::ScannedMap& mapped, const Segmentation& rooms,
                   const ClosureOptions& options) {
    Counts counts;
    const double begin = cpu_ms();
    ClosureIndex index(mapped.map, rooms, options);
    std::vector<std::vector<std::size_t>> candidates;
    for (const Point& pose : mapped.trajectory) {
        candidates.push_back(index.candidates(index.add(pose)));
    }
    counts.ms = cpu_ms() - begin;
    const Pose image_from_map = inverse(mapped.map.map_from_image);
    std::vector<Point> cells;
    std::vector<double> way_m{0.0};
    for (const Point& pose : mapped.trajectory) {
        const Point at = transform(image_from_map, pose);
        cells.push_back({at.x / mapped.map.resolution_m, at.y / mapped.map.resolution_m});
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0) {
            way_m.push_back(way_m.back() +
                            distance(mapped.trajectory[i - 1], mapped.trajectory[i]));
        }
        counts.candidates += candidates[i].size();
        for (std::size_t j = 0; j < i; ++j) {
            if (way_m[i] - way_m[j] < options.least_way_m) break;
            const double apart_m = distance(mapped.trajectory[i], mapped.trajectory[j]);
            if (apart_m > options.range_m) continue;
            ++counts.in_range;
            if (apart_m > kTrueM || !is_in_sight(mapped.map, cells[i], cells[j])) continue;
            ++counts.true_pairs;
            counts.kept += std::binary_search(candidates[i].begin(), candidates[i].end(), j);
        }
    }
    return counts;
}

Json row_of(const std::string& name, const io::ScannedMap& mapped, const Segmentation& rooms,
            const ClosureOptions& options) {
    const Counts counts = count_pairs(mapped, rooms, options);
    return {
        {"log", name},
        {"range", std::to_string(std::lround(options.range_m)) + " m"},
        {"through_opening_m", options.through_opening_m},
        {"least_way_m", options.least_way_m},
        {"scans", mapped.trajectory.size()},
        {"rooms", rooms.rooms.size()},
        {"pairs_in_range", counts.in_range},
        {"candidates", counts.candidates},
        {"saved_percent", 100.0 - percent(counts.candidates, counts.in_range)},
        {"true_closures", counts.true_pairs},
        {"kept_percent", percent(counts.kept, counts.true_pairs)},
        {"us_a_pose", 1e3 * counts.ms /
                          static_cast<double>(std::max<std::size_t>(mapped.trajectory.size(), 1))}};
}

int run(int argc, char** argv) {
    std::vector<std::string> names;
    const std::string output = output_path(argc, argv);
    for (int i = 1; i < argc; ++i) {
        if (argv[i] != output && std::string(argv[i]) != "-o") names.emplace_back(argv[i]);
    }
    if (names.empty()) {
        names = {"intel_dense.log.gz", "mit_csail_dense.log.gz", "aces_dense.log.gz",
                 "mit_killian_dense.log.gz"};
    }
    Json rows = Json::array();
    for (const std::string& name : names) {
        const std::filesystem::path path = shared_path("data/logs/" + name);
        if (!std::filesystem::exists(path)) continue;
        const std::unique_ptr<io::ScanSource> source =
            io::open_scan_source(io::Input(path), {std::nullopt, kResolutionM, {}});
        const io::ScannedMap mapped = io::map_scans(*source, kResolutionM, {});
        const Segmentation cut = segment(mapped.map, {}, RunOptions{2}, mapped.trajectory);
        for (const double range_m : {10.0, 30.0}) {
            Json row = row_of(name, mapped, cut, {range_m, ClosureOptions{}.through_opening_m});
            result_file::round_numbers(row);
            std::printf("%s\n", row.dump().c_str());
            std::fflush(stdout);
            rows.push_back(std::move(row));
        }
    }
    write_results(output, "closure", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
