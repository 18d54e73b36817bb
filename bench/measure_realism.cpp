// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Whether simulated robot maps are as hard as real ones: what simple methods lose from clean to
// cluttered simulation, beside what they lose from hand-cleaned to real maps.
//   measure_realism [-o FILE.json] [--buildings N] [--maps FOLDER] [--picture FILE.png]
// --maps: the scanned buildings go there, a folder each: map.pgm, map.yaml, rooms.png.
// --picture: sixteen parts of real maps at the left, of simulated ones at the right.
#include <array>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bench/baseline.hpp"
#include "bench/cases.hpp"
#include "bench/crop_sheet.hpp"
#include "bench/data_map.hpp"
#include "bench/result_file.hpp"
#include "bench/threshold_baseline.hpp"
#include "bench/void_rule.hpp"
#include "eval/labels.hpp"
#include "eval/score.hpp"
#include "io/file_batch.hpp"
#include "io/label_image.hpp"
#include "io/map_writer.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "sim/building.hpp"
#include "sim/reality.hpp"

namespace quadcut {
namespace {

namespace fs = std::filesystem;

using Labels = Raster<std::uint32_t>;

/// Other buildings than those of `buildings`, and than those that the door model is trained on.
constexpr std::uint64_t kFirstRealitySeed = 7001;

const std::array<std::string, 4> kKinds{"simulated, clean", "simulated, scanned", "real, clean",
                                        "real, scanned"};

struct Method {
    std::string name;
    std::function<Labels(const GridMap&)> cut;
};
const std::array<Method, 3> kMethods{
    {{"distance transform", [](const GridMap& map) { return threshold_baseline(map); }},
     {"watershed", [](const GridMap& map) { return watershed_baseline(map, {}); }},
     {"quadcut", [](const GridMap& map) {
          const auto labels = segment(map).labels;
          Labels result(labels.origin, labels.width, labels.height);
          std::copy(labels.values.begin(), labels.values.end(), result.values.begin());
          return result;
      }}}};

struct Input {
    std::string name;
    std::size_t kind = 0;
    GridMap map;
    Labels truth;
    double made_in_s = 0.0;
};

int num_rooms_of(std::size_t i) { return 14 + static_cast<int>(i * 17 % 37); }

sim::RealMap scanned(std::size_t i) {
    sim::RealityOptions options;
    options.seed = kFirstRealitySeed + i;
    options.num_rooms = num_rooms_of(i);
    return sim::scan_as_robots_do(options);
}

/// The same building as its architect draws it.
Input clean_building(std::size_t i) {
    sim::Building building = scanned(i).building;
    Labels truth = labels_at(building.bare, building.bare_labels, building.bare);
    return {"seed " + std::to_string(kFirstRealitySeed + i), 0, std::move(building.bare),
            std::move(truth)};
}

Input scanned_building(std::size_t i) {
    timespec begin{};
    timespec end{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &begin);
    sim::RealMap real = scanned(i);
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
    const double seconds = static_cast<double>(end.tv_sec - begin.tv_sec) +
                           1e-9 * static_cast<double>(end.tv_nsec - begin.tv_nsec);
    return {"seed " + std::to_string(kFirstRealitySeed + i), 1, std::move(real.map),
            std::move(real.truth), seconds};
}

/// The hand-made maps of the data, and those of `data/real` that robots have scanned.
std::vector<Input> real_maps() {
    std::vector<Input> inputs;
    for (DataMap& data : read_data_maps()) {
        if (data.kind != "plain") continue;
        inputs.push_back({data.name, 2, std::move(data.map), as_raster(data.truth)});
    }
    const fs::path folder = shared_path("data/real");
    if (!fs::exists(folder)) return inputs;
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const bool is_drawn = entry.path().stem() == "campus_1";
        if (entry.path().extension() == ".yaml" && !is_drawn) paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) {
        const std::string name = path.stem().string();
        inputs.push_back({name, 3, io::read_map(path).map,
                          as_raster(io::read_label_image(folder / (name + ".rooms.png")))});
    }
    return inputs;
}

void write_map(const Input& input, const fs::path& folder) {
    io::FileBatch batch(folder / input.name);
    io::add_map(batch, input.map);
    Raster<std::uint16_t> rooms(input.truth.origin, input.truth.width, input.truth.height);
    std::copy(input.truth.values.begin(), input.truth.values.end(), rooms.values.begin());
    batch.add("rooms.png", io::encode_label_png(rooms));
    batch.commit();
}

/// A row a method.
std::vector<Json> rows_of(const Input& input) {
    std::vector<Json> rows;
    for (const Method& method : kMethods) {
        const Labels rooms = without_void(method.cut(input.map), input.truth, input.map);
        const eval::RoomScore score =
            eval::score_rooms(as_label_image(rooms), as_label_image(input.truth));
        Json row;
        row["input"] = input.name;
        row["kind"] = kKinds[input.kind];
        row["method"] = method.name;
        row["pq"] = score.pq;
        row["rooms"] = score.rooms;
        row["true_rooms"] = score.truth;
        if (input.kind == 1) row["made_in_s"] = input.made_in_s;
        rows.push_back(std::move(row));
    }
    return rows;
}

void print_drops(const Json& rows) {
    std::map<std::string, std::map<std::string, std::pair<double, int>>> sums;
    for (const Json& row : rows) {
        auto& [sum, count] = sums[row["method"]][row["kind"]];
        sum += row["pq"].get<double>();
        ++count;
    }
    std::printf("| method |");
    for (const std::string& kind : kKinds) std::printf(" %s |", kind.c_str());
    std::printf(" drop, simulated | drop, real |\n|---|---|---|---|---|---|---|\n");
    for (const Method& method : kMethods) {
        std::array<double, 4> means{};
        for (std::size_t k = 0; k < kKinds.size(); ++k) {
            const auto& [sum, count] = sums[method.name][kKinds[k]];
            means[k] = count == 0 ? 0.0 : 100.0 * sum / count;
        }
        std::printf("| %s | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f |\n", method.name.c_str(),
                    means[0], means[1], means[2], means[3], means[0] - means[1],
                    means[2] - means[3]);
    }
}

/// Real maps as often as it takes.
void draw_crops(const std::vector<Input>& real, const fs::path& path) {
    CropSheet sheet;
    std::vector<const Input*> scanned;
    for (const Input& input : real) {
        if (input.kind == 3) scanned.push_back(&input);
    }
    for (std::size_t i = 0; i < CropSheet::kNumCrops; ++i) {
        if (!scanned.empty()) sheet.add(0, scanned[i % scanned.size()]->map, i + 1);
        sheet.add(1, scanned_building(2 * i + 1).map, i + 1);
    }
    sheet.write(path);
}

int run(int argc, char** argv) {
    std::size_t num_buildings = 24;
    fs::path maps;
    fs::path picture;
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::string(argv[i]) == "--buildings") num_buildings = std::stoul(argv[i + 1]);
        if (std::string(argv[i]) == "--maps") maps = argv[i + 1];
        if (std::string(argv[i]) == "--picture") picture = argv[i + 1];
    }
    const std::vector<Input> real = real_maps();
    if (!picture.empty()) draw_crops(real, picture);
    const std::size_t count = 2 * num_buildings + real.size();
    Progress progress(count);
    const auto results = run_cases<std::vector<Json>>(count, [&](std::size_t i) {
        const Input input = i < num_buildings       ? clean_building(i)
                            : i < 2 * num_buildings ? scanned_building(i - num_buildings)
                                                    : real[i - 2 * num_buildings];
        if (!maps.empty() && input.kind == 1) write_map(input, maps);
        std::vector<Json> rows = rows_of(input);
        std::string text = input.name + ", " + kKinds[input.kind] + ":";
        char number[64];
        for (const Json& row : rows) {
            std::snprintf(number, sizeof number, " %.0f", 100.0 * row["pq"].get<double>());
            text += number;
        }
        std::snprintf(number, sizeof number, "; %d rooms, %.2f s",
                      rows.front()["true_rooms"].get<int>(), input.made_in_s);
        progress.note(text + number);
        return rows;
    });
    Json rows = Json::array();
    for (const std::vector<Json>& some : results) {
        for (const Json& row : some) rows.push_back(row);
    }
    print_drops(rows);
    write_results(output_path(argc, argv), "realism", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
