// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Time and peak memory of segment(), with defaults, from small maps to 120 million cells: the maps
// of the data, simulated campuses of 10 to 3,000 rooms (means of several draws up to 300), one
// gigantic map; each in a process of its own, beside OpenCV's exact distance transform of the same
// image. Fits time = factor * size ^ e, of wall time and of the CPU time of all threads, which
// others on the machine disturb less.
//   measure_scale [-o FILE.json] [TEXT]      only inputs whose name contains TEXT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bench/campus.hpp"
#include "bench/cases.hpp"
#include "bench/cpu_time.hpp"
#include "bench/distance_transform.hpp"
#include "bench/own_process.hpp"
#include "bench/power_fit.hpp"
#include "bench/result_file.hpp"
#include "io/map_server.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
namespace {

namespace fs = std::filesystem;

constexpr int kNumThreads = 2;
constexpr int kRuns = 9;
/// No further run when the ones before took this long together: at least three, if they can be had.
constexpr double kEnoughMs = 1000.0;
constexpr double kTooLongMs = 8000.0;
/// What exponents are fitted over.
constexpr double kLeastCells = 1e6;

struct Input {
    std::string name;
    std::string kind;
    std::function<GridMap(int draw)> read;
    /// Maps of this kind, of which the mean counts.
    int draws = 1;
};

std::vector<Input> all_inputs() {
    std::vector<Input> inputs;
    const fs::path data = fs::path(QUADCUT_SHARED_DIR) / "data";
    std::vector<fs::path> paths;
    for (const char* folder : {"rooms", "maps"}) {
        if (!fs::exists(data / folder)) continue;
        for (const auto& entry : fs::directory_iterator(data / folder)) {
            const std::string name = entry.path().filename().string();
            if (entry.path().extension() == ".yaml" || name == "willow_full_stage.pgm" ||
                name == "stage_hospital.png") {
                paths.push_back(entry.path());
            }
        }
    }
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) {
        inputs.push_back(
            {path.stem().string(), "data", [path](int) { return io::read_map(path).map; }});
    }
    // Few buildings may be all furnished, or none of them turned: small campuses are drawn often
    // enough for the same mixture of buildings as large ones have.
    const std::array<std::pair<int, int>, 6> campuses{
        {{10, 24}, {30, 24}, {100, 8}, {300, 4}, {1000, 1}, {3000, 1}}};
    for (const auto& [rooms, draws] : campuses) {
        inputs.push_back({"campus of " + std::to_string(rooms) + " rooms", "campus",
                          [rooms = rooms](int draw) { return campus_of(rooms, draw); }, draws});
    }
    const fs::path gigantic = data / "maps/rangelibc_gigantic_map.png";
    if (fs::exists(gigantic)) {
        inputs.push_back({gigantic.stem().string(), "gigantic",
                          [gigantic](int) { return io::read_map(gigantic).map; }});
    }
    return inputs;
}

struct Yardstick {
    double elapsed_ms = std::numeric_limits<double>::infinity();
    double cpu_ms = std::numeric_limits<double>::infinity();
};

/// The distance transform into memory that is there already.
void measure_transform(const GridMap& map, Yardstick& least) {
    const cv::Mat image = free_image(map);
    cv::Mat distances(image.rows, image.cols, CV_32FC1, cv::Scalar(0.0));
    const double before_cpu_ms = cpu_ms();
    least.elapsed_ms = std::min(least.elapsed_ms, distance_transform_ms(image, distances));
    least.cpu_ms = std::min(least.cpu_ms, cpu_ms() - before_cpu_ms);
}

/// The fastest of each; both take turns, so that what else the machine does meets both.
Json measure(const Input& input, int draw) {
    cv::setNumThreads(kNumThreads);
    const GridMap map = input.read(draw);
    Json row;
    row["input"] = input.name;
    row["kind"] = input.kind;
    row["cells"] = map.states.values.size();
    row["free_cells"] =
        std::count(map.states.values.begin(), map.states.values.end(), CellState::free);
    row["read_peak_mib"] = own_mib("VmHWM");
    const RunOptions run_options{kNumThreads};
    double segment_ms = std::numeric_limits<double>::infinity();
    double segment_cpu_ms = segment_ms;
    Yardstick transform;
    double sum_ms = 0.0;
    const double before_mib = own_mib("VmRSS");
    forget_peak();
    for (int run = 0; run < kRuns; ++run) {
        if (sum_ms >= (run < 3 ? kTooLongMs : kEnoughMs)) break;
        {
            Segmentation rooms;
            const double before_cpu_ms = cpu_ms();
            const double elapsed_ms = timed_ms([&] { rooms = segment(map, {}, run_options); });
            segment_cpu_ms = std::min(segment_cpu_ms, cpu_ms() - before_cpu_ms);
            sum_ms += elapsed_ms;
            if (run == 0) {
                row["rooms"] = rooms.rooms.size();
                row["peak_mib"] = own_mib("VmHWM");
                row["peak_over_map_mib"] = row["peak_mib"].get<double>() - before_mib;
            }
            if (elapsed_ms < segment_ms) {
                segment_ms = elapsed_ms;
                row["stages_ms"] = Json::object();
                for (const auto& [stage, ms] : rooms.report.stages_ms) row["stages_ms"][stage] = ms;
            }
        }
        measure_transform(map, transform);
    }
    row["segment_ms"] = segment_ms;
    row["segment_cpu_ms"] = segment_cpu_ms;
    row["distance_transform_ms"] = transform.elapsed_ms;
    row["distance_transform_cpu_ms"] = transform.cpu_ms;
    return row;
}

