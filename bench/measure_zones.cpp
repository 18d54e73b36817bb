// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Zones against the wings of simulated campuses (bench/campus.hpp), cut into rooms as by default:
//   measure_zones [-o FILE.json] [--campuses N] [--first DRAW]
// Each room that was found is of the wing in which most of its cells are; how well zones and wings
// agree is the adjusted Rand index over rooms. See docs/decisions/0020-zones.md.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/campus.hpp"
#include "bench/cases.hpp"
#include "bench/result_file.hpp"
#include "eval/score.hpp"
#include "quadcut/segment/segment.hpp"
#include "quadcut/zones/zones.hpp"

namespace quadcut {
namespace {

/// Of the rooms that are in a wing.
double agreement(const Zones& zones, const std::vector<std::uint32_t>& wings) {
    io::LabelImage found{static_cast<std::int32_t>(wings.size()), 1, 0, zones.zone_of_room, {}};
    io::LabelImage truth{static_cast<std::int32_t>(wings.size()), 1, 0, wings, {}};
    for (std::size_t i = 0; i < wings.size(); ++i) {
        if (wings[i] == 0) found.values[i] = 0;
    }
    found.num_regions = zones.count;
    truth.num_regions = *std::max_element(wings.begin(), wings.end());
    return eval::score_rooms(found, truth).ari;
}

Json measure(const sim::BuildingOptions& options, const std::string& kind, std::size_t draw) {
    const sim::Building building = sim::generate_building(options);
    const Segmentation rooms = segment(building.map);
    const std::vector<std::uint32_t> wings = wings_of_rooms(building, rooms);
    std::vector<std::uint32_t> numbers = wings;
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    const std::size_t num_wings = numbers.size() - (numbers.front() == 0 ? 1 : 0);
    const Zones told = find_zones(rooms, {num_wings, ZoneWeights::conductance});
    const Zones found = find_zones(rooms, {0, ZoneWeights::conductance});
    Json row;
    row["kind"] = kind;
    row["campus"] = std::to_string(draw);
    row["rooms"] = rooms.rooms.size();
    row["wings"] = num_wings;
    row["ari_told"] = agreement(told, wings);
    row["zones"] = found.count;
    row["ari"] = agreement(found, wings);
    std::printf("| %-8s | %2zu | %3zu | %zu | %.3f | %2u | %.3f |\n", kind.c_str(), draw,
                rooms.rooms.size(), num_wings, row["ari_told"].get<double>(), found.count,
                row["ari"].get<double>());
    std::fflush(stdout);
    return row;
}

void print_means(const Json& rows, const std::string& kind) {
    std::vector<double> told;
    std::vector<double> found;
    std::size_t num_right = 0;
    for (const Json& row : rows) {
        if (row["kind"] != kind) continue;
        told.push_back(row["ari_told"].get<double>());
        found.push_back(row["ari"].get<double>());
        num_right += row["zones"] == row["wings"] ? 1 : 0;
    }
    const auto mean = [](const std::vector<double>& values) {
        double sum = 0.0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    };
    std::printf(
        "%s: told the number ARI %.3f (least %.3f), by eigengap %.3f (least %.3f), "
        "the number right in %zu of %zu\n",
        kind.c_str(), mean(told), *std::min_element(told.begin(), told.end()), mean(found),
        *std::min_element(found.begin(), found.end()), num_right, told.size());
}

int run(int argc, char** argv) {
    std::size_t count = 30;
    std::size_t first = 0;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (std::string(argv[i]) == "--campuses") count = std::stoul(argv[i + 1]);
        if (std::string(argv[i]) == "--first") first = std::stoul(argv[i + 1]);
    }
    std::printf(
        "| kind | draw | rooms | wings | ARI, told | zones | ARI, by eigengap |\n"
        "|---|---|---|---|---|---|---|\n");
    Json rows = Json::array();
    for (std::size_t draw = first; draw < first + count; ++draw) {
        rows.push_back(measure(campus_of_wings(draw), "campus", draw));
    }
    // Wings that go over into each other, half of them with one corridor through both.
    for (std::size_t draw = first; draw < first + count; ++draw) {
        sim::BuildingOptions options = campus_of_wings(draw);
        options.num_wings = 0;
        rows.push_back(measure(options, "building", draw));
    }
    print_means(rows, "campus");
    print_means(rows, "building");
    write_results(output_path(argc, argv), "zones", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
