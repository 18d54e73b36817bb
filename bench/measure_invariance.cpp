// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What a change of the map that changes no room does to the rooms: turned, mirrored, at another
// resolution, with noise, padded, moved by a cell.
//   measure_invariance [-o FILE.json]
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "bench/cases.hpp"
#include "bench/data_map.hpp"
#include "bench/resampling.hpp"
#include "bench/result_file.hpp"
#include "eval/labels.hpp"
#include "eval/score.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
namespace {

constexpr std::int32_t kPaddingCells = 37;

struct Change {
    std::string name;
    std::function<Resampling(const GridMap&)> resampling;
    bool is_noisy = false;
};

std::vector<Change> all_changes() {
    const auto turn = [](double degrees) {
        return Change{"turned by " + std::to_string(static_cast<int>(degrees)) + " degrees",
                      [degrees](const GridMap& map) { return turned(map, degrees); }};
    };
    const auto pad = [](std::int32_t before, std::int32_t after) {
        return [=](const GridMap& map) { return padded(map, before, after); };
    };
    return {{"unchanged", pad(0, 0)},
            turn(7.0),
            turn(30.0),
            turn(45.0),
            turn(90.0),
            {"mirrored", mirrored},
            {"half the resolution", [](const GridMap& map) { return scaled(map, 0.5); }},
            {"double the resolution", [](const GridMap& map) { return scaled(map, 2.0); }},
            {"0.5 % of the cells flipped", pad(0, 0), true},
            {"padded by 37 cells", pad(kPaddingCells, kPaddingCells)},
            {"moved by one cell", pad(1, 0)}};
}

struct CaseResult {
    std::string map;
    std::string kind;
    std::string change;
    double pq = 0.0;
    /// With the rooms of the unchanged map, changed likewise, for the truth.
    double same_pq = 0.0;
    std::size_t num_rooms = 0;
};

Segmentation rooms_of(const GridMap& map) { return segment(map, {}, RunOptions{1}); }

CaseResult measure(const DataMap& input, const Change& change,
                   const Raster<std::uint16_t>& unchanged_rooms) {
    const Resampling resampling = change.resampling(input.map);
    const GridMap resampled = resample(input.map, resampling);
    const Segmentation found = rooms_of(change.is_noisy ? with_noise(resampled) : resampled);
    // What is too small to count stays the same area.
    const double cells = input.map.resolution_m / resampling.resolution_m;
    const auto ignored = static_cast<std::size_t>(
        std::lround(static_cast<double>(io::kIgnoredRegionPixels) * cells * cells));
    const io::LabelImage rooms = as_label_image(found.labels, ignored);
    const auto pq_against = [&](const auto& truth) {
        return eval::score_rooms(rooms,
                                 as_label_image(resample_nearest(truth, resampling), ignored))
            .pq;
    };
    return {input.name,
            input.kind,
            change.name,
            pq_against(as_raster(input.truth)),
            pq_against(unchanged_rooms),
            found.rooms.size()};
}

struct Mean {
    double pq = 0.0;
    double same_pq = 0.0;
    double worst_change = 0.0;
    std::string worst_map;
    int count = 0;
};

void print_table(const std::vector<CaseResult>& results, const std::vector<Change>& changes) {
    constexpr std::array<const char*, 3> kKinds{"plain", "furnished", "kth"};
    std::map<std::string, double> unchanged_pq;
    for (const CaseResult& result : results) {
        if (result.change == changes.front().name) unchanged_pq[result.map] = result.pq;
    }
    std::map<std::pair<std::string, std::string>, Mean> means;
    for (const CaseResult& result : results) {
        Mean& mean = means[{result.change, result.kind}];
        mean.pq += result.pq;
        mean.same_pq += result.same_pq;
        ++mean.count;
        const double difference = result.pq - unchanged_pq[result.map];
        if (difference >= mean.worst_change) continue;
        mean.worst_change = difference;
        mean.worst_map = result.map;
    }
    std::printf(
        "| change | maps | PQ | less unchanged | PQ with the unchanged rooms as truth | "
        "most lost |\n|---|---|---|---|---|---|\n");
    for (const Change& change : changes) {
        for (const char* kind : kKinds) {
            const Mean& mean = means[{change.name, kind}];
            const Mean& before = means[{changes.front().name, kind}];
            if (mean.count == 0) continue;
            std::printf("| %-26s | %-9s | %5.1f | %+5.1f | %5.1f | %+5.1f %s |\n",
                        change.name.c_str(), kind, 100.0 * mean.pq / mean.count,
                        100.0 * (mean.pq - before.pq) / mean.count,
                        100.0 * mean.same_pq / mean.count, 100.0 * mean.worst_change,
                        mean.worst_map.c_str());
        }
    }
}

int run(int argc, char** argv) {
    const std::vector<DataMap> maps = read_data_maps();
    if (maps.empty()) {
        std::cout << "no data in " QUADCUT_SHARED_DIR ": nothing to measure\n";
        return 0;
    }
    const std::vector<Change> changes = all_changes();
    Progress progress(maps.size() * (changes.size() + 1));
    const auto unchanged = run_cases<Raster<std::uint16_t>>(maps.size(), [&](std::size_t i) {
        Raster<std::uint16_t> labels = rooms_of(maps[i].map).labels;
        progress.note(maps[i].name);
        return labels;
    });
    const auto results = run_cases<CaseResult>(maps.size() * changes.size(), [&](std::size_t i) {
        const std::size_t map = i / changes.size();
        CaseResult result = measure(maps[map], changes[i % changes.size()], unchanged[map]);
        char pq[32];
        std::snprintf(pq, sizeof pq, ": PQ %.1f", 100.0 * result.pq);
        progress.note(result.map + ", " + result.change + pq);
        return result;
    });
    print_table(results, changes);
    Json rows = Json::array();
    for (const CaseResult& result : results) {
        rows.push_back({{"input", result.map},
                        {"kind", result.kind},
                        {"change", result.change},
                        {"pq", result.pq},
                        {"same_pq", result.same_pq},
                        {"rooms", result.num_rooms}});
    }
    write_results(output_path(argc, argv), "invariance", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
