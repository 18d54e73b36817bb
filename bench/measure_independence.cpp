// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// How independent the parts of a map are, by what the scans of its log see: rooms, zones by
// co-visibility and by conductance, and the paper's submaps.
//   measure_independence [LOG ...] [-o FILE.json]
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/cpu_time.hpp"
#include "bench/result_file.hpp"
#include "bench/shared_folder.hpp"
#include "io/scan_source.hpp"
#include "io/scanned_map.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "quadcut/zones/independence.hpp"
#include "quadcut/zones/zones.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kNumZones = 10;
constexpr double kResolutionM = 0.05;

Json counts_of(const Independence& parts, bool (*is_meant)(const PairIndependence&),
               std::size_t num_left) {
    std::vector<PairIndependence> pairs;
    for (const PairIndependence& pair : parts.pairs) {
        if (is_meant(pair)) pairs.push_back(pair);
    }
    return {{"pairs", num_left + pairs.size()},
            {"independent", num_left + num_independent(pairs, &PairIndependence::all)},
            {"independent_given_doors",
             num_left + num_independent(pairs, &PairIndependence::given_doors)}};
}

/// Of all rooms' floor, what the largest part has.
double largest_share(const Segmentation& rooms, const std::vector<std::uint32_t>& part_of_room) {
    std::map<std::uint32_t, double> area_m2;
    double all_m2 = 0.0;
    for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
        area_m2[part_of_room[i]] += rooms.rooms[i].area_m2;
        all_m2 += rooms.rooms[i].area_m2;
    }
    double largest_m2 = 0.0;
    for (const auto& [part, m2] : area_m2) largest_m2 = std::max(largest_m2, m2);
    return largest_m2 / all_m2;
}

class Log {
public:
    explicit Log(const std::string& name)
        : name_(name.substr(0, name.find(".gz"))),
          source_(io::open_scan_source(io::Input(shared_path("data/logs/" + name)),
                                       {{}, kResolutionM, {}})) {
        const double start = cpu_ms();
        scanned_ = io::map_scans(*source_, kResolutionM, {});
        map_ms_ = cpu_ms() - start;
    }

    void measure(Json& rows) {
        const Segmentation rooms = segment(scanned_.map, SegmentOptions{}, {}, scanned_.trajectory);
        const std::vector<Sighting> sightings = look_again(rooms);
        std::vector<std::uint32_t> own;
        for (std::uint32_t i = 0; i < rooms.rooms.size(); ++i) own.push_back(i + 1);
        add(rows, "rooms", rooms, sightings, own);
        const Covisibility seen = covisibility_of(sightings, rooms);
        for (const std::size_t count : {kNumZones, std::size_t{0}}) {
            const std::string number = count == 0 ? ", by eigengap" : ", ten";
            const auto zones = [&](ZoneWeights weights) {
                return find_zones(rooms, seen, {count, weights}).zone_of_room;
            };
            add(rows, "zones by co-visibility" + number, rooms, sightings,
                zones(ZoneWeights::covisibility));
            add(rows, "zones by conductance" + number, rooms, sightings,
                zones(ZoneWeights::conductance));
        }
        SegmentOptions paper;
        paper.preset = Preset::paper;
        paper.paper.num_submaps = kNumZones;
        const Segmentation submaps = segment(scanned_.map, paper);
        own.clear();
        for (std::uint32_t i = 0; i < submaps.rooms.size(); ++i) own.push_back(i + 1);
        add(rows, "submaps of the preset paper, ten", submaps, look_again(submaps), own);
    }

private:
    std::vector<Sighting> look_again(const Segmentation& rooms) {
        source_->rewind();
        const double start = cpu_ms();
        std::vector<Sighting> sightings =
            sightings_of([this] { return source_->next(); }, scanned_.map, rooms);
        look_ms_ = cpu_ms() - start;
        return sightings;
    }

    void add(Json& rows, const std::string& parts, const Segmentation& rooms,
             const std::vector<Sighting>& sightings, const std::vector<std::uint32_t>& of_room) {
        const Independence found = independence_of_zones(sightings, scanned_.map, rooms, of_room);
        Json row;
        row["input"] = name_;
        row["parts"] = parts;
        row["num_parts"] = found.num_parts;
        row["scans"] = found.num_scans;
        row["seen_outside"] = found.seen_outside;
        row["largest_share"] = largest_share(rooms, of_room);
        const auto any = [](const PairIndependence&) { return true; };
        const auto is_seen = [](const PairIndependence& pair) { return pair.all.both != 0; };
        const auto has_door = [](const PairIndependence& pair) { return pair.num_doors != 0; };
        row["all"] = counts_of(found, any, found.num_pairs() - found.pairs.size());
        row["seen_together"] = counts_of(found, is_seen, 0);
        row["with_doors"] = counts_of(found, has_door, 0);
        row["map_cpu_ms"] = map_ms_;
        row["second_look_cpu_ms"] = look_ms_;
        std::printf("%-18s %-36s %3zu parts, %5.1f %% seen outside, %s -> %s of %s pairs\n",
                    name_.c_str(), parts.c_str(), found.num_parts, 100.0 * found.seen_outside,
                    row["all"]["independent"].dump().c_str(),
                    row["all"]["independent_given_doors"].dump().c_str(),
                    row["all"]["pairs"].dump().c_str());
        std::fflush(stdout);
        rows.push_back(row);
    }

    std::string name_;
    std::unique_ptr<io::ScanSource> source_;
    io::ScannedMap scanned_;
    double map_ms_ = 0.0;
    double look_ms_ = 0.0;
};

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) {
    std::string output;
    std::vector<std::string> logs;
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "-o" && i + 1 < argc) {
            output = argv[++i];
        } else {
            logs.emplace_back(argv[i]);
        }
    }
    if (logs.empty()) {
        logs = {"mit_csail.log",      "intel.log",         "mit_csail_dense.log.gz",
                "intel_dense.log.gz", "aces_dense.log.gz", "mit_killian_dense.log.gz"};
    }
    quadcut::Json rows = quadcut::Json::array();
    for (const std::string& log : logs) quadcut::Log(log).measure(rows);
    quadcut::write_results(output, "independence", rows);
    return 0;
}
