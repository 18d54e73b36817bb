// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "io/file.hpp"

// The file that a benchmark writes with -o: rows, and where they come from. bench/compare shows two
// of them side by side, tools/results.py makes the tables of the documentation from them.
namespace quadcut {

using Json = nlohmann::ordered_json;

namespace result_file {

/// What follows `key` and a separator on the first line of a file that starts with it.
inline std::string value_in(const char* path, std::string_view key, char separator) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (line.rfind(key, 0) != 0) continue;
        const std::size_t at = line.find(separator);
        if (at == std::string::npos) continue;
        const std::size_t first = line.find_first_not_of(" \t\"", at + 1);
        const std::size_t last = line.find_last_not_of(" \t\"");
        return first == std::string::npos ? "" : line.substr(first, last + 1 - first);
    }
    return "unknown";
}

inline std::string environment(const char* name, const std::string& otherwise) {
    const char* value = std::getenv(name);
    return value == nullptr || *value == '\0' ? otherwise : value;
}

inline Json machine() {
    const double bytes =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
    return {{"cpu", value_in("/proc/cpuinfo", "model name", ':')},
            {"cores", std::thread::hardware_concurrency()},
            {"memory_gib", std::round(10.0 * bytes / 1073741824.0) / 10.0},
            {"os", value_in("/etc/os-release", "PRETTY_NAME", '=')},
            {"compiler", "g++ " __VERSION__}};
}

/// What all processes of the machine, and this one with its children, have used.
struct CpuUse {
    std::chrono::steady_clock::time_point at;
    double all_s = 0.0;
    double own_s = 0.0;
};

inline CpuUse cpu_use() {
    CpuUse use;
    use.at = std::chrono::steady_clock::now();
    std::string word;
    double user = 0.0;
    double nice = 0.0;
    double system = 0.0;
    std::ifstream("/proc/stat") >> word >> user >> nice >> system;
    use.all_s = (user + nice + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
    for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(whose, &usage);
        for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
            use.own_s +=
                static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        }
    }
    return use;
}

inline const CpuUse kUseAtStart = cpu_use();

/// How many cores other processes kept busy since this one started, on average.
inline double cores_of_others() {
    const CpuUse now = cpu_use();
    const double elapsed_s = std::chrono::duration<double>(now.at - kUseAtStart.at).count();
    const double others_s = (now.all_s - kUseAtStart.all_s) - (now.own_s - kUseAtStart.own_s);
    return std::max(0.0, std::round(100.0 * others_s / std::max(elapsed_s, 0.1)) / 100.0);
}

inline std::string now_utc() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

/// Six significant digits: more of a measurement would be noise.
inline void round_numbers(Json& value) {
    if (value.is_number_float()) {
        char text[32];
        std::snprintf(text, sizeof text, "%.6g", value.get<double>());
        value = std::strtod(text, nullptr);
    } else if (value.is_structured()) {
        for (Json& part : value) round_numbers(part);
    }
}

}  // namespace result_file

/// Writes `rows`, an array of objects, in the envelope of the benchmark `name`, through a temporary
/// file; nothing when `path` is empty. A row is known by its texts: no two have all of them alike.
/// ./run says which commit was measured, and by which command. `cores_of_others` tells times that
/// were measured beside other work. Throws InputError when the file cannot be written.
inline void write_results(const std::string& path, const std::string& name, Json rows) {
    using result_file::environment;
    if (path.empty()) return;
    Json envelope;
    envelope["format_version"] = 1;
    envelope["benchmark"] = name;
    envelope["machine"] = result_file::machine();
    envelope["commit"] = environment("QUADCUT_BENCH_COMMIT", "unknown");
    envelope["command"] =
        environment("QUADCUT_BENCH_COMMAND", "build/release/bench/measure_" + name);
    envelope["date"] = result_file::now_utc();
    envelope["cores_of_others"] = result_file::cores_of_others();
    std::string text = envelope.dump(1);
    text.resize(text.rfind('\n'));
    text += ",\n \"rows\": [";
    // A row a line, so that a difference between two files shows the rows that differ.
    for (Json& row : rows) {
        result_file::round_numbers(row);
        text += (&row == &rows.front() ? "\n  " : ",\n  ") + row.dump();
    }
    io::write_file_atomically(path, text + "\n ]\n}\n");
}

}  // namespace quadcut
