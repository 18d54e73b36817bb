// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// How well the door model tells doors from bulges, cut by cut, and the samples it is trained on:
//   measure_doors [-o SAMPLES.csv] [--buildings N] [--cluttered N] [--pieces basins|spectral]
// Cuts are decided as the truth has it, the least door-like first, as fuse() does: so a sample
// stands for a decision that really comes up. See docs/decisions/0008-door-model.md.
#include <algorithm>
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
#include "bench/field_case.hpp"
#include "bench/resampling.hpp"
#include "eval/labels.hpp"
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
#include "sim/reality.hpp"
#include "sim/robot.hpp"

namespace quadcut {
namespace {

/// Smaller regions are joined anyway; what their truth is says little.
constexpr double kMinAreaM2 = 0.5;
/// Other directions and resolutions than those that measure_invariance tries.
constexpr std::array<double, 3> kTurnedDegrees{17.0, 37.0, 60.0};
constexpr std::array<double, 2> kScaled{0.7, 1.5};
/// From these log-odds on a cut is kept.
const double kKept = fuse_threshold(RoomsOptions{}.granularity);
/// The truth of what nobody can name: rays through glass, the ground outside.
constexpr std::uint32_t kVoid = 0xFFFFFFFF;
constexpr std::uint64_t kFirstCluttered = 20001;

/// Whether what the truth leaves out is something of its own, from which rooms are to be cut.
enum class LeftOut { unclear, is_void };

/// One decision: the cues, and whether the truth has a cut there.
struct Sample {
    std::array<float, kNumDoorCues> cues{};
    double log_odds = 0.0;
    bool is_cut = false;
};

/// Which true room most of each region is in, or kVoid; nothing where that is not clear.
class RegionTruth {
public:
    RegionTruth(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                const Raster<std::uint32_t>& truth, LeftOut left_out)
        : left_out_(left_out), shares_(num_pieces + 1), num_cells_(num_pieces + 1, 0) {
        for (std::size_t i = 0; i < pieces.values.size(); ++i) {
            ++num_cells_[pieces.values[i]];
            if (truth.values[i] != 0) ++shares_[pieces.values[i]][truth.values[i]];
        }
    }
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
        if (10 * sum < 3 * num_cells_[region]) return left_out_ == LeftOut::is_void ? kVoid : 0;
        return 10 * most.second >= 6 * sum ? most.first : 0;
    }

private:
    LeftOut left_out_;
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
void join_spectral_pieces(RegionGraph& regions) {
    const ContractedGraph contracted = contract(regions);
    join_pieces(regions, contracted, cut_spectrally(contracted.graph, RoomsOptions{}.min_room_m2));
}

std::vector<Sample> decide_by_truth(const GridMap& map, const Raster<std::uint32_t>& truth,
                                    PieceSource pieces, LeftOut left_out = LeftOut::unclear) {
    const RoomsOptions options;
    const double resolution_m = map.resolution_m;
    const auto kept = inside(map, {}, options.min_component_m2);
    const Raster<float> free_clearance = clearance_m(kept, resolution_m);
    const WallLines lines = find_wall_lines(kept, resolution_m, options.door_width_m);
    const auto open = open_space(kept, resolution_m, options.max_furniture_m2, lines);
    const Raster<float> clearance = clearance_m(open, resolution_m);
    Basins basins = build_basins(free_clearance, resolution_m);
    basins.count = split_at_lines(lines, basins.labels);
    spread_labels(open, basins.labels);
    RegionGraph regions(basins.labels, basins.count,
                        {clearance, free_clearance, map.states, lines, resolution_m});
    RegionTruth rooms(basins.labels, basins.count, truth, left_out);
    if (pieces == PieceSource::spectral) join_spectral_pieces(regions);
    fuse_small_regions(regions, kMinPieceM2, options.min_passable_m);
    for (std::uint32_t piece = 1; piece <= regions.num_pieces(); ++piece) {
        if (!regions.is_region(piece)) rooms.join(regions.region_of(piece), piece);
    }
    std::priority_queue<Candidate> queue;
    const auto push = [&](std::uint32_t a, std::uint32_t b) {
        const BorderMeasure border = regions.measure(a, b);
        queue.push({{door_cues(border), door_log_odds(border), false},
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
        const bool is_clear = room_a != 0 && room_b != 0 && (room_a != kVoid || room_b != kVoid);
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

/// A map as it is, and as it is when drawn in other directions and at other resolutions: the model
/// should not depend on that. Stages of one map are many as they are.
std::vector<std::vector<Sample>> decide_in_all_directions(const DataMap& data, PieceSource pieces) {
    const bool has_void = data.kind == "real" || data.kind == "growing";
    const LeftOut left_out = has_void ? LeftOut::is_void : LeftOut::unclear;
    const Raster<std::uint32_t> truth = as_raster(data.truth);
    std::vector<std::vector<Sample>> samples{decide_by_truth(data.map, truth, pieces, left_out)};
    if (data.kind == "growing") return samples;
    const auto add_changed = [&](const Resampling& change) {
        samples.push_back(decide_by_truth(resample(data.map, change),
                                          resample_nearest(truth, change), pieces, left_out));
    };
    for (const double degrees : kTurnedDegrees) add_changed(turned(data.map, degrees));
    for (const double cells : kScaled) add_changed(scaled(data.map, cells));
    return samples;
}

void add_data(PieceSource pieces, Report& report) {
    std::vector<DataMap> maps = read_data_maps();
    for (DataMap& map : read_real_maps("")) maps.push_back(std::move(map));
    const auto samples = run_cases<std::vector<std::vector<Sample>>>(
        maps.size(), [&](std::size_t i) { return decide_in_all_directions(maps[i], pieces); });
    for (std::size_t i = 0; i < maps.size(); ++i) {
        for (std::size_t k = 0; k < samples[i].size(); ++k) {
            report.add(maps[i].name, maps[i].building, maps[i].kind + (k == 0 ? "" : " changed"),
                       samples[i][k]);
        }
    }
}

/// Of one building, drawn and scanned; the latter may be none.
struct Decided {
    std::vector<Sample> drawn;
    std::vector<Sample> scanned;
};

std::vector<Sample> decide_drawn(const sim::Building& building, PieceSource pieces) {
    return decide_by_truth(building.map, labels_at(building.map, building.labels, building.map),
                           pieces);
}

/// Buildings of all sizes and densities of furniture; every other one also as a robot maps it.
Decided decide_simulated(std::size_t i, PieceSource pieces) {
    sim::BuildingOptions options;
    options.seed = 1000 + i;
    options.num_rooms = 8 + static_cast<int>(i * 7 % 40);
    options.furniture = 0.01 * static_cast<double>(i * 37 % 101);
    if (i % 2 == 1) options.yaw_rad = 0.01 * static_cast<double>(i * 53 % 157);
    const sim::Building building = sim::generate_building(options);
    Decided decided{decide_drawn(building, pieces), {}};
    if (i % 2 != 0) return decided;
    sim::RobotOptions robot;
    robot.seed = options.seed;
    const auto scans = sim::explore(building.map, sim::start_pose(building), robot).scans;
    const GridMap map = map_from_scans(scans, options.resolution_m).to_grid();
    decided.scanned = decide_by_truth(map, labels_at(building.map, building.labels, map), pieces);
    return decided;
}

/// Buildings as robots find them, and the same as an architect draws them.
Decided decide_cluttered(std::size_t i, PieceSource pieces) {
    sim::RealityOptions options;
    options.seed = kFirstCluttered + i;
    options.num_rooms = 12 + static_cast<int>(i * 7 % 37);
    const sim::RealMap real = sim::scan_as_robots_do(options);
    return {decide_drawn(real.building, pieces),
            decide_by_truth(real.map, real.truth, pieces, LeftOut::is_void)};
}

/// Each kind of floor, straight and turned.
void add_field(std::size_t num_each, PieceSource pieces, Report& report) {
    const auto decided = run_cases<std::vector<Sample>>(3 * num_each, [&](std::size_t i) {
        const FieldCase floor = i % 3 == 0   ? halls_and_corridor(i)
                                : i % 3 == 1 ? cubicles(i)
                                             : wall_of_posts(i);
        if (i % 2 == 0) return decide_by_truth(floor.map, floor.truth, pieces);
        const Resampling change = turned(floor.map, static_cast<double>(i * 37 % 90));
        return decide_by_truth(resample(floor.map, change), resample_nearest(floor.truth, change),
                               pieces);
    });
    for (std::size_t i = 0; i < decided.size(); ++i) {
        report.add("field_" + std::to_string(i), "field_" + std::to_string(i), "field", decided[i]);
    }
}

void add_simulated(std::size_t num_buildings, std::size_t num_cluttered, PieceSource pieces,
                   Report& report) {
    const auto decided = run_cases<Decided>(num_buildings + num_cluttered, [&](std::size_t i) {
        return i < num_buildings ? decide_simulated(i, pieces)
                                 : decide_cluttered(i - num_buildings, pieces);
    });
    for (std::size_t i = 0; i < decided.size(); ++i) {
        const bool is_cluttered = i >= num_buildings;
        const std::string name = "building_" + std::to_string(i);
        report.add(name, name, is_cluttered ? "simulated drawn" : "simulated", decided[i].drawn);
        if (decided[i].scanned.empty()) continue;
        report.add(name, name, is_cluttered ? "simulated cluttered" : "simulated and scanned",
                   decided[i].scanned);
    }
}

int run(int argc, char** argv) {
    std::string csv;
    std::size_t num_buildings = 100;
    std::size_t num_cluttered = 200;
    PieceSource pieces = RoomsOptions{}.pieces;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (std::string(argv[i]) == "-o") csv = argv[i + 1];
        if (std::string(argv[i]) == "--cluttered") num_cluttered = std::stoul(argv[i + 1]);
        if (std::string(argv[i]) == "--buildings") num_buildings = std::stoul(argv[i + 1]);
        if (std::string(argv[i]) != "--pieces") continue;
        const bool is_spectral = std::string(argv[i + 1]) == "spectral";
        pieces = is_spectral ? PieceSource::spectral : PieceSource::basins;
    }
    Report report(csv);
    add_data(pieces, report);
    add_simulated(num_buildings, num_cluttered, pieces, report);
    add_field(num_cluttered / 2, pieces, report);
    report.print();
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
