// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Follows logs and buildings: the same answer as the batch, bounded work, ids that survive.
//   measure_follow logs [LOG ...]     dense logs, with plots in build/follow
//   measure_follow buildings [N]      simulated buildings (50), some in another order of scans
//   measure_follow order [LOG ...]    sparse logs in another order
//   measure_follow kills [N]          a followed project, killed so often (100)
//   measure_follow locate             look-ups
//   measure_follow ring [M ...]       a corridor around buildings of these lengths (60 120 240 480)
// Without a word: all of it. With -o FILE.json: a file of results, too.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "bench/building_case.hpp"
#include "bench/cases.hpp"
#include "bench/follow_log.hpp"
#include "bench/result_file.hpp"
#include "eval/labels.hpp"
#include "io/carmen.hpp"
#include "io/file.hpp"
#include "project/project_file.hpp"
#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

std::filesystem::path logs_folder() {
    return std::filesystem::path(QUADCUT_SHARED_DIR) / "data/logs";
}

std::filesystem::path output_folder() {
    std::filesystem::path folder = std::filesystem::path(QUADCUT_SOURCE_DIR) / "build/follow";
    std::filesystem::create_directories(folder);
    return folder;
}

/// A value of each update in some quarters of the log (0 to 4), ascending.
std::vector<double> sorted(const FollowedLog& log, int first, int last, bool only_cuts,
                           const std::function<double(std::size_t)>& value) {
    std::vector<double> values;
    const std::size_t n = log.updates.size();
    for (std::size_t i = n * static_cast<std::size_t>(first) / 4;
         i < n * static_cast<std::size_t>(last) / 4; ++i) {
        if (!only_cuts || log.updates[i].graph_nodes > 0) values.push_back(value(i));
    }
    std::sort(values.begin(), values.end());
    return values;
}

double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
}

void draw(const std::string& name, const FollowedLog& log) {
    Curve ps{"ps, %", {}};
    Curve touched{"nodes touched / all, %", {}};
    Curve integrate{"quadtree, ms a scan", {}};
    Curve nodes{"local", {}};
    Curve relabelled{"relabelled, m2 an update", {}};
    const std::size_t step = std::max<std::size_t>(1, log.updates.size() / 800);
    for (std::size_t i = 0; i < log.updates.size(); ++i) {
        const FollowUpdate& update = log.updates[i];
        const auto at = static_cast<double>(i);
        if (update.graph_nodes > 0) {
            nodes.points.push_back({at, static_cast<double>(update.graph_nodes)});
            relabelled.points.push_back({at, update.relabelled_m2});
        }
        if (i % step != 0) continue;
        const double all = (4.0 * static_cast<double>(update.num_leaves) - 1.0) / 3.0;
        ps.points.push_back({at, 100.0 * update.ps});
        touched.points.push_back({at, 100.0 * static_cast<double>(update.nodes_touched) / all});
        integrate.points.push_back({at, update.integrate_ms});
    }
    const auto write = [&](const char* what, const Plot& plot) {
        io::write_file_atomically(output_folder() / (name + "_" + what + ".svg"), to_svg(plot));
    };
    write("ps", {name + ": share of the tree that a scan reaches (Fig 13)",
                 "scan",
                 "%",
                 {ps, touched},
                 100.0});
    write("kd_tree",
          {name + ": a scan into the map (Fig 13)", "scan", "ms", {integrate, log.kd_tree_ms}});
    write("matrix",
          {name + ": size of the matrix (Fig 14)", "scan", "nodes", {nodes, log.batch_nodes}});
    write("ids", {name + ": stability", "scan", "", {relabelled, log.switches}});
    write("memory", {name + ": memory", "scan", "bytes a m2", {log.bytes_per_m2}});
}

Json agreement_of(const Agreement& agreement) {
    return {{"pq", agreement.pq},
            {"ari", agreement.ari},
            {"rooms", agreement.num_rooms},
            {"batch_rooms", agreement.num_batch_rooms}};
}

void add_local_graph(const FollowedLog& log, Json& row) {
    const auto nodes = [&](std::size_t i) {
        return static_cast<double>(log.updates[i].graph_nodes);
    };
    const std::vector<double> second = sorted(log, 1, 2, true, nodes);
    const std::vector<double> last = sorted(log, 3, 4, true, nodes);
    row["largest_local_graph"] = quantile(last, 1.0);
    row["batch_nodes"] = log.at_end.batch_nodes;
    row["local_graph_p99_second_quarter"] = quantile(second, 0.99);
    row["local_graph_p99_last_quarter"] = quantile(last, 0.99);
}

