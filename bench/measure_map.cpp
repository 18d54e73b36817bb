// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// The quadtree map beside a flat grid and a plain pointer quadtree of the same cells: time to
// build, bytes, 10^7 random look-ups.
//   micro_map [-o FILE.json]
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/result_file.hpp"
#include "eval/cases.hpp"
#include "io/carmen.hpp"
#include "io/map_server.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "reproduce/flat_grid.hpp"
#include "reproduce/pointer_quadtree.hpp"

namespace quadcut {
namespace {

constexpr int kRepeats = 9;
constexpr std::size_t kNumLookups = 10'000'000;
constexpr std::size_t kPasses = 10;  // over a tenth as many cells

double milliseconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    return elapsed.count();
}

template <typename Work>
double median_of_nine(const Work& work) {
    std::vector<double> times(kRepeats);
    for (double& time : times) time = milliseconds(work);
    std::nth_element(times.begin(), times.begin() + kRepeats / 2, times.end());
    return times[kRepeats / 2];
}

struct Row {
    std::string world;
    std::string structure;
    double build_ms = 0.0;
    std::size_t bytes = 0;
    std::vector<double> times_ms;  // of the look-ups, ascending
    long long checksum = 0;

    [[nodiscard]] double median_ms() const { return times_ms[times_ms.size() / 2]; }
};

struct Built {
    double flat_ms = 0.0;
    double map_ms = 0.0;
    double tree_ms = 0.0;
};

/// 10^7 random look-ups in each structure, nine times in turn, so that what else the machine does
/// meets them alike. Prints the table, with ratios to the flat grid.
std::vector<Row> compare(const std::string& world, const Raster<std::int8_t>& box, Built built,
                         const FlatGrid& flat, const OccupancyMap& map,
                         const PointerQuadtree& tree) {
    Random random(1);
    std::vector<Cell> cells(kNumLookups / kPasses);
    for (Cell& cell : cells) {
        const auto pick = [&](std::int32_t low, std::int32_t count) {
            return low + static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(count)));
        };
        cell = {pick(box.origin.x, box.width), pick(box.origin.y, box.height)};
    }
    const auto look_up = [&](const auto& structure) {
        long long sum = 0;
        for (std::size_t pass = 0; pass < kPasses; ++pass) {
            for (const Cell& cell : cells) sum += structure.log_odds(cell);
        }
        return sum;
    };
    std::vector<Row> rows{{world, "flat grid", built.flat_ms, flat.bytes(), {}, 0},
                          {world, "quadcut", built.map_ms, map.bytes(), {}, 0},
                          {world, "pointer quadtree", built.tree_ms, tree.bytes(), {}, 0}};
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        rows[0].times_ms.push_back(milliseconds([&] { rows[0].checksum = look_up(flat); }));
        rows[1].times_ms.push_back(milliseconds([&] { rows[1].checksum = look_up(map); }));
        rows[2].times_ms.push_back(milliseconds([&] { rows[2].checksum = look_up(tree); }));
    }
    for (Row& row : rows) {
        std::sort(row.times_ms.begin(), row.times_ms.end());
        std::printf(
            "%-22s %-18s %10.1f ms %12zu bytes %6.1f %% %8.1f ms  x %.2f  (least x %.2f)%s\n",
            row.world.c_str(), row.structure.c_str(), row.build_ms, row.bytes,
            100.0 * static_cast<double>(row.bytes) / static_cast<double>(rows[0].bytes),
            row.median_ms(), row.median_ms() / rows[0].median_ms(),
            row.times_ms.front() / rows[0].times_ms.front(),
            row.checksum == rows[0].checksum ? "" : "  DIFFERENT CELLS");
    }
    return rows;
}

void set_box(Raster<CellState>& states, Cell low, Cell size, CellState state) {
    for (std::int32_t y = std::max(0, low.y); y < std::min(low.y + size.y, states.height); ++y) {
        for (std::int32_t x = std::max(0, low.x); x < std::min(low.x + size.x, states.width); ++x) {
            states.at({x, y}) = state;
        }
    }
}

/// A floor of offices at 5 cm: corridors 2.4 m wide every 18 m, rooms 3 to 8 m wide on both sides,
/// walls of 15 cm, doors of 0.9 m, some furniture; unknown around and in a fifth of the rooms.
GridMap office_floor(std::int32_t side) {
    GridMap grid{0.05, {}, Raster<CellState>({0, 0}, side, side)};
    Random random(7);
    const auto pick = [&](std::int32_t low, std::int32_t high) {
        return low +
               static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(high - low + 1)));
    };
    constexpr std::int32_t kMargin = 200;
    constexpr std::int32_t kCorridor = 48;
    constexpr std::int32_t kDepth = 156;
    constexpr std::int32_t kWall = 3;
    for (std::int32_t y = kMargin; y + kCorridor + 2 * kDepth < side - kMargin;
         y += kCorridor + 2 * kDepth) {
        const std::int32_t corridor = y + kDepth;
        set_box(grid.states, {kMargin, y}, {side - 2 * kMargin, kCorridor + 2 * kDepth},
                CellState::occupied);
        for (const bool above : {false, true}) {
            const std::int32_t low = above ? corridor + kCorridor + kWall : y + kWall;
            for (std::int32_t x = kMargin + kWall; x < side - kMargin - 160;) {
                const std::int32_t width = pick(60, 160);
                const bool seen = pick(0, 4) != 0;
                set_box(grid.states, {x, low}, {width, kDepth - 2 * kWall},
                        seen ? CellState::free : CellState::unknown);
                for (std::int32_t i = seen ? pick(0, 6) : 0; i > 0; --i) {
                    set_box(grid.states, {x + pick(0, width - 30), low + pick(0, 120)},
                            {pick(1, 30), pick(1, 16)}, CellState::occupied);
                }
                if (seen) {
                    const std::int32_t door = above ? low - kWall : low + kDepth - 2 * kWall;
                    set_box(grid.states, {x + pick(4, width - 24), door}, {18, kWall},
                            CellState::free);
                }
                x += width + kWall;
            }
        }
        set_box(grid.states, {kMargin + kWall, corridor},
                {side - 2 * kMargin - 2 * kWall, kCorridor}, CellState::free);
    }
    return grid;
}

