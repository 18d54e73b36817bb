// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// The CPU time of each stage of segment(), for both presets, over simulated campuses of growing
// size, and the exponent e of time = factor * size ^ e that fits it; peak memory beside it. One
// thread, each size in a process of its own.
//   measure_stages [-o FILE.json] [LARGEST]      rooms of the largest campus (640; paper: a
// quarter, told the number of rooms: an eighth)
#include <algorithm>
#include <cstdio>
#include <cstdlib>
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
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
namespace {

constexpr int kRuns = 3;
/// No further run when the ones before took this long together.
constexpr double kEnoughMs = 4000.0;
constexpr int kSmallest = 10;
constexpr int kLargest = 640;
constexpr double kLargeCells = 1e6;

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
        RunOptions run_options{1};
        run_options.on_stage = [&](std::string_view stage) {
            note_end();
            stages_ms.emplace_back(stage, 0.0);
        };
        const Segmentation result = segment(map, options, run_options);
        note_end();
        if (run == 0) {
            row["rooms"] = result.rooms.size();
            row["leaves"] = result.report.num_leaves;
            row["peak_mib"] = own_mib("VmHWM");
        }
        // A stage may be entered again.
        Json sums_ms = Json::object();
        for (const auto& [stage, ms] : stages_ms) {
            sums_ms[stage] = sums_ms.value(stage, 0.0) + ms;
            elapsed_ms += ms;
        }
        for (const auto& [stage, sum] : sums_ms.items()) {
            Json& least = row["stages_ms"][stage];
            least = std::min(least.is_null() ? sum.get<double>() : least.get<double>(),
                             sum.get<double>());
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

/// A stage's times over the sizes that were measured.
struct Curve {
    std::string stage;
    std::vector<Point> over_cells;
    std::vector<Point> over_free_cells;
};

std::vector<Curve> curves_of(const Json& measured) {
    std::vector<Curve> curves;
    for (const Json& row : measured) {
        const auto add = [&](const std::string& stage, double value) {
            const auto is_it = [&](const Curve& curve) { return curve.stage == stage; };
            auto found = std::find_if(curves.begin(), curves.end(), is_it);
            if (found == curves.end()) found = curves.insert(found, Curve{stage, {}, {}});
            found->over_cells.push_back({row["cells"].get<double>(), value});
            found->over_free_cells.push_back({row["free_cells"].get<double>(), value});
        };
        for (const auto& [stage, ms] : row["stages_ms"].items()) add(stage, ms.get<double>());
        add("all", row["sum_ms"].get<double>());
        add("peak memory", row["peak_mib"].get<double>());
    }
    return curves;
}

/// A fit of each stage of a method, and of their sum and of the peak; small maps fit into caches,
/// so the large ones are fitted on their own, too.
void add_fits(const std::string& method, const Json& measured, Json& rows) {
    for (const Curve& curve : curves_of(measured)) {
        const PowerFit all = fit_power(curve.over_cells);
        std::vector<Point> large = curve.over_cells;
        std::erase_if(large, [](const Point& point) { return point.x < kLargeCells; });
        const PowerFit of_large = fit_power(large);
        const PowerFit over_free = fit_power(curve.over_free_cells);
        std::printf(
            "%-14s %-12s exponent over cells %.2f, over free cells %.2f, within x %.2f; over "
            "cells from 10^6 on %.2f (%zu sizes)\n",
            method.c_str(), curve.stage.c_str(), all.exponent, over_free.exponent,
            all.largest_deviation, of_large.exponent, of_large.num_points);
        rows.push_back({{"method", method},
                        {"fit", curve.stage},
                        {"exponent_over_cells", all.exponent},
                        {"exponent_over_free_cells", over_free.exponent},
                        {"largest_deviation", all.largest_deviation},
                        {"sizes", all.num_points},
                        {"exponent_over_cells_from_1e6", of_large.exponent},
                        {"sizes_from_1e6", of_large.num_points}});
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
