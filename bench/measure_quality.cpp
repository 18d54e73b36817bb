// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Scores of both presets on every map and log of the data; see docs/results.md.
//   measure_quality [-o FILE.json]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "bench/cases.hpp"
#include "bench/result_file.hpp"
#include "eval/labels.hpp"
#include "eval/score.hpp"
#include "io/carmen.hpp"
#include "io/map_server.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
namespace {

namespace fs = std::filesystem;

struct Method {
    std::string name;
    Preset preset = Preset::rooms;
    bool is_told_the_number = false;
};

const std::vector<Method> kMethods{{"rooms", Preset::rooms, false},
                                   {"paper", Preset::paper, false},
                                   {"paper, told K", Preset::paper, true}};

struct Run {
    Segmentation rooms;
    double elapsed_ms = 0.0;
};

Run timed_segment(const GridMap& map, const Method& method, std::size_t num_true_rooms,
                  std::span<const Point> trajectory) {
    SegmentOptions options;
    options.preset = method.preset;
    if (method.is_told_the_number) options.paper.num_submaps = num_true_rooms;
    const auto start = std::chrono::steady_clock::now();
    Run run{segment(map, options, {}, trajectory), 0.0};
    run.elapsed_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return run;
}

Json row_of(const std::string& input, const std::string& method, const Run& run) {
    Json row;
    row["input"] = input;
    row["method"] = method;
    row["rooms"] = run.rooms.rooms.size();
    row["doors"] = run.rooms.doors.size();
    row["elapsed_ms"] = run.elapsed_ms;
    for (const auto& [stage, ms] : run.rooms.report.stages_ms) row["stages_ms"][stage] = ms;
    return row;
}

void add_score(Json& row, const eval::RoomScore& score) {
    row["pq"] = score.pq;
    row["f1_70"] = score.f1_70;
    row["cover"] = score.cover;
    row["true_rooms"] = score.truth;
}

void print_row(const Json& row) {
    const auto percent = [&](const char* key) {
        return row.contains(key) ? 100.0 * row[key].get<double>() : -1.0;
    };
    std::printf("| %-28s | %-13s | %5.1f | %5.1f | %5.1f | %4d | %4d | %7.0f |\n",
                row["input"].get<std::string>().c_str(), row["method"].get<std::string>().c_str(),
                percent("pq"), percent("f1_70"), percent("cover"), row["rooms"].get<int>(),
                row.value("true_rooms", -1), row["elapsed_ms"].get<double>());
    std::fflush(stdout);
}

void score_maps(const fs::path& folder, Json& rows) {
    std::vector<fs::path> maps;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".yaml") maps.push_back(entry.path());
    }
    std::sort(maps.begin(), maps.end());
    for (const fs::path& path : maps) {
        const std::string name = path.stem().string();
        const GridMap map = io::read_map(path).map;
        const auto truth =
            io::read_label_image(folder / (name.substr(0, name.find('.')) + ".rooms.png"));
        const auto free = io::read_free_mask(folder / (name + ".png"));
        for (const Method& method : kMethods) {
            const Run run = timed_segment(map, method, truth.num_regions, {});
            auto row = row_of(name, method.name, run);
            add_score(row, eval::score_rooms(as_label_image(run.rooms.labels), truth, free));
            print_row(row);
            rows.push_back(std::move(row));
        }
    }
}

/// The labels of a log's map at the pixels of a truth image with another origin.
io::LabelImage resampled(const Segmentation& rooms, const GridMap& map, const io::LabelImage& truth,
                         const GridMap& truth_map) {
    const Pose image_from_map = inverse(map.map_from_image);
    std::vector<std::uint32_t> values;
    values.reserve(truth.values.size());
    for (std::int32_t y = truth.height - 1; y >= 0; --y) {
        for (std::int32_t x = 0; x < truth.width; ++x) {
            const Point at = transform(
                image_from_map,
                transform(truth_map.map_from_image, {(x + 0.5) * truth_map.resolution_m,
                                                     (y + 0.5) * truth_map.resolution_m}));
            const Cell cell{static_cast<std::int32_t>(std::floor(at.x / map.resolution_m)),
                            static_cast<std::int32_t>(std::floor(at.y / map.resolution_m))};
            values.push_back(rooms.labels.contains(cell) ? rooms.labels.at(cell) : 0U);
        }
    }
    return io::number_regions(truth.width, truth.height, values);
}

