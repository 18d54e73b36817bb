// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Ways over rooms and doors against A* over all cells, between the same random points of the same
// floor for the same robot: length, cells looked at and time; on the maps of the data that have
// more than a million cells.
//   measure_route [-o FILE.json] [TEXT]      only maps whose name contains TEXT
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/cases.hpp"
#include "bench/cell_search.hpp"
#include "bench/cpu_time.hpp"
#include "bench/result_file.hpp"
#include "bench/shared_folder.hpp"
#include "io/map_server.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/route/route_planner.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 5;
constexpr std::size_t kLeastCells = 1'000'000;
/// Pairs of points; fewer where A* takes seconds.
constexpr std::size_t kNumPairs = 200;
constexpr std::size_t kHugeCells = 50'000'000;
constexpr std::size_t kNumHugePairs = 20;

std::vector<fs::path> map_paths(const std::string& text) {
    std::vector<fs::path> paths;
    for (const char* folder : {"maps", "rooms", "real"}) {
        const fs::path data = shared_path(std::string("data/") + folder);
        if (!fs::exists(data)) continue;
        for (const auto& entry : fs::directory_iterator(data)) {
            const std::string name = entry.path().filename().string();
            const bool is_map = entry.path().extension() == ".yaml" ||
                                name == "stage_hospital.png" ||
                                name == "rangelibc_gigantic_map.png";
            if (is_map && name.find(text) != std::string::npos) paths.push_back(entry.path());
        }
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

/// One pair of points, both ways; lengths in cells.
struct Pair {
    double length = 0.0;
    double cells_length = 0.0;
    double pulled_length = 0.0;
    std::size_t num_cells = 0;
    std::size_t num_entries = 0;
    std::size_t num_cells_of_cells = 0;
    double ms = 0.0;
    double cells_ms = 0.0;
};

struct Measured {
    std::vector<Pair> pairs;
    /// Pairs of points that one search connects and the other does not.
    std::size_t num_unlike = 0;
    std::size_t num_unconnected = 0;
};

Cell random_place(const RobotFloor& floor, Random& random) {
    for (;;) {
        const std::size_t offset = random.below(floor.clearance_m.values.size());
        if (floor.clearance_m.values[offset] >= floor.radius_m) {
            return floor.clearance_m.cell(offset);
        }
    }
}

Measured measure_pairs(RoutePlanner& planner, std::size_t num_pairs) {
    const RobotFloor& floor = planner.floor();
    CellSearch cells(floor);
    Random random(kSeed);
    Measured measured;
    while (measured.pairs.size() < num_pairs && measured.num_unconnected < 20 * num_pairs) {
        const Cell from = random_place(floor, random);
        const Cell to = random_place(floor, random);
        const double begin = cpu_ms();
        const CellWay by_cells = cells.find(from, to);
        const double middle = cpu_ms();
        const std::optional<Route> route = planner.find(from, to);
        const double end = cpu_ms();
        if (by_cells.cells.empty() != !route) ++measured.num_unlike;
        if (by_cells.cells.empty() || !route) {
            ++measured.num_unconnected;
            continue;
        }
        if (from == to) continue;
        measured.pairs.push_back({route->length_m / floor.resolution_m, by_cells.length,
                                  pulled_length(by_cells, floor), route->num_cells_read,
                                  route->num_entries_read, by_cells.num_cells_read, end - middle,
                                  middle - begin});
    }
    return measured;
}

double total(const std::vector<Pair>& pairs, double Pair::*member) {
    double sum = 0.0;
    for (const Pair& pair : pairs) sum += pair.*member;
    return sum;
}
double total(const std::vector<Pair>& pairs, std::size_t Pair::*member) {
    double sum = 0.0;
    for (const Pair& pair : pairs) sum += static_cast<double>(pair.*member);
    return sum;
}

std::vector<double> lengths_over(const std::vector<Pair>& pairs, double Pair::*other) {
    std::vector<double> ratios;
    for (const Pair& pair : pairs) ratios.push_back(pair.length / pair.*other);
    std::sort(ratios.begin(), ratios.end());
    return ratios;
}

Json row_of(const std::string& name, const fs::path& path) {
    const GridMap map = io::read_map(path).map;
    const std::size_t num_cells = map.states.values.size();
    if (num_cells < kLeastCells) return {};
    const double before = cpu_ms();
    const Segmentation rooms = segment(map, {}, RunOptions{2});
    const double begin = cpu_ms();
    RoutePlanner planner(map, rooms, kRobotWidthM, Executor{2});
    const double made = cpu_ms();
    planner.prepare(Executor{2});
    const double prepared = cpu_ms();
    const Measured measured =
        measure_pairs(planner, num_cells < kHugeCells ? kNumPairs : kNumHugePairs);
    const std::vector<Pair>& pairs = measured.pairs;
    const auto n = static_cast<double>(std::max<std::size_t>(pairs.size(), 1));
    const std::vector<double> over_cells = lengths_over(pairs, &Pair::cells_length);
    const std::vector<double> over_pulled = lengths_over(pairs, &Pair::pulled_length);
    const double cells_read = total(pairs, &Pair::num_cells_of_cells);
    const double cells_ms = total(pairs, &Pair::cells_ms);
    return {
        {"input", name},
        {"cells", num_cells},
        {"rooms", rooms.rooms.size()},
        {"pairs", pairs.size()},
        {"unlike", measured.num_unlike},
        {"unconnected", measured.num_unconnected},
        {"mean_length_m", total(pairs, &Pair::length) * map.resolution_m / n},
        {"length_over_cells", total(pairs, &Pair::length) / total(pairs, &Pair::cells_length)},
        {"length_over_cells_99", quantile(over_cells, 0.99)},
        {"length_over_cells_most", over_cells.empty() ? 0.0 : over_cells.back()},
        {"length_over_pulled", total(pairs, &Pair::length) / total(pairs, &Pair::pulled_length)},
        {"length_over_pulled_99", quantile(over_pulled, 0.99)},
        {"length_over_pulled_most", over_pulled.empty() ? 0.0 : over_pulled.back()},
        {"cells_read", total(pairs, &Pair::num_cells) / n},
        {"entries_read", total(pairs, &Pair::num_entries) / n},
        {"cells_read_by_cells", cells_read / n},
        {"cells_percent", 100.0 * total(pairs, &Pair::num_cells) / cells_read},
        {"cells_and_entries_percent",
         100.0 * (total(pairs, &Pair::num_cells) + total(pairs, &Pair::num_entries)) / cells_read},
        {"ms", total(pairs, &Pair::ms) / n},
        {"ms_by_cells", cells_ms / n},
        {"time_percent", 100.0 * total(pairs, &Pair::ms) / cells_ms},
        {"segment_ms", begin - before},
        {"floor_ms", made - begin},
        {"prepare_ms", prepared - made},
        {"prepare_over_a_search", (prepared - made) / (cells_ms / n)},
        {"cells_prepared", planner.num_cells_prepared()},
        {"mib", static_cast<double>(planner.bytes()) / 1048576.0}};
}

int run(int argc, char** argv) {
    const bool has_text = argc > 1 && std::string_view(argv[argc - 1]) != output_path(argc, argv);
    Json rows = Json::array();
    for (const fs::path& path : map_paths(has_text ? argv[argc - 1] : "")) {
        Json row =
            row_of(path.parent_path().filename().string() + "/" + path.stem().string(), path);
        if (row.empty()) continue;
        result_file::round_numbers(row);
        std::printf("%s\n", row.dump().c_str());
        std::fflush(stdout);
        rows.push_back(std::move(row));
    }
    write_results(output_path(argc, argv), "route", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