std::vector<Row> bench_raster(const std::string& name, const GridMap& grid) {
    const Raster<CellState>& states = grid.states;
    std::unique_ptr<OccupancyMap> map;
    const double map_ms = median_of_nine(
        [&] { map = std::make_unique<OccupancyMap>(OccupancyMap::from_grid(grid)); });
    const Raster<CellState> known = map->to_raster();
    const Raster<std::int8_t> box(known.origin, known.width, known.height);
    const auto fill = [&](auto& structure) {
        for (std::size_t i = 0; i < box.values.size(); ++i) {
            const Cell cell = box.cell(i);
            const CellState state = states.at(cell);
            structure.set(cell, state == CellState::unknown ? 0
                                : state == CellState::free  ? kMinLogOdds
                                                            : kMaxLogOdds);
        }
    };
    FlatGrid flat(box);
    const double flat_ms = median_of_nine([&] {
        flat = FlatGrid(box);
        fill(flat);
    });
    PointerQuadtree tree(map->root());
    const double tree_ms = milliseconds([&] { fill(tree); });
    return compare(name, box, {flat_ms, map_ms, tree_ms}, flat, *map, tree);
}

std::vector<Row> bench_log(const std::string& name, const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) {
        std::printf("%s: left out, there is no %s\n", name.c_str(), path.c_str());
        return {};
    }
    const std::vector<Scan> log = io::read_carmen_log(path).scans;
    std::vector<std::vector<TileEvidence>> scans;
    OccupancyMap map(0.05);
    for (const Scan& scan : log) {
        scans.push_back(evidence_of(map, scan));
        add_evidence(map, scans.back());
        map.commit();
    }
    const double map_ms = median_of_nine([&] {
        map = OccupancyMap(0.05);
        for (const std::vector<TileEvidence>& scan : scans) {
            add_evidence(map, scan);
            map.commit();
        }
    });
    const Raster<CellState> known = map.to_raster();
    const Raster<std::int8_t> box(known.origin, known.width, known.height);
    FlatGrid flat(box);
    const double flat_ms = median_of_nine([&] {
        flat = FlatGrid(box);
        replay(flat, scans);
    });
    PointerQuadtree tree(map.root());
    const double tree_ms = milliseconds([&] { replay(tree, scans); });
    return compare(name, box, {flat_ms, map_ms, tree_ms}, flat, map, tree);
}

/// Bytes only, of every map with hand-made rooms.
void print_bytes_of_rooms(const std::filesystem::path& folder) {
    if (!std::filesystem::exists(folder)) {
        std::printf("rooms: left out, there is no %s\n", folder.c_str());
        return;
    }
    std::vector<double> shares;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".yaml") continue;
        const OccupancyMap map = OccupancyMap::from_grid(io::read_map(entry.path()).map);
        shares.push_back(100.0 * static_cast<double>(map.bytes()) /
                         static_cast<double>(map.to_raster().values.size()));
    }
    std::sort(shares.begin(), shares.end());
    std::printf(
        "%zu maps with rooms: %.1f %% to %.1f %% of the flat grid's bytes, median %.1f %%\n",
        shares.size(), shares.front(), shares.back(), shares[shares.size() / 2]);
}

Json json_of(const std::vector<Row>& rows) {
    Json json = Json::array();
    for (const Row& row : rows) {
        json.push_back({{"input", row.world},
                        {"structure", row.structure},
                        {"build_ms", row.build_ms},
                        {"bytes", row.bytes},
                        {"ten_million_lookups_ms", row.median_ms()}});
    }
    return json;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) {
    using quadcut::Row;
    const std::filesystem::path logs = std::filesystem::path(QUADCUT_SHARED_DIR) / "data/logs";
    std::printf("%-22s %-18s %13s %18s %8s %11s\n", "map", "structure", "build", "memory",
                "of flat", "look-ups");
    std::vector<Row> rows = quadcut::bench_log("intel.log", logs / "intel.log");
    for (const Row& row : quadcut::bench_log("mit_csail.log", logs / "mit_csail.log")) {
        rows.push_back(row);
    }
    for (const Row& row :
         quadcut::bench_raster("office 10,000 x 10,000", quadcut::office_floor(10'000))) {
        rows.push_back(row);
    }
    quadcut::print_bytes_of_rooms(logs / "../rooms");
    quadcut::write_results(quadcut::output_path(argc, argv), "map", quadcut::json_of(rows));
    return 0;
}