void add_times(const FollowedLog& log, Json& row) {
    const auto ms = [&](std::size_t i) { return log.updates[i].segment_ms; };
    const auto over_cast = [&](int first, int end) {
        // Single scans are too short to be timed well: against the mean of their quarter.
        const std::vector<double> cast =
            sorted(log, first, end, false, [&](std::size_t i) { return log.ray_caster_ms[i]; });
        return quantile(sorted(log, first, end, true, ms), 0.99) /
               (sum(cast) / static_cast<double>(std::max<std::size_t>(1, cast.size())));
    };
    const std::vector<double> cuts = sorted(log, 0, 4, true, ms);
    row["cuts"] = cuts.size();
    row["cut_median_ms"] = quantile(cuts, 0.5);
    row["cut_p99_ms"] = quantile(cuts, 0.99);
    row["cut_p99_over_ray_caster_second_quarter"] = over_cast(1, 2);
    row["cut_p99_over_ray_caster_last_quarter"] = over_cast(3, 4);
    const auto num_scans = static_cast<double>(log.updates.size());
    row["integrate_ms_a_scan"] =
        sum(sorted(log, 0, 4, false, [&](std::size_t i) { return log.updates[i].integrate_ms; })) /
        num_scans;
    row["ray_caster_ms_a_scan"] = sum(log.ray_caster_ms) / num_scans;
    row["follow_s"] = log.follow_s;
    row["times_real_time"] = log.log_s / std::max(log.follow_s, 1e-9);
    double kd_ms = 0.0;
    for (const Point& point : log.kd_tree_ms.points) kd_ms += point.y;
    row["kd_tree_ms_a_scan"] =
        kd_ms / static_cast<double>(std::max<std::size_t>(1, log.kd_tree_ms.points.size()));
}

void add_changes(const FollowedLog& log, Json& row) {
    const std::vector<double> ps =
        sorted(log, 0, 4, false, [&](std::size_t i) { return 100.0 * log.updates[i].ps; });
    const std::vector<double> touched = sorted(log, 0, 4, false, [&](std::size_t i) {
        const FollowUpdate& update = log.updates[i];
        return 100.0 * static_cast<double>(update.nodes_touched) /
               ((4.0 * static_cast<double>(update.num_leaves) - 1.0) / 3.0);
    });
    const auto num_below =
        std::count_if(ps.begin(), ps.end(), [](double share) { return share <= 25.0; });
    row["ps_median_percent"] = quantile(ps, 0.5);
    row["ps_at_most_25_percent_of_scans"] =
        percent(static_cast<std::size_t>(num_below), log.updates.size());
    row["nodes_touched_median_percent"] = quantile(touched, 0.5);
    row["id_switches_a_100_scans"] =
        static_cast<double>(log.num_switches) /
        static_cast<double>(std::max<std::size_t>(1, log.switches.points.size()));
    const std::vector<double> relabelled =
        sorted(log, 0, 4, true, [&](std::size_t i) { return log.updates[i].relabelled_m2; });
    row["relabelled_median_percent"] = 100.0 * quantile(relabelled, 0.5) / log.mapped_m2;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const Point& point : log.bytes_per_m2.points) {
        least = std::min(least, point.y);
        most = std::max(most, point.y);
    }
    row["bytes_a_m2_least"] = least;
    row["bytes_a_m2_most"] = most;
}

Json report(const std::string& name, const FollowedLog& log) {
    Json row;
    row["part"] = "log";
    row["input"] = name;
    row["scans"] = log.updates.size();
    row["mapped_m2"] = log.mapped_m2;
    row["tenths_pq"] = Json::array();
    for (const Agreement& tenth : log.tenths) row["tenths_pq"].push_back(tenth.pq);
    row["at_end"] = agreement_of(log.at_end);
    row["finished"] = agreement_of(log.finished);
    add_local_graph(log, row);
    add_times(log, row);
    add_changes(log, row);
    std::printf("%s\n", row.dump(2).c_str());
    std::fflush(stdout);
    draw(name, log);
    return row;
}

