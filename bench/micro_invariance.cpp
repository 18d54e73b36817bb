// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What a change of the map that changes no room does to the rooms: turned, mirrored, at another
// resolution, with noise, padded, moved by a cell.
//   micro_invariance [-o FILE.json]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "bench/cases.hpp"
#include "io/map_server.hpp"
#include "io/score.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
namespace {

namespace fs = std::filesystem;

/// A cell takes what this many samples a side find in it.
constexpr int kSamples = 4;
constexpr double kNoise = 0.005;
constexpr std::int32_t kPaddingCells = 37;

struct TruthMap {
    std::string name;
    /// "plain", "furnished", "kth".
    std::string kind;
    GridMap map;
    Raster<std::uint32_t> truth;
};

/// Where each point of the changed image is in the unchanged one, both in cells.
struct Resampling {
    std::int32_t width = 0;
    std::int32_t height = 0;
    double resolution_m = 0.0;
    /// The changed image's point in the unchanged one.
    std::function<Point(const Point&)> source;
};

Cell cell_of(const Point& point) {
    return {static_cast<std::int32_t>(std::floor(point.x)),
            static_cast<std::int32_t>(std::floor(point.y))};
}

/// Of all that a cell covers an obstacle wins, then what is unknown; outside nothing is known.
GridMap resample(const GridMap& map, const Resampling& change) {
    GridMap changed{change.resolution_m, {}, {{0, 0}, change.width, change.height}};
    for (std::size_t i = 0; i < changed.states.values.size(); ++i) {
        const Cell cell = changed.states.cell(i);
        CellState state = CellState::free;
        for (int sample = 0; sample < kSamples * kSamples; ++sample) {
            const int row = sample / kSamples;
            const int column = sample % kSamples;
            const Cell source = cell_of(change.source(
                {cell.x + (column + 0.5) / kSamples, cell.y + (row + 0.5) / kSamples}));
            const CellState at =
                map.states.contains(source) ? map.states.at(source) : CellState::unknown;
            if (at == CellState::occupied || state == CellState::free) state = at;
        }
        changed.states.values[i] = state;
    }
    return changed;
}

/// Each cell takes the label at its centre.
template <typename Label>
Raster<Label> resample_nearest(const Raster<Label>& labels, const Resampling& change) {
    Raster<Label> changed({0, 0}, change.width, change.height);
    for (std::size_t i = 0; i < changed.values.size(); ++i) {
        const Cell cell = changed.cell(i);
        const Cell source = cell_of(change.source({cell.x + 0.5, cell.y + 0.5}));
        if (labels.contains(source)) changed.values[i] = labels.at(source);
    }
    return changed;
}

Resampling turned(const GridMap& map, double degrees) {
    const double width = map.states.width;
    const double height = map.states.height;
    const double c = std::cos(degrees * std::numbers::pi / 180.0);
    const double s = std::sin(degrees * std::numbers::pi / 180.0);
    // Less than a thousandth of a cell is rounding.
    const auto side = [](double cells) {
        return static_cast<std::int32_t>(std::ceil(cells - 1e-3));
    };
    Resampling change{side(width * std::abs(c) + height * std::abs(s)),
                      side(width * std::abs(s) + height * std::abs(c)),
                      map.resolution_m,
                      {}};
    const Point middle{0.5 * change.width, 0.5 * change.height};
    change.source = [=](const Point& at) {
        const double x = at.x - middle.x;
        const double y = at.y - middle.y;
        return Point{0.5 * width + c * x + s * y, 0.5 * height - s * x + c * y};
    };
    return change;
}

Resampling mirrored(const GridMap& map) {
    const std::int32_t width = map.states.width;
    return {width, map.states.height, map.resolution_m, [width](const Point& at) {
                return Point{width - at.x, at.y};
            }};
}

/// `cells` cells of the changed map are as long as one of the unchanged.
Resampling scaled(const GridMap& map, double cells) {
    return {static_cast<std::int32_t>(std::ceil(map.states.width * cells)),
            static_cast<std::int32_t>(std::ceil(map.states.height * cells)),
            map.resolution_m / cells, [cells](const Point& at) {
                return Point{at.x / cells, at.y / cells};
            }};
}

/// More cells at the lower left and at the upper right.
Resampling padded(const GridMap& map, std::int32_t before, std::int32_t after) {
    return {map.states.width + before + after, map.states.height + before + after, map.resolution_m,
            [before](const Point& at) {
                return Point{at.x - before, at.y - before};
            }};
}

/// Flips known cells: free becomes occupied and the other way round.
GridMap with_noise(const GridMap& map) {
    GridMap noisy = map;
    Random random(1);
    for (CellState& state : noisy.states.values) {
        if (state == CellState::unknown || random.uniform() >= kNoise) continue;
        state = state == CellState::free ? CellState::occupied : CellState::free;
    }
    return noisy;
}

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

std::vector<TruthMap> read_maps(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".yaml") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<TruthMap> maps;
    for (const fs::path& path : paths) {
        const std::string name = path.stem().string();
        const std::size_t dot = name.find('.');
        const io::LabelImage truth =
            io::read_label_image(folder / (name.substr(0, dot) + ".rooms.png"));
        maps.push_back({name, name.rfind("kth_", 0) == 0 ? "kth" : name.substr(dot + 1),
                        io::read_map(path).map, as_raster(truth)});
    }
    return maps;
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

Segmentation rooms_of(const GridMap& map) {
    SegmentOptions options;
    options.num_threads = 1;
    return segment(map, options);
}

CaseResult measure(const TruthMap& input, const Change& change,
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
        return io::score_rooms(rooms, as_label_image(resample_nearest(truth, resampling), ignored))
            .pq;
    };
    return {input.name,
            input.kind,
            change.name,
            pq_against(input.truth),
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
    const fs::path folder = fs::path(QUADCUT_SHARED_DIR) / "data/rooms";
    if (!fs::exists(folder)) {
        std::cout << "no data in " << folder.string() << ": nothing to measure\n";
        return 0;
    }
    const std::vector<TruthMap> maps = read_maps(folder);
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
    if (const std::string path = output_path(argc, argv); !path.empty()) {
        auto rows = nlohmann::ordered_json::array();
        for (const CaseResult& result : results) {
            rows.push_back({{"input", result.map},
                            {"kind", result.kind},
                            {"change", result.change},
                            {"pq", result.pq},
                            {"same_pq", result.same_pq},
                            {"rooms", result.num_rooms}});
        }
        std::ofstream(path) << rows.dump(1) << "\n";
    }
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
