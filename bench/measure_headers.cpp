// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What a public header costs who includes it: CPU time of compiling it alone, beside that of the
// standard headers that it and what it includes use.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bench/child_run.hpp"
#include "bench/result_file.hpp"

namespace quadcut {
namespace {

namespace fs = std::filesystem;

constexpr int kNumRuns = 5;
const fs::path kSource = QUADCUT_SOURCE_DIR;

/// What a header includes, directly or not.
struct Reached {
    std::set<fs::path> ours;
    std::set<std::string> standard;
};

void add_reached(const fs::path& header, Reached& reached) {
    if (!reached.ours.insert(header).second) return;
    std::ifstream file(header);
    for (std::string line; std::getline(file, line);) {
        constexpr std::string_view kInclude = "#include ";
        if (!line.starts_with(kInclude)) continue;
        const std::string target =
            line.substr(kInclude.size() + 1, line.size() - 2 - kInclude.size());
        if (line[kInclude.size()] == '<') {
            reached.standard.insert(target);
        } else {
            add_reached(kSource / "src" / target, reached);
        }
    }
}

/// The least CPU time of a few compilations, milliseconds.
double compile_ms(const fs::path& folder, const std::string& text) {
    const fs::path file = folder / "includes.cpp";
    std::ofstream(file) << text;
    double least_ms = 1e9;
    for (int i = 0; i < kNumRuns; ++i) {
        const ChildRun run =
            run_child({"/usr/bin/g++", "-std=c++20", "-O2", "-c", "-I", kSource / "include", "-I",
                       kSource / "src", file, "-o", folder / "includes.o"});
        least_ms = std::min(least_ms, run.cpu_ms);
    }
    return least_ms;
}

Json measure(const fs::path& header, const fs::path& folder) {
    Reached reached;
    add_reached(header, reached);
    std::string standard;
    for (const std::string& name : reached.standard) standard += "#include <" + name + ">\n";
    const std::string name = "quadcut/" + header.filename().string();
    const double with_ms = compile_ms(folder, standard + "#include <" + name + ">\n");
    const double without_ms = compile_ms(folder, standard);
    std::printf("| %s | %zu | %.0f | %.0f | %.0f |\n", name.c_str(), reached.ours.size() - 1,
                without_ms, with_ms, with_ms - without_ms);
    return {{"header", name},
            {"num_headers", reached.ours.size() - 1},
            {"standard_ms", without_ms},
            {"compile_ms", with_ms}};
}

int run(int argc, char** argv) {
    const fs::path folder =
        fs::temp_directory_path() / ("quadcut_headers_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    std::vector<fs::path> headers;
    for (const auto& entry : fs::directory_iterator(kSource / "include/quadcut")) {
        if (entry.path().extension() == ".hpp") headers.push_back(entry.path());
    }
    std::sort(headers.begin(), headers.end());
    std::printf(
        "| header | headers of ours | standard ms | with it ms | more ms |\n"
        "|---|---|---|---|---|\n");
    Json rows = Json::array();
    for (const fs::path& header : headers) rows.push_back(measure(header, folder));
    fs::remove_all(folder);
    if (argc > 2 && std::string_view(argv[1]) == "-o") write_results(argv[2], "headers", rows);
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