void follow_logs(std::vector<std::string> names, Json& rows) {
    if (names.empty()) {
        names = {"intel_dense.log.gz", "mit_csail_dense.log.gz", "aces_dense.log.gz",
                 "mit_killian_dense.log.gz"};
    }
    for (const std::string& name : names) {
        const io::LogFile file = io::read_carmen_log(logs_folder() / name);
        rows.push_back(report(name.substr(0, name.find('.')), follow_log_of(file.scans)));
    }
    std::printf("Plots: build/follow\n");
}

/// PQ between the rooms of the scans and of the same scans in another order. Both maps cover the
/// same cells but for a few at their edges.
double pq_in_another_order(const std::vector<Scan>& scans, std::uint64_t seed) {
    std::vector<Scan> shuffled = scans;
    Random random(seed);
    for (std::size_t i = shuffled.size(); i > 1; --i) {
        std::swap(shuffled[i - 1], shuffled[random.below(i)]);
    }
    Follower one;
    Follower other;
    for (const Scan& scan : scans) one.add_scan(scan);
    for (const Scan& scan : shuffled) other.add_scan(scan);
    one.finish();
    other.finish();
    Box box = one.map().to_raster().box();
    box.include(other.map().to_raster().box());
    Raster<std::uint32_t> a(box);
    Raster<std::uint32_t> b(box);
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        a.values[i] = one.state().cells.room(a.cell(i));
        b.values[i] = other.state().cells.room(b.cell(i));
    }
    return 100.0 * eval::score_rooms(as_label_image(a), as_label_image(b)).pq;
}

void follow_buildings(std::size_t count, Json& rows) {
    // In any order each scan changes rooms somewhere: ten times the work.
    constexpr int kMaxShuffledRooms = 14;
    struct Result {
        Agreement agreement;
        double shuffled_pq = -1.0;
    };
    const std::vector<Result> results = run_cases<Result>(count, [&](std::size_t i) {
        const BuildingCase chosen = building_case(i);
        const std::vector<Scan> scans = scans_of(chosen, building_of(chosen));
        const RunOptions run{1};
        Follower follower({}, run);
        std::vector<Point> way;
        for (const Scan& scan : scans) {
            follower.add_scan(scan);
            way.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
        }
        Result result{compare_with_batch(follower, way, {}, run)};
        if (chosen.num_rooms <= kMaxShuffledRooms)
            result.shuffled_pq = pq_in_another_order(scans, i);
        return result;
    });
    std::vector<double> pq;
    std::vector<double> ari;
    std::vector<double> shuffled;
    for (const Result& result : results) {
        pq.push_back(result.agreement.pq);
        ari.push_back(result.agreement.ari);
        if (result.shuffled_pq >= 0.0) shuffled.push_back(result.shuffled_pq);
    }
    std::sort(pq.begin(), pq.end());
    std::sort(ari.begin(), ari.end());
    std::sort(shuffled.begin(), shuffled.end());
    const auto mean = [](const std::vector<double>& values) {
        return sum(values) / static_cast<double>(std::max<std::size_t>(1, values.size()));
    };
    std::printf(
        "%zu simulated buildings, after the last scan: PQ mean %.1f, median %.1f, least %.1f, "
        "%td below 96; ARI mean %.3f, least %.3f\n",
        count, mean(pq), quantile(pq, 0.5), quantile(pq, 0.0),
        std::lower_bound(pq.begin(), pq.end(), 96.0) - pq.begin(), mean(ari), quantile(ari, 0.0));
    std::printf("  scans in another order, %zu of them: PQ mean %.1f, least %.1f\n",
                shuffled.size(), mean(shuffled), quantile(shuffled, 0.0));
    std::fflush(stdout);
    rows.push_back({{"part", "buildings"},
                    {"buildings", count},
                    {"pq_mean", mean(pq)},
                    {"pq_least", quantile(pq, 0.0)},
                    {"ari_mean", mean(ari)},
                    {"ari_least", quantile(ari, 0.0)},
                    {"shuffled", shuffled.size()},
                    {"shuffled_pq_mean", mean(shuffled)},
                    {"shuffled_pq_least", quantile(shuffled, 0.0)}});
}

