// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What readers of a project cost, and how long they wait: a log is followed in memory, without
// readers and beside some that ask for a snapshot every 20 ms; at its end, what one costs.
//   measure_readers [-o FILE.json] [LOG ...]      logs of the data
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bench/result_file.hpp"
#include "bench/shared_folder.hpp"
#include "io/carmen.hpp"
#include "project/project.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/follow/followed_map.hpp"

namespace quadcut {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPause{20};

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// One that looks until `is_over`: how long it waited each time.
std::vector<double> waits_of_reader(const Project& project, const std::atomic<bool>& is_over) {
    std::vector<double> waits_ms;
    while (!is_over) {
        const auto start = Clock::now();
        static_cast<void>(project.snapshot());
        waits_ms.push_back(ms_since(start));
        std::this_thread::sleep_for(kPause);
    }
    return waits_ms;
}

Json follow_beside(std::size_t num_readers, const std::vector<Scan>& scans, Project& project) {
    std::atomic<bool> is_over = false;
    std::vector<std::vector<double>> waits(num_readers);
    std::vector<std::thread> readers;
    for (std::vector<double>& own : waits) {
        readers.emplace_back([&] { own = waits_of_reader(project, is_over); });
    }
    const auto start = Clock::now();
    double longest_ms = 0.0;
    for (const Scan& scan : scans) {
        const auto begun = Clock::now();
        try {
            project.add(scan);
        } catch (const InputError&) {
            continue;
        }
        longest_ms = std::max(longest_ms, ms_since(begun));
    }
    project.finish();
    const double follow_s = ms_since(start) / 1000.0;
    is_over = true;
    for (std::thread& reader : readers) reader.join();
    std::vector<double> all;
    for (const std::vector<double>& own : waits) all.insert(all.end(), own.begin(), own.end());
    std::sort(all.begin(), all.end());
    const auto wait_ms = [&](double share) {
        const auto place = static_cast<std::size_t>(share * static_cast<double>(all.size()));
        return all.empty() ? 0.0 : all[std::min(place, all.size() - 1)];
    };
    std::printf(
        "  %zu readers: %.1f s, longest update %.1f ms, waits: median %.2f, p99 %.2f, "
        "longest %.2f ms\n",
        num_readers, follow_s, longest_ms, wait_ms(0.5), wait_ms(0.99), wait_ms(1.0));
    return {{"readers", num_readers},          {"follow_s", follow_s},
            {"longest_update_ms", longest_ms}, {"wait_median_ms", wait_ms(0.5)},
            {"wait_p99_ms", wait_ms(0.99)},    {"wait_longest_ms", wait_ms(1.0)}};
}

void add_cost_at_end(const Project& project, Json& row) {
    const auto timed = [](const auto& work) {
        const auto start = Clock::now();
        work();
        return ms_since(start);
    };
    std::shared_ptr<const Snapshot> building;
    row["snapshot_ms"] = timed([&] { building = project.snapshot(); });
    row["snapshot_bytes"] = building->followed()->map.bytes() + building->followed()->cells.bytes();
    row["again_ms"] = timed([&] { static_cast<void>(project.snapshot()); });
    row["map_ms"] = timed([&] { static_cast<void>(building->map()); });
    row["rooms_ms"] = timed([&] { static_cast<void>(building->rooms()); });
    std::printf("  at the end: %s\n", row.dump().c_str());
}

int run(int argc, char** argv) {
    std::string output;
    std::vector<std::string> names;
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "-o" && i + 1 < argc) {
            output = argv[++i];
        } else {
            names.emplace_back(argv[i]);
        }
    }
    if (names.empty()) names = {"intel_dense.log.gz", "mit_killian_dense.log.gz"};
    Json rows = Json::array();
    for (const std::string& name : names) {
        const std::vector<Scan> scans = io::read_carmen_log(shared_path("data/logs/" + name)).scans;
        std::printf("%s\n", name.c_str());
        std::fflush(stdout);
        for (const std::size_t num_readers : {0U, 1U, 50U}) {
            Project project = Project::in_memory({});
            Json row = follow_beside(num_readers, scans, project);
            if (num_readers == 0) add_cost_at_end(project, row);
            row["input"] = name;
            rows.push_back(std::move(row));
            std::fflush(stdout);
        }
    }
    write_results(output, "readers", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
