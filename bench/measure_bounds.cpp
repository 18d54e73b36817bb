// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What inputs cost that are no maps and logs as they should be: logs with poses far from the others
// against the log without them, and images of one colour against an ordinary map of as many cells.
//   measure_bounds [-o FILE.json]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <zlib.h>

#include "bench/cases.hpp"
#include "bench/child_run.hpp"
#include "bench/result_file.hpp"
#include "io/file.hpp"
#include "io/image.hpp"
#include "sim/building.hpp"

namespace quadcut {
namespace {

namespace fs = std::filesystem;

constexpr int kRuns = 7;
constexpr int kNumScans = 30;

/// A scan of 180 beams in a room of 8 x 6 m that lies at (x, y).
std::string scan_line(double x, double y, int number) {
    std::string line = "FLASER 180";
    for (int i = 0; i < 180; ++i) {
        const double angle = (i - 90) * std::numbers::pi / 180.0;
        const double range = std::min(4.0 / std::max(std::abs(std::cos(angle)), 1e-9),
                                      3.0 / std::max(std::abs(std::sin(angle)), 1e-9));
        line += " " + std::to_string(range);
    }
    const std::string pose = " " + std::to_string(x) + " " + std::to_string(y) + " 0";
    const std::string time = std::to_string(number);
    return line + pose + pose + " " + time + " host " + time + "\n";
}

/// Scans of one room, with another before the given one that is somewhere else.
std::string log_with(int place, double x, double y) {
    std::string log;
    for (int i = 0; i <= kNumScans; ++i) {
        if (i == place) log += scan_line(x, y, i);
        if (i < kNumScans) log += scan_line(0.02 * i, 0.01 * i, i);
    }
    return log;
}

/// Scans in rooms of their own, on a straight line.
std::string log_along(double x_m, double y_m) {
    std::string log;
    for (int i = 0; i < kNumScans; ++i) {
        const double share = static_cast<double>(i) / (kNumScans - 1);
        log += scan_line(share * x_m, share * y_m, i);
    }
    return log;
}

std::string repeated(const std::string& log, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += log;
    return all;
}

struct Cost {
    double cpu_ms = std::numeric_limits<double>::infinity();
    double peak_bytes = std::numeric_limits<double>::infinity();
};

Cost cost_of(const std::string& command, const fs::path& input, const fs::path& folder, int runs) {
    Cost cost;
    for (int i = 0; i < runs; ++i) {
        const ChildRun run = run_child({QUADCUT_BINARY, command, input.string(), "-o",
                                        (folder / "out").string(), "--quiet", "--force"});
        cost.cpu_ms = std::min(cost.cpu_ms, run.cpu_ms);
        cost.peak_bytes = std::min(cost.peak_bytes, run.peak_bytes);
    }
    return cost;
}

/// Each log against the one that it is measured by.
Json measure_logs(const fs::path& folder) {
    struct Case {
        const char* name;
        std::string log;
        std::string base;
    };
    const std::string plain = log_with(-1, 0.0, 0.0);
    const std::vector<Case> cases = {
        {"one of 31 poses 100 km off, the first", log_with(0, 1e5, 0.0), plain},
        {"one of 31 poses 100 km off, in the middle", log_with(15, 1e5, 0.0), plain},
        {"one of 31 poses 100 km off, the last", log_with(kNumScans, 1e5, 0.0), plain},
        {"one of 31 poses on a diagonal of 2 km", log_with(15, 1414.0, 1414.0), plain},
        {"30 scans along a diagonal of 2 km (along x)", log_along(1414.0, 1414.0),
         log_along(2000.0, 0.0)},
        {"6000 scans of a room (1500)", repeated(plain, 200), repeated(plain, 50)},
    };
    Json rows = Json::array();
    for (const Case& one : cases) {
        std::ofstream(folder / "a.log") << one.log;
        std::ofstream(folder / "b.log") << one.base;
        for (const std::string command : {"map", "segment", "follow"}) {
            const Cost cost = cost_of(command, folder / "a.log", folder, kRuns);
            const Cost base = cost_of(command, folder / "b.log", folder, kRuns);
            rows.push_back({{"input", std::string(one.name)},
                            {"command", command},
                            {"cpu_ms", cost.cpu_ms},
                            {"peak_bytes", cost.peak_bytes},
                            {"time_ratio", cost.cpu_ms / base.cpu_ms},
                            {"memory_ratio", cost.peak_bytes / base.peak_bytes}});
        }
    }
    return rows;
}

void append_word(std::string& bytes, std::size_t word) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes.push_back(static_cast<char>(word >> static_cast<unsigned>(shift) & 0xFFU));
    }
}

