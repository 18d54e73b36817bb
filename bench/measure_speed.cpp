// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// The time of segment(), with defaults, on furnished maps, against the exact distance transform
// that OpenCV makes of the same image: most segmenters of maps begin with one.
//   measure_speed [-o FILE.json]
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "bench/cases.hpp"
#include "bench/result_file.hpp"
#include "bench/segment_timing.hpp"
#include "io/map_server.hpp"

namespace quadcut {
namespace {

namespace fs = std::filesystem;

std::vector<Timing> time_maps(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.find(".furnished.yaml") != std::string::npos) paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    Progress progress(paths.size());
    std::vector<Timing> timings;
    for (const fs::path& path : paths) {
        timings.push_back(time_map(path.stem().stem().string(), io::read_map(path).map));
        progress.note(timings.back().map);
    }
    return timings;
}

void print_table(const std::vector<Timing>& timings) {
    std::printf("| map | megacells | segment ms | distance transform ms | ratio | of CPU times |");
    for (const auto& [stage, ms] : timings.front().stages_ms)
        std::printf(" %s %% |", stage.c_str());
    std::printf("\n|---|---|---|---|---|---|");
    for (std::size_t i = 0; i < timings.front().stages_ms.size(); ++i) std::printf("---|");
    std::printf("\n");
    std::vector<double> ratios;
    for (const Timing& timing : timings) {
        ratios.push_back(timing.ratio());
        std::printf("| %-16s | %.2f | %6.1f | %5.1f | %5.1f | %5.1f |", timing.map.c_str(),
                    1e-6 * static_cast<double>(timing.num_cells), timing.segment_ms,
                    timing.transform_ms, timing.ratio(), timing.cpu_ratio());
        for (const auto& [stage, ms] : timing.stages_ms) {
            std::printf(" %.1f |", 100.0 * ms / timing.segment_ms);
        }
        std::printf("\n");
    }
    std::sort(ratios.begin(), ratios.end());
    std::printf("ratio: median %.1f, worst %.1f\n", quantile(ratios, 0.5), ratios.back());
}

int run(int argc, char** argv) {
    const fs::path folder = fs::path(QUADCUT_SHARED_DIR) / "data/rooms";
    if (!fs::exists(folder)) {
        std::cout << "no data in " << folder.string() << ": nothing to measure\n";
        return 0;
    }
    const std::vector<Timing> timings = time_maps(folder);
    if (timings.empty()) return 0;
    print_table(timings);
    Json rows = Json::array();
    for (const Timing& timing : timings) {
        Json row;
        row["input"] = timing.map;
        row["cells"] = timing.num_cells;
        row["segment_ms"] = timing.segment_ms;
        row["distance_transform_ms"] = timing.transform_ms;
        row["ratio"] = timing.ratio();
        row["segment_cpu_ms"] = timing.segment_cpu_ms;
        row["distance_transform_cpu_ms"] = timing.transform_cpu_ms;
        row["cpu_ratio"] = timing.cpu_ratio();
        for (const auto& [stage, ms] : timing.stages_ms) row["stages_ms"][stage] = ms;
        rows.push_back(std::move(row));
    }
    write_results(output_path(argc, argv), "speed", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