void score_logs(const fs::path& folder, Json& rows) {
    std::vector<fs::path> logs;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".log" || extension == ".gz") logs.push_back(entry.path());
    }
    std::sort(logs.begin(), logs.end());
    const GridMap truth_map = io::read_map(folder / "intel.gt.yaml").map;
    const auto truth = io::read_label_image(folder / "intel.gt_rooms.png");
    for (const fs::path& path : logs) {
        const io::LogFile log = io::read_carmen_log(path);
        const GridMap map = map_from_scans(log.scans, 0.05).to_grid();
        std::vector<Point> trajectory;
        for (const Scan& scan : log.scans) {
            trajectory.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
        }
        const std::string name = path.filename().string();
        // intel_robotlaser is in another frame.
        const bool has_truth = name == "intel.log" || name == "intel_dense.log.gz";
        for (const Method& method : kMethods) {
            if (method.is_told_the_number && !has_truth) continue;
            const Run run = timed_segment(map, method, truth.num_regions, trajectory);
            auto row = row_of(name, method.name, run);
            if (has_truth) {
                add_score(row,
                          eval::score_rooms(resampled(run.rooms, map, truth, truth_map), truth));
            }
            print_row(row);
            rows.push_back(std::move(row));
        }
    }
}

void segment_other_maps(const fs::path& folder, Json& rows) {
    for (const char* name :
         {"aws_small_house.yaml", "nav2_depot.yaml", "turtlebot3_world.yaml",
          "ubremen_cartesium.yaml", "willow_full_stage.pgm", "stage_hospital.png"}) {
        const GridMap map = io::read_map(folder / name).map;
        for (const Method& method : kMethods) {
            if (method.is_told_the_number) continue;
            auto row = row_of(name, method.name, timed_segment(map, method, 0, {}));
            print_row(row);
            rows.push_back(std::move(row));
        }
    }
}

/// Means by method over the maps of one kind: plain, furnished, KTH.
void print_means(const Json& rows) {
    struct Mean {
        double pq = 0.0;
        double least_cover = 1.0;
        int count = 0;
    };
    std::map<std::string, Mean> means;
    for (const auto& row : rows) {
        const auto input = row["input"].get<std::string>();
        if (!row.contains("pq") || input.find("log") != std::string::npos) continue;
        const std::string kind = input.rfind("kth_", 0) == 0                 ? "KTH, plain"
                                 : input.find(".plain") != std::string::npos ? "the ten, plain"
                                                                             : "the ten, furnished";
        Mean& mean = means[row["method"].get<std::string>() + ": " + kind];
        mean.pq += row["pq"].get<double>();
        mean.least_cover = std::min(mean.least_cover, row["cover"].get<double>());
        ++mean.count;
    }
    for (const auto& [name, mean] : means) {
        std::printf("%-36s mean PQ %.1f, least cover %.3f, %d maps\n", name.c_str(),
                    100.0 * mean.pq / mean.count, mean.least_cover, mean.count);
    }
}

int run(int argc, char** argv) {
    const fs::path data = fs::path(QUADCUT_SHARED_DIR) / "data";
    if (!fs::exists(data)) {
        std::cout << "no data in " << data.string() << ": nothing to measure\n";
        return 0;
    }
    Json rows = Json::array();
    std::printf("| input | method | PQ | F1 0.7 | cover | rooms | true | ms |\n");
    std::printf("|---|---|---|---|---|---|---|---|\n");
    score_maps(data / "rooms", rows);
    score_logs(data / "logs", rows);
    segment_other_maps(data / "maps", rows);
    print_means(rows);
    write_results(output_path(argc, argv), "quality", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
