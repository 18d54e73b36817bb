// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What each ingredient is worth: hand-labelled maps with one thing changed at a time.
//   measure_ablation [BUILDING] [--simulated N] [-o FILE.json]
// tools/train/ablation.py runs it with each building left out of the training of the door model,
// and makes the table.
#include <chrono>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/building_case.hpp"
#include "bench/cases.hpp"
#include "bench/data_map.hpp"
#include "bench/result_file.hpp"
#include "eval/labels.hpp"
#include "eval/score.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
namespace {

struct Variant {
    std::string ingredient;
    std::string name;
    std::function<void(SegmentOptions&)> change;
};

std::vector<Variant> variants() {
    return {{"", "as it is", [](SegmentOptions&) {}},
            {"furniture", "every obstacle counts",
             [](SegmentOptions& options) { options.rooms.max_furniture_m2 = 0.0; }},
            {"pieces", "basins",
             [](SegmentOptions& options) { options.rooms.pieces = PieceSource::basins; }},
            {"pieces", "spectral",
             [](SegmentOptions& options) { options.rooms.pieces = PieceSource::spectral; }}};
}

struct Score {
    double pq = 0.0;
    double elapsed_ms = 0.0;
};

Score try_variant(const Variant& variant, const GridMap& map, std::span<const Point> trajectory,
                  const io::LabelImage& truth) {
    SegmentOptions options;
    variant.change(options);
    const auto start = std::chrono::steady_clock::now();
    const Segmentation rooms = segment(map, options, RunOptions{1}, trajectory);
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    return {eval::score_rooms(as_label_image(rooms.labels), truth).pq, elapsed.count()};
}

Json row_of(const std::string& kind, const std::string& map, const Variant& variant,
            const Score& score) {
    std::printf("%-10s %-32s %-20s %-36s %5.1f %7.1f ms\n", kind.c_str(), map.c_str(),
                variant.ingredient.c_str(), variant.name.c_str(), 100.0 * score.pq,
                score.elapsed_ms);
    return {{"kind", kind},
            {"input", map},
            {"ingredient", variant.ingredient},
            {"variant", variant.name},
            {"pq", score.pq},
            {"elapsed_ms", score.elapsed_ms}};
}

int run(int argc, char** argv) {
    std::string building;
    std::size_t num_simulated = 0;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "-o") {
            ++i;
        } else if (argument == "--simulated" && i + 1 < argc) {
            num_simulated = std::stoul(argv[++i]);
        } else {
            building = argument;
        }
    }
    Json rows = Json::array();
    const std::vector<Variant> all = variants();
    for (const DataMap& data : read_data_maps(building)) {
        const io::LabelImage truth = as_label_image(as_raster(data.truth));
        for (const Variant& variant : all) {
            rows.push_back(
                row_of(data.kind, data.name, variant, try_variant(variant, data.map, {}, truth)));
        }
    }
    for (std::size_t i = 0; i < num_simulated; ++i) {
        const MappedBuilding mapped = map_building(building_case(i));
        const io::LabelImage truth = as_label_image(mapped.truth);
        const std::string name = "seed " + std::to_string(building_case(i).seed);
        for (const Variant& variant : all) {
            rows.push_back(row_of("simulated", name, variant,
                                  try_variant(variant, mapped.map, mapped.trajectory, truth)));
        }
    }
    write_results(output_path(argc, argv), "ablation", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
