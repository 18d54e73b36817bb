// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// How well the door model tells doors from bulges, cut by cut, and the samples it is trained on:
//   measure_doors [-o SAMPLES.csv] [--buildings N] [--pieces basins|spectral]
// Cuts are decided as the truth has it, the least door-like first, as fuse() does: so a sample
// stands for a decision that really comes up. See docs/decisions/0008-door-model.md.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <queue>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "bench/cases.hpp"
#include "bench/data_map.hpp"
#include "bench/resampling.hpp"
#include "bench/building_case.hpp"
#include "eval/labels.hpp"
#include "eval/score.hpp"
#include "quadcut/segment/segment.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/rooms/basins.hpp"
#include "quadcut/rooms/contracted_graph.hpp"
#include "quadcut/rooms/door_model.hpp"
#include "quadcut/rooms/fuse.hpp"
#include "quadcut/rooms/open_space.hpp"
#include "quadcut/rooms/region_graph.hpp"
#include "quadcut/rooms/spectral_pieces.hpp"
#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/options.hpp"
#include "sim/building.hpp"
#include "sim/robot.hpp"
#include "sim/reality.hpp"

namespace quadcut {
namespace {

/// Smaller regions are joined anyway; what their truth is says little.
constexpr double kMinAreaM2 = 0.5;
/// Other directions and resolutions than those that measure_invariance tries.
constexpr std::array<double, 3> kTurnedDegrees{17.0, 37.0, 60.0};
constexpr std::array<double, 2> kScaled{0.7, 1.5};
/// From these log-odds on a cut is kept.
const double kKept = fuse_threshold(RoomsOptions{}.granularity);
/// A component this small is the inside of furniture, not of a building.
constexpr double kMinComponentM2 = 2.0;

/// Of what door_cues() measures, in its order.
/// One decision: the cues, and whether the truth has a cut there.
struct Sample {
    std::array<float, kNumDoorCues> cues{};
    double log_odds = 0.0;
    bool is_cut = false;
};

/// Which true room most of each region is in; nothing where that is not clear.
class RegionTruth {
public:
    RegionTruth(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                const Raster<std::uint32_t>& truth)
        : shares_(num_pieces + 1), num_cells_(num_pieces + 1, 0) {
        for (std::size_t i = 0; i < pieces.values.size(); ++i) {
            ++num_cells_[pieces.values[i]];
            if (truth.values[i] != 0) ++shares_[pieces.values[i]][truth.values[i]];
        }
    }
    bool has_void = false;
    void join(std::uint32_t a, std::uint32_t b) {
        for (const auto& [room, count] : shares_[b]) shares_[a][room] += count;
        num_cells_[a] += num_cells_[b];
    }
    /// 0 if it is not clear.
    [[nodiscard]] std::uint32_t room_of(std::uint32_t region) const {
        std::size_t sum = 0;
        std::pair<std::uint32_t, std::size_t> most{0, 0};
        for (const auto& [room, count] : shares_[region]) {
            sum += count;
            if (count > most.second) most = {room, count};
        }
        if (10 * sum < 3 * num_cells_[region] && num_cells_[region] > 0 && has_void) return 0xFFFFFFFFU;
        const bool is_clear = 10 * sum >= 3 * num_cells_[region] && 10 * most.second >= 6 * sum;
        return is_clear ? most.first : 0;
    }

private:
    std::vector<std::map<std::uint32_t, std::size_t>> shares_;
    std::vector<std::size_t> num_cells_;
};

struct Candidate {
    Sample sample;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t version_a = 0;
    std::uint32_t version_b = 0;
    friend bool operator<(const Candidate& p, const Candidate& q) {
        return std::tie(p.sample.log_odds, p.a, p.b) > std::tie(q.sample.log_odds, q.a, q.b);
    }
};

/// Joins what is one piece before anything is decided.
void join_spectral_pieces(RegionGraph& regions, RegionTruth& rooms) {
    const ContractedGraph contracted = contract(regions);
    join_pieces(regions, contracted, cut_spectrally(contracted.graph, RoomsOptions{}.min_room_m2));
    for (std::uint32_t piece = 1; piece <= regions.num_pieces(); ++piece) {
        if (!regions.is_region(piece)) rooms.join(regions.region_of(piece), piece);
    }
}

std::vector<Sample> decide_by_truth(const GridMap& map, const Raster<std::uint32_t>& truth,
                                    PieceSource pieces, bool has_void = false) {
    const auto kept = inside(map, {}, kMinComponentM2);
    const char* furn = std::getenv("FURN");
    const WallLines lines = find_wall_lines(kept, map.resolution_m, 4.0);
    const auto open = open_space(kept, map.resolution_m, furn ? std::atof(furn) : RoomsOptions{}.max_furniture_m2, lines);
    const Raster<float> clearance = clearance_m(open, map.resolution_m);
    const Raster<float> free_clearance = clearance_m(kept, map.resolution_m);
    const bool all = true;
    Basins basins = build_basins(all ? free_clearance : clearance, map.resolution_m);
    if (!lines.more_dm.values.empty()) basins.count = split_at_lines(lines, basins.labels);
    spread_labels(open, basins.labels);
    RegionGraph regions(basins.labels, basins.count, {clearance, free_clearance, map.states, lines, map.resolution_m});
    RegionTruth rooms(basins.labels, basins.count, truth);
    rooms.has_void = has_void;
    if (pieces == PieceSource::spectral) join_spectral_pieces(regions, rooms);
    std::priority_queue<Candidate> queue;
    const auto push = [&](std::uint32_t a, std::uint32_t b) {
        const BorderMeasure narrowing = regions.measure(a, b);
        queue.push({{door_cues(narrowing), door_log_odds(narrowing), false},
                    a,
                    b,
                    regions.version(a),
                    regions.version(b)});
    };
    for (std::uint32_t region = 1; region <= basins.count; ++region) {
        for (const auto& [other, saddle] : regions.saddles(region)) {
            if (other > region) push(region, other);
        }
    }
    std::vector<Sample> samples;
    while (!queue.empty()) {
        Candidate top = queue.top();
        queue.pop();
        if (!regions.is_region(top.a) || !regions.is_region(top.b) ||
            regions.version(top.a) != top.version_a || regions.version(top.b) != top.version_b) {
            continue;
        }
        const std::uint32_t room_a = rooms.room_of(top.a);
        const std::uint32_t room_b = rooms.room_of(top.b);
        const bool is_clear = room_a != 0 && room_b != 0 && !(room_a == 0xFFFFFFFFU && room_b == 0xFFFFFFFFU);
        top.sample.is_cut = is_clear ? room_a != room_b : top.sample.log_odds >= kKept;
        const double area_m2 = std::min(regions.area_m2(top.a), regions.area_m2(top.b));
        if (is_clear && area_m2 >= kMinAreaM2) samples.push_back(top.sample);
        if (top.sample.is_cut) continue;
        const bool a_larger = regions.area_m2(top.a) >= regions.area_m2(top.b);
        const std::uint32_t heir = a_larger ? top.a : top.b;
        const std::uint32_t other = a_larger ? top.b : top.a;
        regions.join(heir, other);
        rooms.join(heir, other);
        for (const auto& [next, saddle] : regions.saddles(heir)) push(heir, next);
    }
    return samples;
}

struct EvalRow { std::string kind; double pq = 0; std::size_t rooms = 0, truth = 0; double ms = 0; };

EvalRow evaluate(const std::string& kind, const GridMap& map, const Raster<std::uint32_t>& truth, bool is_void, std::span<const Point> trajectory) {
    const auto start = std::chrono::steady_clock::now();
    SegmentOptions options;
    if (const char* g = std::getenv("GRAN")) options.rooms.granularity = std::atof(g);
    options.rooms.min_component_m2 = std::getenv("MINC") ? std::atof(std::getenv("MINC")) : 2.0;
    if (const char* g = std::getenv("FURN")) options.rooms.max_furniture_m2 = std::atof(g);
    if (const char* g = std::getenv("BASINS")) options.rooms.pieces = std::atoi(g) ? PieceSource::basins : PieceSource::spectral;
    Segmentation rooms = segment(map, options, RunOptions{1}, trajectory);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (is_void) {
        std::vector<std::size_t> in(65536, 0), out(65536, 0);
        for (std::size_t i = 0; i < truth.values.size(); ++i) {
            if (map.states.values[i] != CellState::free) continue;
            ++in[rooms.labels.values[i]];
            if (truth.values[i] == 0) ++out[rooms.labels.values[i]];
        }
        for (auto& l : rooms.labels.values) if (2 * out[l] > in[l]) l = 0;
    }
    const auto score = eval::score_rooms(as_label_image(rooms.labels), as_label_image(truth));
    return {kind, 100 * score.pq, score.rooms, score.truth, ms};
}

struct Tally {
    std::size_t cuts = 0;
    std::size_t missed = 0;
    std::size_t others = 0;
    std::size_t invented = 0;
};

class Report {
public:
    explicit Report(const std::string& csv) {
        if (csv.empty()) return;
        csv_.open(csv);
        csv_ << "map,group,kind,is_cut";
        for (const DoorCue& cue : kDoorCues) csv_ << ',' << cue.name;
        csv_ << '\n';
    }
    void add(const std::string& map, const std::string& group, const std::string& kind,
             const std::vector<Sample>& samples) {
        Tally& tally = tallies_[kind];
        for (const Sample& sample : samples) {
            ++(sample.is_cut ? tally.cuts : tally.others);
            if (sample.is_cut && sample.log_odds < kKept) ++tally.missed;
            if (!sample.is_cut && sample.log_odds >= kKept) ++tally.invented;
            if (!csv_.is_open()) continue;
            csv_ << map << ',' << group << ',' << kind << ',' << (sample.is_cut ? 1 : 0);
            for (const float cue : sample.cues) csv_ << ',' << cue;
            csv_ << '\n';
        }
    }
    void print() const {
        std::printf("| maps | cuts | missed | no cuts | invented |\n|---|---|---|---|---|\n");
        for (const auto& [kind, t] : tallies_) {
            std::printf("| %s | %zu | %.1f %% | %zu | %.1f %% |\n", kind.c_str(), t.cuts,
                        100.0 * static_cast<double>(t.missed) / static_cast<double>(t.cuts),
                        t.others,
                        100.0 * static_cast<double>(t.invented) / static_cast<double>(t.others));
        }
    }

private:
    std::ofstream csv_;
    std::map<std::string, Tally> tallies_;
};

std::vector<DataMap> all_maps() {
    std::vector<DataMap> maps = read_data_maps();
    for (DataMap& map : read_real_maps("")) maps.push_back(std::move(map));
    return maps;
}

/// Each map as it is, and as it is when drawn in other directions and at other resolutions: the
/// model should not depend on that.
void add_data(PieceSource pieces, Report& report) {
    const std::vector<DataMap> maps = all_maps();
    const auto all = run_cases<std::vector<std::vector<Sample>>>(maps.size(), [&](std::size_t i) {
        const DataMap& data = maps[i];
        const Raster<std::uint32_t> truth = as_raster(data.truth);
        std::vector<std::vector<Sample>> out;
        out.push_back(decide_by_truth(data.map, truth, pieces, data.kind == "real" || data.kind == "growing"));
        const auto add_changed = [&](const Resampling& change) {
            out.push_back(decide_by_truth(resample(data.map, change), resample_nearest(truth, change), pieces, data.kind == "real"));
        };
        if (data.kind == "growing") return out;
        for (const double degrees : kTurnedDegrees) add_changed(turned(data.map, degrees));
        for (const double cells : kScaled) add_changed(scaled(data.map, cells));
        return out;
    });
    for (std::size_t i = 0; i < maps.size(); ++i) {
        for (std::size_t k = 0; k < all[i].size(); ++k) {
            report.add(maps[i].name, maps[i].building, maps[i].kind + (k ? " changed" : ""), all[i][k]);
        }
    }
}

/// The labels of a building at the cells of another map of it.
Raster<std::uint32_t> lab_truth_at(const sim::Building& building, const GridMap& map) {
    Raster<std::uint32_t> truth(map.states.origin, map.states.width, map.states.height);
    const Pose world_from_image = inverse(building.map.map_from_image);
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        const Cell cell = truth.cell(i);
        const Point at = transform(
            world_from_image, transform(map.map_from_image, {(cell.x + 0.5) * map.resolution_m,
                                                             (cell.y + 0.5) * map.resolution_m}));
        const Cell in_building{
            static_cast<std::int32_t>(std::floor(at.x / building.map.resolution_m)),
            static_cast<std::int32_t>(std::floor(at.y / building.map.resolution_m))};
        if (building.labels.contains(in_building)) {
            truth.values[i] = building.labels.at(in_building);
        }
    }
    return truth;
}

/// Buildings of all sizes and densities of furniture; each third also as a robot maps it.
void add_simulated(int num_buildings, PieceSource pieces, Report& report) {
    const auto all = run_cases<std::array<std::vector<Sample>, 2>>(static_cast<std::size_t>(num_buildings), [&](std::size_t at) {
        const int i = static_cast<int>(at);
        std::array<std::vector<Sample>, 2> out;
        sim::BuildingOptions options;
        options.seed = static_cast<std::uint64_t>(1000 + i);
        options.num_rooms = 8 + i * 7 % 40;
        options.furniture = 0.01 * (i * 37 % 101);
        if (i % 2 == 1) options.yaw_rad = 0.01 * (i * 53 % 157);
        const sim::Building building = sim::generate_building(options);
        out[0] = decide_by_truth(building.map, lab_truth_at(building, building.map), pieces);
        if (i % 2 != 0) return out;
        sim::RobotOptions robot;
        robot.seed = options.seed;
        const auto scans = sim::explore(building.map, sim::start_pose(building), robot).scans;
        const GridMap map = map_from_scans(scans, options.resolution_m).to_grid();
        out[1] = decide_by_truth(map, lab_truth_at(building, map), pieces);
        return out;
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string name = "seed_" + std::to_string(1000 + i);
        report.add(name, name, "simulated", all[i][0]);
        if (!all[i][1].empty()) report.add(name, name, "simulated and scanned", all[i][1]);
    }
}

void add_cluttered(int num, PieceSource pieces, Report& report) {
    const auto all = run_cases<std::array<std::vector<Sample>, 2>>(static_cast<std::size_t>(num), [&](std::size_t i) {
        sim::RealityOptions options;
        options.seed = static_cast<std::uint64_t>(20001 + i);
        options.num_rooms = 12 + static_cast<int>(i) * 7 % 37;
        const sim::RealMap real = sim::scan_as_robots_do(options);
        std::array<std::vector<Sample>, 2> out;
        out[0] = decide_by_truth(real.map, real.truth, pieces, true);
        out[1] = decide_by_truth(real.building.map, lab_truth_at(real.building, real.building.map), pieces, false);
        return out;
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string name = "seed_cluttered_" + std::to_string(i);
        report.add(name, name, "simulated cluttered", all[i][0]);
        report.add(name, name, "simulated drawn", all[i][1]);
    }
}

int run_eval(int argc, char** argv) {
    std::string only; std::size_t sim = 0;
    for (int i = 2; i + 1 < argc; i += 2) {
        if (std::string(argv[i]) == "--only") only = argv[i + 1];
        if (std::string(argv[i]) == "--sim") sim = std::stoul(argv[i + 1]);
    }
    std::vector<DataMap> maps;
    for (DataMap& m : all_maps()) if (only.empty() || ("," + only + ",").find("," + m.building + ",") != std::string::npos || m.kind == only) maps.push_back(std::move(m));
    const std::size_t clut = only.empty() ? sim / 2 : 0;
    const auto rows = run_cases<EvalRow>(maps.size() + sim + clut, [&](std::size_t i) {
        if (i >= maps.size() + sim) {
            sim::RealityOptions options;
            options.seed = static_cast<std::uint64_t>(40001 + i - maps.size() - sim);
            options.num_rooms = 12 + static_cast<int>(i) * 7 % 37;
            const sim::RealMap real = sim::scan_as_robots_do(options);
            return evaluate("cluttered", real.map, real.truth, true, {});
        }
        if (i >= maps.size()) {
            const MappedBuilding mapped = map_building(building_case(i - maps.size()));
            return evaluate("simulated", mapped.map, mapped.truth, false, mapped.trajectory);
        }
        const DataMap& d = maps[i];
        return evaluate(d.kind, d.map, as_raster(d.truth), d.kind == "real" || d.kind == "growing" || d.kind == "campus", {});
    });
    std::map<std::string, std::pair<double, int>> sums; double ms = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::string name = i < maps.size() ? maps[i].name : "sim " + std::to_string(i - maps.size());
        std::printf("%-10s %-28s %5.1f %3zu / %3zu  %6.0f ms\n", rows[i].kind.c_str(), name.c_str(), rows[i].pq, rows[i].rooms, rows[i].truth, rows[i].ms);
        auto& s = sums[rows[i].kind]; s.first += rows[i].pq; ++s.second; ms += rows[i].ms;
    }
    for (auto& [k, s] : sums) std::printf("%s %.1f  ", k.c_str(), s.first / s.second);
    std::printf(" ms %.0f\n", ms);
    return 0;
}

struct Ceiling { std::size_t basins, lines, pieces; double top, mid; double ms; };
int run_ceiling(const std::string& only) {
    std::vector<DataMap> maps;
    for (DataMap& m : all_maps()) if (only.empty() || m.building == only || m.kind == only || m.name == only) maps.push_back(std::move(m));
    const auto rows = run_cases<Ceiling>(maps.size(), [&](std::size_t at) {
        const DataMap& d = maps[at];
        const auto kept = inside(d.map, {}, kMinComponentM2);
        const WallLines lines = find_wall_lines(kept, d.map.resolution_m, 4.0);
        const auto open = open_space(kept, d.map.resolution_m, RoomsOptions{}.max_furniture_m2, lines);
        const Raster<float> clearance = clearance_m(open, d.map.resolution_m);
        const Raster<float> free_clearance = clearance_m(kept, d.map.resolution_m);
        Basins basins = build_basins(free_clearance, d.map.resolution_m);
        Ceiling c{basins.count, 0, 0, 0, 0, 0};
        if (!lines.more_dm.values.empty()) basins.count = split_at_lines(lines, basins.labels);
        spread_labels(open, basins.labels);
        c.lines = basins.count;
        const Raster<std::uint32_t> truth = as_raster(d.truth);
        const auto ceiling = [&](const Raster<std::uint32_t>& pieces, std::uint32_t n) {
            std::vector<std::map<std::uint32_t, std::size_t>> share(n + 1);
            for (std::size_t i = 0; i < truth.values.size(); ++i) if (truth.values[i] && pieces.values[i]) ++share[pieces.values[i]][truth.values[i]];
            Raster<std::uint16_t> l(pieces.box());
            std::vector<std::uint16_t> best(n + 1, 0);
            for (std::uint32_t p = 1; p <= n; ++p) { std::size_t most = 0; for (auto& [r, k] : share[p]) if (k > most) { most = k; best[p] = static_cast<std::uint16_t>(r); } }
            for (std::size_t i = 0; i < truth.values.size(); ++i) l.values[i] = best[pieces.values[i]];
            return 100 * eval::score_rooms(as_label_image(l), as_label_image(truth)).pq;
        };
        c.top = ceiling(basins.labels, basins.count);
        const auto t = std::chrono::steady_clock::now();
        RegionGraph regions(basins.labels, basins.count, {clearance, free_clearance, d.map.states, lines, d.map.resolution_m});
        const ContractedGraph contracted = contract(regions);
        join_pieces(regions, contracted, cut_spectrally(contracted.graph, RoomsOptions{}.min_room_m2));
        c.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - t).count();
        Raster<std::uint32_t> pieces = basins.labels;
        for (auto& p : pieces.values) if (p) p = regions.region_of(p);
        for (std::uint32_t p = 1; p <= basins.count; ++p) if (regions.is_region(p)) ++c.pieces;
        c.mid = ceiling(pieces, basins.count);
        return c;
    });
    std::map<std::string, std::array<double, 5>> sums;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (maps[i].kind == "real") std::printf("%-22s basins %5zu lines %5zu pieces %5zu  ceiling %.1f %.1f  %.0f ms\n", maps[i].name.c_str(), rows[i].basins, rows[i].lines, rows[i].pieces, rows[i].top, rows[i].mid, rows[i].ms);
        auto& s = sums[maps[i].kind]; s[0] += rows[i].top; s[1] += rows[i].mid; s[2] += 1; s[3] += static_cast<double>(rows[i].pieces); s[4] += rows[i].ms;
    }
    for (auto& [k, s] : sums) std::printf("%s %.1f %.1f (%.0f) %.0f ms | ", k.c_str(), s[0] / s[2], s[1] / s[2], s[3] / s[2], s[4] / s[2]);
    std::printf("\n");
    return 0;
}

int run(int argc, char** argv) {
    if (argc > 1 && std::string(argv[1]) == "ceiling") return run_ceiling(argc > 2 ? argv[2] : "");
    if (argc > 1 && std::string(argv[1]) == "eval") return run_eval(argc, argv);
    std::string csv;
    int num_buildings = 100, num_cluttered = 200;
    PieceSource pieces = RoomsOptions{}.pieces;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (std::string(argv[i]) == "-o") csv = argv[i + 1];
        if (std::string(argv[i]) == "--cluttered") num_cluttered = std::stoi(argv[i + 1]);
        if (std::string(argv[i]) == "--buildings") num_buildings = std::stoi(argv[i + 1]);
        if (std::string(argv[i]) != "--pieces") continue;
        const bool is_spectral = std::string(argv[i + 1]) == "spectral";
        pieces = is_spectral ? PieceSource::spectral : PieceSource::basins;
    }
    Report report(csv);
    add_data(pieces, report);
    add_simulated(num_buildings, pieces, report);
    add_cluttered(num_cluttered, pieces, report);
    report.print();
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
