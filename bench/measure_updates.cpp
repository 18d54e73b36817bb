// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Scans into a map, 5 cm: quadcut (as `quadcut map` and `follow` do), a flat grid with Bresenham's
// lines and one byte a cell, and OctoMap (insertPointCloud with lazy evaluation, as it is and with
// the cloud discretized, updateInnerOccupancy() at the end; its clouds are made beforehand). All on
// one thread, in turn; the least CPU time of five rounds.
//   measure_updates [-o FILE.json] [LOG ...]      logs of the data, or files
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <octomap/octomap.h>

#include "bench/cases.hpp"
#include "bench/cpu_time.hpp"
#include "bench/flat_ray_caster.hpp"
#include "bench/result_file.hpp"
#include "io/carmen.hpp"
#include "quadcut/map/integrate.hpp"

namespace quadcut {
namespace {

constexpr double kResolution = 0.05;
constexpr int kRounds = 5;
const IntegrateOptions kOptions;

struct Measured {
    std::string name;
    double least_ms = std::numeric_limits<double>::infinity();
    std::size_t bytes = 0;
    std::size_t known_cells = 0;

    [[nodiscard]] double known_m2() const {
        return static_cast<double>(known_cells) * kResolution * kResolution;
    }
};

/// The end points in the map's frame, all in one plane, of beams that hit something.
struct Cloud {
    octomap::Pointcloud points;
    octomap::point3d sensor;
};

Cloud cloud_of(const Scan& scan) {
    const Pose& pose = scan.world_from_sensor;
    // The middle of a layer of cells, where no rounding moves a point to the next one.
    const auto height = static_cast<float>(0.5 * kResolution);
    Cloud cloud;
    cloud.sensor = {static_cast<float>(pose.x), static_cast<float>(pose.y), height};
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
        const double range = static_cast<double>(scan.ranges_m[i]);
        if (!(range > 0.0 && range < std::min(scan.max_range_m, kOptions.usable_range_m))) continue;
        const double angle =
            pose.yaw_rad + scan.first_angle_rad + scan.angle_step_rad * static_cast<double>(i);
        cloud.points.push_back(static_cast<float>(pose.x + range * std::cos(angle)),
                               static_cast<float>(pose.y + range * std::sin(angle)), height);
    }
    return cloud;
}

/// Of CPU: a long run among other work is interrupted, a short one often is not, which would favour
/// the fast.
template <typename Work>
double timed_ms(const Work& work) {
    const double start_ms = cpu_ms();
    work();
    return cpu_ms() - start_ms;
}

void note_size(const OccupancyMap& map, Measured& measured) {
    measured.bytes = map.bytes();
    const Raster<CellState> states = map.to_raster();
    measured.known_cells =
        states.values.size() - static_cast<std::size_t>(std::count(
                                   states.values.begin(), states.values.end(), CellState::unknown));
}

/// Scan by scan, each with its MapUpdate: what a follower needs.
void run_quadcut(const std::vector<Scan>& scans, Measured& measured) {
    OccupancyMap map(kResolution);
    measured.least_ms = std::min(measured.least_ms, timed_ms([&] {
                                     for (const Scan& scan : scans) {
                                         integrate_scan(map, scan, kOptions);
                                     }
                                 }));
    note_size(map, measured);
}

/// All scans at once, the tree brought up to date now and then: as OctoMap's lazy evaluation does.
void run_quadcut_on_log(const std::vector<Scan>& scans, Measured& measured) {
    OccupancyMap map(kResolution);
    measured.least_ms = std::min(
        measured.least_ms, timed_ms([&] { map = map_from_scans(scans, kResolution, kOptions); }));
    note_size(map, measured);
}

void run_flat(const std::vector<Scan>& scans, Measured& measured) {
    FlatRayCaster map(scans, kResolution, kOptions.usable_range_m);
    measured.least_ms = std::min(measured.least_ms, timed_ms([&] {
                                     for (const Scan& scan : scans) map.add(scan);
                                 }));
    measured.bytes = map.bytes();
    measured.known_cells = map.num_known_cells();
}

void run_octomap(const std::vector<Cloud>& clouds, bool is_discretized, Measured& measured) {
    octomap::OcTree tree(kResolution);
    measured.least_ms = std::min(measured.least_ms, timed_ms([&] {
                                     for (const Cloud& cloud : clouds) {
                                         tree.insertPointCloud(cloud.points, cloud.sensor, -1.0,
                                                               true, is_discretized);
                                     }
                                     tree.updateInnerOccupancy();
                                 }));
    measured.bytes = tree.memoryUsage();
    measured.known_cells = tree.getNumLeafNodes();
}

Json measure(const std::string& name, const std::vector<Scan>& scans) {
    std::vector<Cloud> clouds;
    for (const Scan& scan : scans) clouds.push_back(cloud_of(scan));
    std::array<Measured, 5> measured;
    measured[0].name = "flat grid";
    measured[1].name = "quadcut";
    measured[2].name = "quadcut, scan by scan";
    measured[3].name = "OctoMap";
    measured[4].name = "OctoMap, discretized";
    for (int round = 0; round < kRounds; ++round) {
        run_flat(scans, measured[0]);
        run_quadcut_on_log(scans, measured[1]);
        run_quadcut(scans, measured[2]);
        run_octomap(clouds, false, measured[3]);
        run_octomap(clouds, true, measured[4]);
    }
    Json rows = Json::array();
    for (const Measured& one : measured) {
        const double bytes_a_m2 = static_cast<double>(one.bytes) / one.known_m2();
        rows.push_back({{"input", name},
                        {"map", one.name},
                        {"scans", scans.size()},
                        {"ms_a_scan", one.least_ms / static_cast<double>(scans.size())},
                        {"over_flat_grid", one.least_ms / measured[0].least_ms},
                        {"over_quadcut", one.least_ms / measured[1].least_ms},
                        {"bytes", one.bytes},
                        {"known_m2", one.known_m2()},
                        {"bytes_a_known_m2", bytes_a_m2}});
        std::printf("| %-16s | %-20s | %8.4f | %6.2f | %6.2f | %10zu | %7.0f | %7.0f |\n",
                    name.c_str(), one.name.c_str(),
                    one.least_ms / static_cast<double>(scans.size()),
                    one.least_ms / measured[0].least_ms, one.least_ms / measured[1].least_ms,
                    one.bytes, one.known_m2(), bytes_a_m2);
    }
    std::fflush(stdout);
    return rows;
}

int run(int argc, char** argv) {
    const std::filesystem::path folder = std::filesystem::path(QUADCUT_SHARED_DIR) / "data/logs";
    std::vector<std::string> names;
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "-o") {
            ++i;
        } else {
            names.emplace_back(argv[i]);
        }
    }
    if (names.empty()) names = {"intel.log", "mit_csail.log", "aces.log"};
    std::printf(
        "| log | map | ms a scan | over flat grid | over quadcut | bytes | known m2 | bytes a m2 "
        "|\n|---|---|---|---|---|---|---|---|\n");
    Json rows = Json::array();
    for (const std::string& name : names) {
        // An absolute path stays what it is.
        const std::filesystem::path path = folder / name;
        if (!std::filesystem::exists(path)) {
            std::printf("%s: left out, there is no %s\n", name.c_str(), path.c_str());
            continue;
        }
        for (Json& row : measure(path.filename().string(), io::read_carmen_log(path).scans)) {
            rows.push_back(std::move(row));
        }
    }
    write_results(output_path(argc, argv), "updates", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