void append_chunk(std::string& png, const std::string& type_and_data) {
    append_word(png, type_and_data.size() - 4);
    png += type_and_data;
    append_word(png, crc32_z(0, reinterpret_cast<const Bytef*>(type_and_data.data()),
                             type_and_data.size()));
}

/// A square PNG of one bit a pixel, all of them alike.
std::string one_colour(std::int32_t side, bool is_white) {
    std::string header = "IHDR";
    append_word(header, static_cast<std::size_t>(side));
    append_word(header, static_cast<std::size_t>(side));
    header += std::string("\1\0\0\0\0", 5);
    const std::string row =
        std::string(1, '\0') +
        std::string(static_cast<std::size_t>(side + 7) / 8, is_white ? '\xFF' : '\0');
    std::string rows;
    rows.reserve(row.size() * static_cast<std::size_t>(side));
    for (std::int32_t y = 0; y < side; ++y) rows += row;
    uLongf size = compressBound(rows.size());
    std::string packed(size, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
              reinterpret_cast<const Bytef*>(rows.data()), rows.size(), 6);
    packed.resize(size);
    std::string png = "\x89PNG\r\n\x1A\n";
    append_chunk(png, header);
    append_chunk(png, "IDAT" + packed);
    append_chunk(png, "IEND");
    return png;
}

/// One furnished building, again and again.
std::string ordinary(std::int32_t side) {
    sim::BuildingOptions options;
    options.num_rooms = 40;
    const GridMap map = sim::generate_building(options).map;
    const Raster<CellState>& states = map.states;
    return io::encode_png({side, side, 1, 255}, [&](std::int32_t y,
                                                    std::span<std::uint16_t> samples) {
        for (std::size_t x = 0; x < samples.size(); ++x) {
            const auto column = static_cast<std::int32_t>(x) % states.width;
            const CellState state =
                states.at({states.origin.x + column, states.origin.y + y % states.height});
            samples[x] = state == CellState::free ? 254 : state == CellState::occupied ? 0 : 205;
        }
    });
}

Json measure_images(const fs::path& folder) {
    struct Case {
        const char* name;
        std::int32_t side;
        std::string png;
    };
    const std::vector<Case> cases = {
        {"a building, tiled", 12000, ordinary(12000)},
        {"black", 30000, one_colour(30000, false)},
        {"free", 20000, one_colour(20000, true)},
    };
    Json rows = Json::array();
    double ordinary_ns = 0.0;
    for (const Case& one : cases) {
        io::write_file_atomically(folder / "a.png", one.png);
        const Cost cost = cost_of("segment", folder / "a.png", folder, 1);
        const double num_cells = static_cast<double>(one.side) * one.side;
        const double ns = 1e6 * cost.cpu_ms / num_cells;
        if (ordinary_ns == 0.0) ordinary_ns = ns;
        rows.push_back({{"input", std::string(one.name)},
                        {"command", "segment"},
                        {"cells", num_cells},
                        {"ns_per_cell", ns},
                        {"bytes_per_cell", cost.peak_bytes / num_cells},
                        {"time_ratio", ns / ordinary_ns}});
    }
    return rows;
}

int run(int argc, char** argv) {
    const fs::path folder =
        fs::temp_directory_path() / ("quadcut_bounds_" + std::to_string(getpid()));
    fs::create_directories(folder);
    Json rows = measure_logs(folder);
    for (Json& row : measure_images(folder)) rows.push_back(std::move(row));
    fs::remove_all(folder);
    for (const Json& row : rows) std::printf("%s\n", row.dump().c_str());
    write_results(output_path(argc, argv), "bounds", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