void follow_in_another_order(std::vector<std::string> names, Json& rows) {
    if (names.empty()) names = {"intel.log", "mit_csail.log", "aces.log"};
    for (const std::string& name : names) {
        const io::LogFile file = io::read_carmen_log(logs_folder() / name);
        const double pq = pq_in_another_order(file.scans, 1);
        rows.push_back({{"part", "order"}, {"input", name}, {"pq", pq}});
        std::printf("%s, scans in another order: PQ %.1f\n", name.c_str(), pq);
        std::fflush(stdout);
    }
}

/// The bytes of a result's files, without times.
std::map<std::string, std::string> untimed(const std::filesystem::path& folder) {
    static const std::regex times(R"("[a-z_]*_ms": ?(\{[^}]*\}|[^,}\n]*))");
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files[entry.path().filename()] = std::regex_replace(io::read_file(entry.path()), times, "");
    }
    return files;
}

void kill_often(std::size_t count, Json& rows) {
    const std::filesystem::path folder = output_folder() / "kills";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const std::string program =
        (std::filesystem::path(QUADCUT_SOURCE_DIR) / "build/release/quadcut").string();
    const auto run = [&](const std::string& words) {
        return std::system(
            ("cd '" + folder.string() + "' && " + words + " >/dev/null 2>&1").c_str());
    };
    run(program + " simulate -o sim --seed 2 --rooms 10");
    const std::string follow = program + " follow sim/robot.log --quiet -o ";
    const auto start = std::chrono::steady_clock::now();
    run(follow + "whole");
    const double whole_s = ms_since(start) / 1000.0;
    Random random(static_cast<std::uint64_t>(start.time_since_epoch().count()));
    std::size_t num_kills = 0;
    std::size_t num_differing = 0;
    std::size_t num_damaged = 0;
    std::size_t num_runs = 0;
    while (num_kills < count) {
        ++num_runs;
        for (const char* name : {"p", "p-wal", "p-shm", "p.new"}) {
            std::filesystem::remove(folder / name);
        }
        std::filesystem::remove_all(folder / "out");
        for (;;) {
            const double after_s = random.uniform(0.001, 0.6 * whole_s);
            const int status = run("timeout -s KILL " + std::to_string(after_s) + " " + follow +
                                   "out --project p");
            if (status == 0) break;
            ++num_kills;
            if (!std::filesystem::exists(folder / "p")) continue;
            try {
                const project::ProjectFile file(folder / "p", Access::read);
                if (file.integrity() != "ok") ++num_damaged;
                static_cast<void>(file.follower({}));
            } catch (const std::exception& error) {
                std::printf("  %s\n", error.what());
                ++num_damaged;
            }
        }
        if (untimed(folder / "out") != untimed(folder / "whole")) ++num_differing;
    }
    std::printf("killed %zu times in %zu runs: %zu files damaged, %zu results differ\n", num_kills,
                num_runs, num_damaged, num_differing);
    std::fflush(stdout);
    rows.push_back({{"part", "kills"},
                    {"kills", num_kills},
                    {"runs", num_runs},
                    {"damaged", num_damaged},
                    {"differing", num_differing}});
}

void locate_often(Json& rows) {
    const sim::Building building = building_of(building_case(6));
    Follower follower;
    follower.update_cells(building.map.states);
    Random random(1);
    constexpr std::size_t kCount = 1000000;
    std::vector<Point> points(kCount);
    for (Point& point : points) {
        point = {random.uniform(0.0, building.map.states.width * 0.05),
                 random.uniform(0.0, building.map.states.height * 0.05)};
    }
    std::size_t checksum = 0;
    const auto start = std::chrono::steady_clock::now();
    for (const Point& point : points) checksum += index(follower.room_at(point));
    const double ms = ms_since(start);
    std::printf("locate: %.0f ns a point (%zu points, checksum %zu)\n",
                1e6 * ms / static_cast<double>(kCount), kCount, checksum);
    rows.push_back({{"part", "locate"}, {"ns_a_point", 1e6 * ms / static_cast<double>(kCount)}});
}