/// Adds each number of a row to that of the other one.
void add(Json& sum, const Json& row) {
    for (const auto& [key, value] : row.items()) {
        if (value.is_object()) {
            add(sum[key], value);
        } else if (value.is_number()) {
            const double so_far = sum.contains(key) ? sum[key].get<double>() : 0.0;
            sum[key] = so_far + value.get<double>();
        } else {
            sum[key] = value;
        }
    }
}

void divide(Json& sum, double count) {
    for (auto& [key, value] : sum.items()) {
        if (value.is_object()) {
            divide(value, count);
        } else if (value.is_number()) {
            value = value.get<double>() / count;
        }
    }
}

/// The mean of all draws, each in a process of its own.
Json mean_of_draws(const Input& input) {
    Json mean = Json::object();
    for (int draw = 0; draw < input.draws; ++draw) {
        add(mean, in_own_process([&] { return measure(input, draw); }));
    }
    divide(mean, input.draws);
    for (const char* count : {"cells", "free_cells", "rooms"}) {
        mean[count] = std::llround(mean[count].get<double>());
    }
    mean["draws"] = input.draws;
    mean["ratio"] = mean["segment_ms"].get<double>() / mean["distance_transform_ms"].get<double>();
    mean["cpu_ratio"] =
        mean["segment_cpu_ms"].get<double>() / mean["distance_transform_cpu_ms"].get<double>();
    return mean;
}

void print(const Json& row) {
    std::printf("| %-28s | %8.2f | %8.2f | %6d | %9.1f | %9.1f | %8.1f | %5.1f | %5.1f | %7.0f |\n",
                row["input"].get<std::string>().c_str(), 1e-6 * row["cells"].get<double>(),
                1e-6 * row["free_cells"].get<double>(), row["rooms"].get<int>(),
                row["segment_ms"].get<double>(), row["segment_cpu_ms"].get<double>(),
                row["distance_transform_ms"].get<double>(), row["ratio"].get<double>(),
                row["cpu_ratio"].get<double>(), row["peak_mib"].get<double>());
    std::fflush(stdout);
}

/// Of what is measured in `key` over the cells of `size`, from a million cells of map up.
Json fit_of(const Json& rows, const std::string& kind, const char* size, const char* key) {
    std::vector<Point> points;
    for (const Json& row : rows) {
        if (!kind.empty() && row["kind"] != kind) continue;
        if (row["cells"].get<double>() < kLeastCells) continue;
        points.push_back({row[size].get<double>(), row[key].get<double>()});
    }
    const PowerFit fit = fit_power(points);
    const std::string of = kind.empty() ? "all maps" : "campuses";
    std::printf("%s of %s over %s from 10^6 cells on: exponent %.3f, %zu maps, within x %.2f\n",
                key, of.c_str(), size, fit.exponent, fit.num_points, fit.largest_deviation);
    return {{"fit", std::string(key) + " of " + of + " over " + size},
            {"exponent", fit.exponent},
            {"maps", fit.num_points},
            {"largest_deviation", fit.largest_deviation}};
}

int run(int argc, char** argv) {
    std::string wanted;
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "-o") {
            ++i;
        } else {
            wanted = argv[i];
        }
    }
    std::printf(
        "| map | megacells | free megacells | rooms | segment ms | of CPU | distance transform ms "
        "| "
        "ratio | of CPU times | peak MiB |\n|---|---|---|---|---|---|---|---|---|---|\n");
    Json rows = Json::array();
    for (const Input& input : all_inputs()) {
        if (input.name.find(wanted) == std::string::npos) continue;
        rows.push_back(mean_of_draws(input));
        print(rows.back());
    }
    Json fits = Json::array();
    for (const char* kind : {"campus", ""}) {
        for (const char* size : {"cells", "free_cells"}) {
            fits.push_back(fit_of(rows, kind, size, "segment_ms"));
            fits.push_back(fit_of(rows, kind, size, "segment_cpu_ms"));
            fits.push_back(fit_of(rows, kind, size, "distance_transform_ms"));
        }
    }
    fits.push_back(fit_of(rows, "campus", "cells", "peak_mib"));
    for (Json& fit : fits) rows.push_back(std::move(fit));
    write_results(output_path(argc, argv), "scale", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
