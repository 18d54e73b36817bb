// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// The preset `paper`: following against the whole map, its map rule, what it depends on.
//   measure_paper follow [LOG ...]     followed against the batch of the same map (mit_csail,
//   intel,
//                                      and simulated buildings), by map rule
//   measure_paper same                 other order of scans, other origin
//   measure_paper sliver               with and without the rule that drops slivers
//   measure_paper queue                pairs in a queue, a deep copy of the tree for each part
//   measure_paper collapse             subtrees that only collapse where a scan sees all of them
// Without a word: all of it. With -o FILE.json: a file of results, too.
#include <array>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/building_case.hpp"
#include "bench/cases.hpp"
#include "bench/cpu_time.hpp"
#include "bench/data_map.hpp"
#include "bench/follow_log.hpp"
#include "bench/observed_collapse.hpp"
#include "bench/pair_queue.hpp"
#include "bench/result_file.hpp"
#include "bench/shared_folder.hpp"
#include "eval/labels.hpp"
#include "io/carmen.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {
namespace {

constexpr double kResolutionM = 0.05;
constexpr std::size_t kNumBuildings = 6;
constexpr std::uint64_t kNumOrders = 3;

/// Scans, and true rooms if they are known.
struct PaperCase {
    std::string name;
    std::vector<Scan> scans;
    GridMap true_map;
    Raster<std::uint32_t> truth;
};

std::vector<Point> way_of(const std::vector<Scan>& scans) {
    std::vector<Point> way;
    for (const Scan& scan : scans) {
        way.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
    }
    return way;
}

PaperCase log_case(const std::string& name) {
    PaperCase log{name, io::read_carmen_log(shared_path("data/logs") / name).scans, {}, {}};
    if (name != "intel.log") return log;
    log.true_map = io::read_map(shared_path("data/logs/intel.gt.yaml")).map;
    log.truth = as_raster(io::read_label_image(shared_path("data/logs/intel.gt_rooms.png")));
    return log;
}

std::vector<PaperCase> cases(std::vector<std::string> logs) {
    const bool is_all = logs.empty();
    if (is_all) logs = {"mit_csail.log", "intel.log"};
    std::vector<PaperCase> all;
    for (const std::string& name : logs) all.push_back(log_case(name));
    for (std::size_t i = 0; is_all && i < kNumBuildings; ++i) {
        const BuildingCase chosen = building_case(i);
        sim::Building building = building_of(chosen);
        std::vector<Scan> scans = scans_of(chosen, building);
        Raster<std::uint32_t> truth(building.labels.box());
        std::copy(building.labels.values.begin(), building.labels.values.end(),
                  truth.values.begin());
        all.push_back({"building " + std::to_string(i + 1) + ", " + name_of(chosen),
                       std::move(scans), std::move(building.map), std::move(truth)});
    }
    return all;
}

FollowOptions options_of(const std::string& rule) {
    FollowOptions options;
    options.segment.preset = Preset::paper;
    options.resolution_m = kResolutionM;
    if (rule == "latest scan wins") options.integrate = latest_scan_wins();
    return options;
}

double pq(const Raster<std::uint16_t>& labels, const Raster<std::uint16_t>& others) {
    return 100.0 * eval::score_rooms(as_label_image(labels), as_label_image(others)).pq;
}

/// Followed against the whole, and both against the truth.
void follow_one(const PaperCase& log, const std::string& rule, Json& rows) {
    const FollowOptions options = options_of(rule);
    Follower follower(options);
    std::size_t most = 0;
    std::size_t num_cuts = 0;
    std::size_t sum = 0;
    for (const Scan& scan : log.scans) {
        const FollowUpdate update = follower.add_scan(scan);
        most = std::max(most, update.graph_nodes);
        sum += update.graph_nodes;
        num_cuts += update.graph_nodes > 0 ? 1 : 0;
    }
    follower.finish();
    const GridMap map = follower.map().to_grid();
    const Segmentation batch = segment(map, options.segment, {}, way_of(log.scans));
    const Segmentation followed = follower.rooms();
    Json row{{"part", "follow"},
             {"input", log.name},
             {"rule", rule},
             {"pq", pq(followed.labels, batch.labels)},
             {"rooms", followed.rooms.size()},
             {"batch_rooms", batch.rooms.size()},
             {"cuts", num_cuts},
             {"nodes_mean", num_cuts == 0 ? 0 : sum / num_cuts},
             {"nodes_most", most},
             {"batch_nodes", batch.report.num_leaves}};
    std::printf("%s, %s: PQ %.1f against the whole map (%zu and %zu submaps)", log.name.c_str(),
                rule.c_str(), row["pq"].get<double>(), followed.rooms.size(), batch.rooms.size());
    if (!log.truth.values.empty()) {
        const io::LabelImage truth = as_label_image(labels_at(log.true_map, log.truth, map));
        const auto against = [&](const Segmentation& rooms) {
            return 100.0 * eval::score_rooms(as_label_image(rooms.labels), truth).pq;
        };
        row["true_pq_batch"] = against(batch);
        row["true_pq_followed"] = against(followed);
        std::printf(", against the truth %.1f, followed %.1f", against(batch), against(followed));
    }
    std::printf("\n");
    std::fflush(stdout);
    rows.push_back(std::move(row));
}

Segmentation batch_of(const std::vector<Scan>& scans, const std::string& rule, GridMap& map) {
    const FollowOptions options = options_of(rule);
    map = map_from_scans(scans, kResolutionM, options.integrate).to_grid();
    return segment(map, options.segment, {}, way_of(scans));
}

/// The whole map's submaps when the scans come in another order, or in a frame that is moved.
void same_one(const PaperCase& log, const std::string& rule, Json& rows) {
    GridMap map;
    const Segmentation rooms = batch_of(log.scans, rule, map);
    const auto compare = [&](std::vector<Scan> scans, const Point& moved) {
        for (Scan& scan : scans) {
            scan.world_from_sensor.x += moved.x;
            scan.world_from_sensor.y += moved.y;
        }
        GridMap other;
        const Segmentation again = batch_of(scans, rule, other);
        other.map_from_image.x -= moved.x;
        other.map_from_image.y -= moved.y;
        return 100.0 * eval::score_rooms(as_label_image(labels_at(other, again.labels, map)),
                                         as_label_image(rooms.labels))
                           .pq;
    };
    double order = 0.0;
    for (std::uint64_t seed = 1; seed <= kNumOrders; ++seed) {
        std::vector<Scan> scans = log.scans;
        Random random(seed);
        for (std::size_t i = scans.size(); i > 1; --i) {
            std::swap(scans[i - 1], scans[random.below(i)]);
        }
        order += compare(std::move(scans), {}) / static_cast<double>(kNumOrders);
    }
    double origin = 0.0;
    const std::array<Point, 3> moves{{{1.85, 1.05}, {0.55, 0.25}, {3.2, 4.5}}};
    for (const Point& moved : moves) origin += compare(log.scans, moved) / 3.0;
    std::printf("%s, %s: PQ %.1f in another order, %.1f at another origin\n", log.name.c_str(),
                rule.c_str(), order, origin);
    std::fflush(stdout);
    rows.push_back({{"part", "same"},
                    {"input", log.name},
                    {"rule", rule},
                    {"order_pq", order},
                    {"origin_pq", origin}});
}

void drop_slivers(Json& rows) {
    for (const double min_leaf_m : {0.4, 0.0}) {
        SegmentOptions options = options_of("").segment;
        options.paper.min_leaf_m = min_leaf_m;
        std::map<std::string, std::pair<double, double>> sums;
        double labelled = 0.0;
        double num_submaps = 0.0;
        const std::vector<DataMap> maps = read_data_maps();
        for (const DataMap& map : maps) {
            const Segmentation rooms = segment(map.map, options);
            const eval::RoomScore score = eval::score_rooms(as_label_image(rooms.labels),
                                                            as_label_image(as_raster(map.truth)));
            sums[map.kind].first += 100.0 * score.pq;
            sums[map.kind].second += 1.0;
            labelled += 100.0 * score.cover / static_cast<double>(maps.size());
            num_submaps += static_cast<double>(rooms.rooms.size());
        }
        Json row{{"part", "sliver"},
                 {"min_leaf_m", min_leaf_m},
                 {"submaps", num_submaps},
                 {"cover", labelled}};
        std::printf("leaf of %.1f m at least: %.0f submaps, cover %.2f %%", min_leaf_m, num_submaps,
                    labelled);
        for (const auto& [kind, sum] : sums) {
            row["pq_" + kind] = sum.first / sum.second;
            std::printf(", %s %.1f", kind.c_str(), sum.first / sum.second);
        }
        std::printf("\n");
        rows.push_back(std::move(row));
    }
}

void queue_pairs(Json& rows) {
    const PaperCase log = log_case("mit_csail.log");
    const FreeLeaves leaves = free_leaves(map_from_scans(log.scans, kResolutionM).to_grid());
    const std::size_t num_edges =
        sight_edges(leaves.table, leaves.nodes, kResolutionM, SelfLoops::none).size();
    for (const std::size_t parts : {1, 2, 4, 8, 16}) {
        std::size_t found = 0;
        std::vector<std::function<void()>> works{
            [&] { found = edges_by_queue(leaves, kResolutionM, parts).size(); },
            [&] {
                static_cast<void>(sight_edges(leaves.table, leaves.nodes, kResolutionM,
                                              SelfLoops::none, Executor{static_cast<int>(parts)}));
            }};
        const std::vector<double> ms = least_ms(5, works);
        std::printf("%zu parts: queue and copies %.1f ms, shared tree %.1f ms, %zu of %zu edges\n",
                    parts, ms[0], ms[1], found, num_edges);
        rows.push_back({{"part", "queue"},
                        {"parts", parts},
                        {"queue_ms", ms[0]},
                        {"shared_ms", ms[1]},
                        {"same_edges", found == num_edges}});
    }
}

void collapse(Json& rows) {
    for (const char* name : {"mit_csail.log", "intel.log"}) {
        const PaperCase log = log_case(name);
        // Blocks aligned to cell (0, 0).
        OccupancyMap map(kResolutionM, {}, Root{{-4096, -4096}, 13});
        ObservedCollapse observed;
        for (const Scan& scan : log.scans) {
            const auto evidence = evidence_of(map, scan, latest_scan_wins());
            add_evidence(map, evidence, latest_scan_wins());
            map.commit();
            observed.add(map, evidence);
        }
        std::size_t ours = 0;
        for (const Leaf& leaf : map.leaves()) ours += leaf.state == CellState::free ? 1 : 0;
        const std::size_t theirs = observed.num_free_leaves(map);
        std::printf("%s: %zu free leaves; collapsing only what one scan sees whole: %zu\n", name,
                    ours, theirs);
        rows.push_back({{"part", "collapse"},
                        {"input", name},
                        {"free_leaves", ours},
                        {"free_leaves_seen_whole", theirs}});
    }
}

int run(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const std::string output = take_output_path(words);
    const std::string what = words.empty() ? "" : words.front();
    const std::vector<std::string> rest(words.begin() + (words.empty() ? 0 : 1), words.end());
    Json rows = Json::array();
    if (what.empty() || what == "follow" || what == "same") {
        for (const PaperCase& log : cases(rest)) {
            for (const char* rule : {"log-odds", "latest scan wins"}) {
                if (what != "same") follow_one(log, rule, rows);
                if (what != "follow") same_one(log, rule, rows);
            }
        }
    }
    if (what.empty() || what == "sliver") drop_slivers(rows);
    if (what.empty() || what == "queue") queue_pairs(rows);
    if (what.empty() || what == "collapse") collapse(rows);
    write_results(output, "paper", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