/// A building of so many metres by two thirds of it: a corridor of 2.5 m all around, with rooms of
/// 5 m x 5 m on its outer side, each behind a door of 0.9 m.
Raster<CellState> ring_building(std::int32_t length_m) {
    constexpr std::int32_t kMetre = 20;
    constexpr std::int32_t kWall = 4;
    constexpr std::int32_t kRoom = 5 * kMetre;
    constexpr std::int32_t kCorridor = 5 * kMetre / 2;
    constexpr std::int32_t kDoor = 9 * kMetre / 10;
    const std::int32_t width = length_m * kMetre;
    const std::int32_t height = width * 2 / 3;
    Raster<CellState> states({0, 0}, width, height, CellState::occupied);
    const auto clear = [&](const Box& box) {
        for_each_cell(box.intersected(states.box()),
                      [&](Cell cell) { states.at(cell) = CellState::free; });
    };
    const Cell low{kRoom + 2 * kWall, kRoom + 2 * kWall};
    const Cell high{width - 1 - low.x, height - 1 - low.y};
    clear({low, {high.x, low.y + kCorridor - 1}});
    clear({{low.x, high.y - kCorridor + 1}, high});
    clear({low, {low.x + kCorridor - 1, high.y}});
    clear({{high.x - kCorridor + 1, low.y}, high});
    for (std::int32_t x = low.x; x + kRoom <= high.x; x += kRoom + kWall) {
        for (const std::int32_t y : {kWall, height - kWall - kRoom}) {
            clear({{x, y}, {x + kRoom - 1, y + kRoom - 1}});
            const std::int32_t wall = y == kWall ? low.y - kWall : high.y + 1;
            clear({{x + 2 * kMetre, wall}, {x + 2 * kMetre + kDoor - 1, wall + kWall - 1}});
        }
    }
    return states;
}

/// What an update costs where the corridor goes around the whole building: one place of it is shut
/// off and opened again, all around.
void go_around(const std::vector<std::string>& lengths, Json& rows) {
    for (const std::string& length : lengths) {
        const auto length_m = static_cast<std::int32_t>(std::atol(length.c_str()));
        Follower follower;
        const Raster<CellState> states = ring_building(length_m);
        follower.update_cells(states);
        while (follower.refine()) {
        }
        std::vector<double> ms;
        std::vector<double> cells;
        const std::int32_t y = 5 * 20 + 8 + 20;
        for (std::int32_t x = 200; x + 200 < states.width; x += states.width / 20) {
            for (const CellState state : {CellState::occupied, CellState::free}) {
                const FollowUpdate update =
                    follower.update_cells(Raster<CellState>({x, y}, 12, 12, state));
                ms.push_back(update.segment_ms);
                cells.push_back(static_cast<double>(update.cells_read));
            }
        }
        std::sort(ms.begin(), ms.end());
        std::sort(cells.begin(), cells.end());
        std::printf(
            "ring of %d m x %d m, %zu rooms: an update looks at %.0f cells (most %.0f) in "
            "%.1f ms (most %.1f)\n",
            length_m, length_m * 2 / 3, follower.num_rooms(), quantile(cells, 0.5),
            quantile(cells, 1.0), quantile(ms, 0.5), quantile(ms, 1.0));
        std::fflush(stdout);
        rows.push_back({{"part", "ring"},
                        {"length_m", length_m},
                        {"rooms", follower.num_rooms()},
                        {"updates", ms.size()},
                        {"cells_median", quantile(cells, 0.5)},
                        {"cells_most", quantile(cells, 1.0)},
                        {"update_median_ms", quantile(ms, 0.5)},
                        {"update_most_ms", quantile(ms, 1.0)}});
    }
}

int run(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const std::string output = take_output_path(words);
    const std::string what = words.empty() ? "" : words.front();
    const std::vector<std::string> rest(words.begin() + (words.empty() ? 0 : 1), words.end());
    const auto number = [&](std::size_t otherwise) {
        return rest.empty() ? otherwise : static_cast<std::size_t>(std::atol(rest[0].c_str()));
    };
    Json rows = Json::array();
    if (what.empty() || what == "locate") locate_often(rows);
    if (what.empty() || what == "ring") {
        go_around(rest.empty() ? std::vector<std::string>{"60", "120", "240", "480"} : rest, rows);
    }
    if (what.empty() || what == "buildings") follow_buildings(number(50), rows);
    if (what.empty() || what == "order") follow_in_another_order(rest, rows);
    if (what.empty() || what == "logs") follow_logs(rest, rows);
    if (what.empty() || what == "kills") kill_often(number(100), rows);
    write_results(output, "follow", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
