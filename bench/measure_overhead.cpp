// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What the program costs beside its work: the time of `quadcut segment`, from its start to its end,
// against the time that its report gives for the processing (all stages but `read` and `write`);
// its peak memory; and the time of `quadcut version` against that of /bin/true.
//   measure_overhead [-o FILE.json] [MAP ...]     (without maps: the furnished ones of a megapixel)
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "bench/cases.hpp"
#include "bench/child_run.hpp"
#include "bench/result_file.hpp"

namespace quadcut {
namespace {

namespace fs = std::filesystem;

constexpr int kRuns = 15;
constexpr int kShortRuns = 200;
constexpr const char* kNumThreads = "2";

/// Minimums over the runs; the ratio is the median of the runs' own.
struct Overhead {
    std::string map;
    double num_cells = 0.0;
    double wall_ms = std::numeric_limits<double>::infinity();
    double processing_ms = std::numeric_limits<double>::infinity();
    double read_ms = std::numeric_limits<double>::infinity();
    double write_ms = std::numeric_limits<double>::infinity();
    double median_ratio = 0.0;
    /// The most of all runs.
    double peak_bytes = 0.0;

    [[nodiscard]] double ratio() const { return wall_ms / processing_ms; }
    /// Beyond the 32 MiB that any map may take.
    [[nodiscard]] double bytes_per_cell() const {
        constexpr double kAllowance = 32.0 * 1024.0 * 1024.0;
        return std::max(peak_bytes - kAllowance, 0.0) / num_cells;
    }
};

Overhead measure(const fs::path& map, const fs::path& folder) {
    Overhead overhead;
    overhead.map = map.stem().string();
    std::vector<double> ratios;
    for (int i = 0; i < kRuns; ++i) {
        const ChildRun run = run_child({QUADCUT_BINARY, "segment", map.string(), "--threads",
                                        kNumThreads, "-o", folder.string()});
        const auto report = nlohmann::json::parse(std::ifstream(folder / "report.json"));
        double processing_ms = 0.0;
        for (const auto& [stage, ms] : report.at("stages_ms").items()) {
            if (stage != "read" && stage != "write") processing_ms += ms.get<double>();
        }
        const auto stage_ms = [&](const char* stage) {
            return report.at("stages_ms").at(stage).get<double>();
        };
        overhead.num_cells = report.at("map").at("width").get<double>() *
                             report.at("map").at("height").get<double>();
        overhead.wall_ms = std::min(overhead.wall_ms, run.wall_ms);
        overhead.processing_ms = std::min(overhead.processing_ms, processing_ms);
        overhead.read_ms = std::min(overhead.read_ms, stage_ms("read"));
        overhead.write_ms = std::min(overhead.write_ms, stage_ms("write"));
        overhead.peak_bytes = std::max(overhead.peak_bytes, run.peak_bytes);
        ratios.push_back(run.wall_ms / processing_ms);
    }
    std::sort(ratios.begin(), ratios.end());
    overhead.median_ratio = quantile(ratios, 0.5);
    return overhead;
}

/// The shortest of many runs of `quadcut version` and of /bin/true, in turn.
struct StartUp {
    double version_ms = std::numeric_limits<double>::infinity();
    double true_ms = std::numeric_limits<double>::infinity();
    double version_cpu_ms = std::numeric_limits<double>::infinity();

    [[nodiscard]] double ratio() const { return version_ms / true_ms; }
};

StartUp measure_start() {
    StartUp start;
    for (int i = 0; i < kShortRuns; ++i) {
        const ChildRun version = run_child({QUADCUT_BINARY, "version"});
        start.version_ms = std::min(start.version_ms, version.wall_ms);
        start.version_cpu_ms = std::min(start.version_cpu_ms, version.cpu_ms);
        start.true_ms = std::min(start.true_ms, run_child({"/bin/true"}).wall_ms);
    }
    return start;
}

/// The furnished maps of the data that have about a million cells.
std::vector<fs::path> megapixel_maps() {
    std::vector<fs::path> maps;
    const fs::path folder = fs::path(QUADCUT_SHARED_DIR) / "data/rooms";
    for (const char* name : {"office_h", "Freiburg101_scan", "NLB", "office_e"}) {
        const fs::path map = folder / (std::string(name) + ".furnished.yaml");
        if (fs::exists(map)) maps.push_back(map);
    }
    return maps;
}

void print_table(const std::vector<Overhead>& overheads, const StartUp& start) {
    std::printf(
        "| map | megacells | processing ms | read ms | write ms | whole process ms | ratio | "
        "median ratio | peak MiB | bytes a cell over 32 MiB |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Overhead& overhead : overheads) {
        std::printf("| %-26s | %.2f | %.1f | %.1f | %.1f | %.1f | %.2f | %.2f | %.1f | %.1f |\n",
                    overhead.map.c_str(), 1e-6 * overhead.num_cells, overhead.processing_ms,
                    overhead.read_ms, overhead.write_ms, overhead.wall_ms, overhead.ratio(),
                    overhead.median_ratio, overhead.peak_bytes / 1048576.0,
                    overhead.bytes_per_cell());
    }
    std::printf(
        "\n| quadcut version ms | /bin/true ms | ratio | CPU of version ms |\n"
        "|---|---|---|---|\n| %.2f | %.2f | %.1f | %.2f |\n",
        start.version_ms, start.true_ms, start.ratio(), start.version_cpu_ms);
}

void write_json(const fs::path& path, const std::vector<Overhead>& overheads,
                const StartUp& start) {
    Json rows = Json::array();
    for (const Overhead& overhead : overheads) {
        rows.push_back({{"input", overhead.map},
                        {"cells", overhead.num_cells},
                        {"processing_ms", overhead.processing_ms},
                        {"read_ms", overhead.read_ms},
                        {"write_ms", overhead.write_ms},
                        {"wall_ms", overhead.wall_ms},
                        {"ratio", overhead.ratio()},
                        {"median_ratio", overhead.median_ratio},
                        {"peak_bytes", overhead.peak_bytes},
                        {"bytes_per_cell", overhead.bytes_per_cell()}});
    }
    rows.push_back({{"input", "version"},
                    {"version_ms", start.version_ms},
                    {"true_ms", start.true_ms},
                    {"ratio", start.ratio()}});
    write_results(path, "overhead", std::move(rows));
}

int run(int argc, char** argv) {
    std::vector<fs::path> maps;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "-o") {
            ++i;
        } else {
            maps.emplace_back(argv[i]);
        }
    }
    if (maps.empty()) maps = megapixel_maps();
    if (maps.empty()) std::cout << "no data: only the start is measured\n";

    const fs::path folder =
        fs::temp_directory_path() / ("quadcut_overhead_" + std::to_string(::getpid()));
    Progress progress(maps.size());
    std::vector<Overhead> overheads;
    for (const fs::path& map : maps) {
        overheads.push_back(measure(map, folder));
        progress.note(overheads.back().map);
    }
    fs::remove_all(folder);
    const StartUp start = measure_start();
    print_table(overheads, start);
    if (const std::string path = output_path(argc, argv); !path.empty()) {
        write_json(path, overheads, start);
    }
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
