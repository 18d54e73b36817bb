// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// How well the door model tells doors from bulges, cut by cut, and the samples it is trained on:
//   measure_doors [-o SAMPLES.csv] [--buildings N] [--pieces basins|spectral]
// Cuts are decided as the truth has it, the least door-like first, as fuse() does: so a sample
// stands for a decision that really comes up. See docs/decisions/0008-door-model.md.
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <queue>
#include <string>
#include <tuple>
#include <vector>

#include "bench/cases.hpp"
#include "bench/data_map.hpp"
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
/// A component this small is the inside of furniture, not of a building.
constexpr double kMinComponentM2 = 4.0;

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
                                    PieceSource pieces) {
    const auto kept = inside(map, {}, kMinComponentM2);
    const auto open = open_space(kept, map.resolution_m, RoomsOptions{}.max_furniture_m2);
    const Raster<float> clearance = clearance_m(open, map.resolution_m);
    const Basins basins = build_basins(clearance, map.resolution_m);
    RegionGraph regions(basins.labels, basins.count, clearance, map.resolution_m);
    RegionTruth rooms(basins.labels, basins.count, truth);
    if (pieces == PieceSource::spectral) join_spectral_pieces(regions, rooms);
    std::priority_queue<Candidate> queue;
    const auto push = [&](std::uint32_t a, std::uint32_t b) {
        const Narrowing narrowing = regions.measure(a, b);
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
        const bool is_clear = room_a != 0 && room_b != 0;
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

/// Each map as it is, and as it is when drawn in other directions and at other resolutions: the
/// model should not depend on that.
void add_data(PieceSource pieces, Report& report) {
    for (const DataMap& data : read_data_maps()) {
        const Raster<std::uint32_t> truth = as_raster(data.truth);
        report.add(data.name, data.building, data.kind, decide_by_truth(data.map, truth, pieces));
        const auto add_changed = [&](const Resampling& change) {
            report.add(data.name, data.building, data.kind + " changed",
                       decide_by_truth(resample(data.map, change), resample_nearest(truth, change),
                                       pieces));
        };
        for (const double degrees : kTurnedDegrees) add_changed(turned(data.map, degrees));
        for (const double cells : kScaled) add_changed(scaled(data.map, cells));
    }
}

/// The labels of a building at the cells of another map of it.
Raster<std::uint32_t> truth_at(const sim::Building& building, const GridMap& map) {
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

/// Buildings as robots find them.
void add_cluttered(int num_buildings, PieceSource pieces, Report& report) {
    for (int i = 0; i < num_buildings; ++i) {
        sim::RealityOptions options;
        options.seed = static_cast<std::uint64_t>(20001 + i);
        options.num_rooms = 12 + i * 7 % 37;
        const sim::RealMap real = sim::scan_as_robots_do(options);
        const std::string name = "cluttered_" + std::to_string(options.seed);
        report.add(name, name, "simulated cluttered",
                   decide_by_truth(real.map, real.truth, pieces));
    }
}

/// Buildings of all sizes and densities of furniture; each third also as a robot maps it.
void add_simulated(int num_buildings, PieceSource pieces, Report& report) {
    for (int i = 0; i < num_buildings; ++i) {
        sim::BuildingOptions options;
        options.seed = static_cast<std::uint64_t>(1000 + i);
        options.num_rooms = 8 + i * 7 % 40;
        options.furniture = 0.01 * (i * 37 % 101);
        if (i % 2 == 1) options.yaw_rad = 0.01 * (i * 53 % 157);
        const sim::Building building = sim::generate_building(options);
        const std::string name = "seed_" + std::to_string(options.seed);
        report.add(name, name, "simulated",
                   decide_by_truth(building.map, truth_at(building, building.map), pieces));
        if (i % 2 != 0) continue;
        sim::RobotOptions robot;
        robot.seed = options.seed;
        const auto scans = sim::explore(building.map, sim::start_pose(building), robot).scans;
        const GridMap map = map_from_scans(scans, options.resolution_m).to_grid();
        report.add(name, name, "simulated and scanned",
                   decide_by_truth(map, truth_at(building, map), pieces));
    }
}

int run(int argc, char** argv) {
    std::string csv;
    int num_buildings = 100;
    PieceSource pieces = RoomsOptions{}.pieces;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (std::string(argv[i]) == "-o") csv = argv[i + 1];
        if (std::string(argv[i]) == "--buildings") num_buildings = std::stoi(argv[i + 1]);
        if (std::string(argv[i]) != "--pieces") continue;
        const bool is_spectral = std::string(argv[i + 1]) == "spectral";
        pieces = is_spectral ? PieceSource::spectral : PieceSource::basins;
    }
    Report report(csv);
    add_data(pieces, report);
    add_simulated(num_buildings, pieces, report);
    add_cluttered(num_buildings, pieces, report);
    report.print();
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
