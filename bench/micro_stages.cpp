// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// The CPU time of each stage of segment(), for both presets, over simulated campuses of growing
// size, and the exponent e of time = factor * size ^ e that fits it; peak memory beside it. One
// thread, each size in a process of its own.
//   micro_stages [-o FILE.json] [LARGEST]      rooms of the largest campus (640; paper: a
// quarter, told the number of rooms: an eighth)
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/campus.hpp"
#include "bench/cases.hpp"
#include "bench/cpu_time.hpp"
#include "bench/own_process.hpp"
#include "bench/power_fit.hpp"
#include "bench/result_file.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
namespace {

constexpr int kRuns = 3;
/// No further run when the ones before took this long together.
constexpr double kEnoughMs = 4000.0;
constexpr int kSmallest = 10;
constexpr int kLargest = 640;

struct Method {
    std::string name;
    Preset preset = Preset::rooms;
    bool is_told_the_number = false;
    /// Of the largest campus.
    int share = 1;
};

/// The choice of a number of submaps by silhouette looks at few clusterings whatever the size, so
/// the other way is measured, too: clustering then takes minutes from 160 rooms on.
const std::vector<Method> kMethods{{"rooms", Preset::rooms, false, 1},
                                   {"paper", Preset::paper, false, 4},
                                   {"paper, told K", Preset::paper, true, 8}};

/// The least time of each stage.
Json measure(const Method& method, int num_rooms) {
    const GridMap map = campus_of(num_rooms);
    Json row;
    row["method"] = method.name;
    row["input"] = "campus of " + std::to_string(num_rooms) + " rooms";
    row["cells"] = map.states.values.size();
    row["free_cells"] =
        std::count(map.states.values.begin(), map.states.values.end(), CellState::free);
    SegmentOptions options;
    options.preset = method.preset;
    options.num_threads = 1;
    if (method.is_told_the_number) {
        options.paper.num_submaps = static_cast<std::size_t>(num_rooms);
    }
    forget_peak();
    double elapsed_ms = 0.0;
    for (int run = 0; run < kRuns && elapsed_ms < kEnoughMs; ++run) {
        std::vector<std::pair<std::string, double>> stages_ms;
        double since_ms = cpu_ms();
        const auto note_end = [&] {
            const double now_ms = cpu_ms();
            if (!stages_ms.empty()) stages_ms.back().second = now_ms - since_ms;
            since_ms = now_ms;
        };
        const Segmentation result = segment(map, options, {}, [&](std::string_view stage) {
            note_end();
            stages_ms.emplace_back(stage, 0.0);
        });
        note_end();
        if (run == 0) {
            row["rooms"] = result.rooms.size();
            row["leaves"] = result.report.num_leaves;
            row["peak_mib"] = own_mib("VmHWM");
        }
        // A stage may be entered again.
        std::map<std::string, double> sums_ms;
        for (const auto& [stage, ms] : stages_ms) sums_ms[stage] += ms;
        for (const auto& [stage, ms] : sums_ms) {
            Json& least = row["stages_ms"][stage];
            least = least.is_null() ? ms : std::min(least.get<double>(), ms);
            elapsed_ms += ms;
        }
    }
    double sum_ms = 0.0;
    for (const Json& ms : row["stages_ms"]) sum_ms += ms.get<double>();
    row["sum_ms"] = sum_ms;
    return row;
}

void print(const Json& row) {
    std::printf("%-14s %-22s %7.2f megacells, %7.2f free, %5d rooms, %6.0f MiB, %8.1f ms:",
                row["method"].get<std::string>().c_str(), row["input"].get<std::string>().c_str(),
                1e-6 * row["cells"].get<double>(), 1e-6 * row["free_cells"].get<double>(),
                row["rooms"].get<int>(), row["peak_mib"].get<double>(),
                row["sum_ms"].get<double>());
    for (const auto& [stage, ms] : row["stages_ms"].items()) {
        std::printf(" %s %.1f", stage.c_str(), ms.get<double>());
    }
    std::printf("\n");
    std::fflush(stdout);
}

/// A fit of each stage of a method, and of their sum and of the peak.
void add_fits(const std::string& method, const Json& measured, Json& rows) {
    std::map<std::string, std::pair<std::vector<Point>, std::vector<Point>>> curves;
    for (const Json& row : measured) {
        const auto add = [&](const std::string& what, double value) {
            auto& [over_cells, over_free] = curves[what];
            over_cells.push_back({row["cells"].get<double>(), value});
            over_free.push_back({row["free_cells"].get<double>(), value});
        };
        for (const auto& [stage, ms] : row["stages_ms"].items()) add(stage, ms.get<double>());
        add("all", row["sum_ms"].get<double>());
        add("peak memory", row["peak_mib"].get<double>());
    }
    for (const auto& [stage, points] : curves) {
        const PowerFit over_cells = fit_power(points.first);
        const PowerFit over_free = fit_power(points.second);
        std::printf("%-14s %-12s exponent over cells %.2f, over free cells %.2f, within x %.2f\n",
                    method.c_str(), stage.c_str(), over_cells.exponent, over_free.exponent,
                    over_cells.largest_deviation);
        rows.push_back({{"method", method},
                        {"fit", stage},
                        {"exponent_over_cells", over_cells.exponent},
                        {"exponent_over_free_cells", over_free.exponent},
                        {"largest_deviation", over_cells.largest_deviation},
                        {"sizes", over_cells.num_points}});
    }
}

int run(int argc, char** argv) {
    int largest = kLargest;
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "-o") {
            ++i;
        } else {
            largest = std::atoi(argv[i]);
        }
    }
    Json rows = Json::array();
    for (const Method& method : kMethods) {
        Json measured = Json::array();
        for (int rooms = kSmallest; rooms <= largest / method.share; rooms *= 2) {
            measured.push_back(in_own_process([&] { return measure(method, rooms); }));
            print(measured.back());
        }
        Json fits = Json::array();
        add_fits(method.name, measured, fits);
        for (Json& row : measured) rows.push_back(std::move(row));
        for (Json& fit : fits) rows.push_back(std::move(fit));
    }
    write_results(output_path(argc, argv), "stages", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
