// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Maps as robots scan them, with defaults, against rooms that were drawn by hand; regions where the
// truth names nothing are left out (`quadcut score --void`).
//   measure_real [BUILDING ...] [--untimed] [-o FILE.json]
// Buildings as in bench/data_map.hpp, such as lab_intel; all when none is named. "Ceiling": what
// fusing could reach at best (bench/perfect_fuse.hpp) with the finest pieces, and with those that
// the spectral cut leaves. "Joined right": the PQ if none of the result's cuts were too many, "cut
// right": if none were missed. "Ratio": time over that of the distance transform, as measure_speed
// has it. Doors, where the data has them: one is found when the middle of a found one is within 0.6
// m of its own, each counted once, the nearest pairs first (bench/door_match.hpp); and within 1.5
// m, where a doorway is a metre deep and either end of it may be meant.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/candidate_pieces.hpp"
#include "bench/cases.hpp"
#include "bench/data_map.hpp"
#include "bench/door_match.hpp"
#include "bench/perfect_fuse.hpp"
#include "bench/result_file.hpp"
#include "bench/segment_timing.hpp"
#include "eval/labels.hpp"
#include "eval/score.hpp"
#include "io/file.hpp"

namespace quadcut {
namespace {

struct Wish {
    std::vector<std::string> buildings;
    bool is_untimed = false;
    std::string output;
};

struct MatchedDoors {
    DoorMatch near;
    DoorMatch at_doorway;
};

struct Measured {
    const DataMap* data = nullptr;
    eval::RoomScore score;
    std::uint32_t num_finest = 0;
    std::uint32_t num_joined = 0;
    double finest_ceiling = 0.0;
    double joined_ceiling = 0.0;
    double pq_joined_right = 0.0;
    double pq_cut_right = 0.0;
    std::optional<MatchedDoors> doors;
    std::optional<Timing> timing;
};

template <typename Label>
eval::RoomScore score_of(const DataMap& data, const Raster<Label>& labels) {
    const io::LabelImage rooms = as_label_image(labels);
    return eval::score_rooms(eval::without_void(rooms, data.truth, data.surely_free), data.truth);
}

/// Of a map whose doors are known: NAME.doors.json, lines in metres from the lower left corner.
std::optional<MatchedDoors> match_doors_of(const DataMap& data, const Segmentation& rooms) {
    const auto path = shared_path("data/real") / (data.name + ".doors.json");
    if (!std::filesystem::exists(path)) return std::nullopt;
    std::vector<DoorLine> truth;
    const Json file = Json::parse(io::read_file(path));
    for (const Json& door : file.at("doors")) {
        const auto point = [&](std::size_t end) {
            return transform(data.map.map_from_image,
                             {door.at(end).at(0).get<double>(), door.at(end).at(1).get<double>()});
        };
        truth.push_back({point(0), point(1)});
    }
    std::vector<DoorLine> found;
    for (const Door& door : rooms.doors) found.push_back({door.jamb_1, door.jamb_2});
    return MatchedDoors{match_doors(found, truth), match_doors(found, truth, kSameDoorwayM)};
}

std::uint32_t count_of(const Raster<std::uint32_t>& labels) {
    return as_label_image(labels, 0).num_regions;
}

Measured measure(const DataMap& data) {
    const Segmentation rooms = segment(data.map, {}, RunOptions{1});
    const CandidatePieces pieces = candidate_pieces(data.map, {});
    const Raster<std::uint32_t> truth = as_raster(data.truth);
    Raster<std::uint32_t> labels(rooms.labels.box());
    std::copy(rooms.labels.values.begin(), rooms.labels.values.end(), labels.values.begin());
    return {&data,
            score_of(data, rooms.labels),
            count_of(pieces.finest),
            count_of(pieces.joined),
            score_of(data, fused_by_truth(pieces.finest, truth)).pq,
            score_of(data, fused_by_truth(pieces.joined, truth)).pq,
            score_of(data, fused_by_truth(labels, truth)).pq,
            score_of(data, cut_by_truth(labels, truth)).pq,
            match_doors_of(data, rooms),
            std::nullopt};
}

void print_map(const Measured& m) {
    std::printf("| %-8s | %-18s | %5.1f | %3u | %3u | %5.1f | %5.1f | %5u | %5.1f | %5u | %5.1f |",
                m.data->kind.c_str(), m.data->name.c_str(), 100.0 * m.score.pq, m.score.rooms,
                m.score.truth, 100.0 * m.pq_joined_right, 100.0 * m.pq_cut_right, m.num_finest,
                100.0 * m.finest_ceiling, m.num_joined, 100.0 * m.joined_ceiling);
    if (m.timing) {
        std::printf(" %5.1f | %4.1f | %4.1f |", m.timing->segment_ms, m.timing->ratio(),
                    m.timing->cpu_ratio());
    }
    std::printf("\n");
}

void print_means(const std::vector<Measured>& all) {
    std::map<std::string, std::vector<const Measured*>> sets;
    for (const Measured& m : all) sets[m.data->kind].push_back(&m);
    for (const auto& [kind, set] : sets) {
        double least = 1.0;
        for (const Measured* m : set) least = std::min(least, m->score.pq);
        const auto mean = [&set = set](const auto& value) {
            double sum = 0.0;
            for (const Measured* m : set) sum += value(*m);
            return 100.0 * sum / static_cast<double>(set.size());
        };
        std::printf(
            "%-8s mean PQ %.1f, least %.1f, joined right %.1f, cut right %.1f, ceiling %.1f, of "
            "joined pieces %.1f, %zu maps\n",
            kind.c_str(), mean([](const Measured& m) { return m.score.pq; }), 100.0 * least,
            mean([](const Measured& m) { return m.pq_joined_right; }),
            mean([](const Measured& m) { return m.pq_cut_right; }),
            mean([](const Measured& m) { return m.finest_ceiling; }),
            mean([](const Measured& m) { return m.joined_ceiling; }), set.size());
    }
}

void print_doors(const Measured& m) {
    if (!m.doors) return;
    const DoorMatch& near = m.doors->near;
    std::printf(
        "%s: doors found %zu, true %zu, right %zu: precision %.1f, recall %.1f, F1 %.1f "
        "(within 1.5 m: %.1f)\n",
        m.data->name.c_str(), near.num_found, near.num_true, near.num_right,
        100.0 * near.precision(), 100.0 * near.recall(), 100.0 * near.f1(),
        100.0 * m.doors->at_doorway.f1());
}

Json row_of(const Measured& m) {
    Json row{{"input", m.data->name},
             {"kind", m.data->kind},
             {"building", m.data->building},
             {"pq", m.score.pq},
             {"rooms", m.score.rooms},
             {"true_rooms", m.score.truth},
             {"pieces", m.num_finest},
             {"ceiling", m.finest_ceiling},
             {"joined_pieces", m.num_joined},
             {"joined_ceiling", m.joined_ceiling},
             {"pq_joined_right", m.pq_joined_right},
             {"pq_cut_right", m.pq_cut_right}};
    if (m.doors) {
        const DoorMatch& near = m.doors->near;
        row["doors"] = {{"found", near.num_found},
                        {"true", near.num_true},
                        {"precision", near.precision()},
                        {"recall", near.recall()},
                        {"f1", near.f1()},
                        {"f1_at_doorway", m.doors->at_doorway.f1()}};
    }
    if (m.timing) {
        row["segment_ms"] = m.timing->segment_ms;
        row["ratio"] = m.timing->ratio();
        row["cpu_ratio"] = m.timing->cpu_ratio();
    }
    return row;
}

Wish wish_of(int argc, char** argv) {
    Wish wish;
    std::vector<std::string> words(argv + 1, argv + argc);
    wish.output = take_output_path(words);
    for (const std::string& word : words) {
        if (word == "--untimed") {
            wish.is_untimed = true;
        } else {
            wish.buildings.push_back(word);
        }
    }
    return wish;
}

std::vector<DataMap> maps_of(const Wish& wish) {
    if (wish.buildings.empty()) return read_real_maps();
    std::vector<DataMap> maps;
    for (const std::string& building : wish.buildings) {
        for (DataMap& map : read_real_maps(building)) maps.push_back(std::move(map));
    }
    return maps;
}

int run(int argc, char** argv) {
    const Wish wish = wish_of(argc, argv);
    const std::vector<DataMap> maps = maps_of(wish);
    if (maps.empty()) {
        std::cout << "no real maps of these buildings in " << shared_path("data/real").string()
                  << ": nothing to measure\n";
        return 0;
    }
    Progress progress(maps.size());
    std::vector<Measured> all = run_cases<Measured>(maps.size(), [&](std::size_t i) {
        Measured measured = measure(maps[i]);
        progress.note(maps[i].name);
        return measured;
    });
    std::printf(
        "| set | map | PQ | rooms | true | joined right | cut right | pieces | ceiling | joined | "
        "ceiling | ms | ratio | of CPU times |\n");
    std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    Json rows = Json::array();
    for (Measured& m : all) {
        // One at a time: the machine is to be idle.
        if (!wish.is_untimed) m.timing = time_map(m.data->name, m.data->map);
        print_map(m);
        rows.push_back(row_of(m));
    }
    print_means(all);
    for (const Measured& m : all) print_doors(m);
    write_results(wish.output, "real", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
