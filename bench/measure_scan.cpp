// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Three ways to tell which cells a scan saw free, and the whole step from scan to committed map:
//   star    the outline of what was seen, as bits, filled by parity (what the library does)
//   rays    each beam walked cell by cell
//   polar   each cell of the bounding box: bearing, beams on both sides, ranges
//   micro_scan [-o FILE.json]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "bench/result_file.hpp"
#include "eval/cases.hpp"
#include "io/carmen.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/line_walk.hpp"
#include "quadcut/map/scan_cells.hpp"

namespace quadcut {
namespace {

constexpr double kResolution = 0.05;
constexpr int kRepeats = 9;

struct Sight {
    std::vector<Beam> beams;
    Point sensor;
    double yaw_rad = 0.0;
    double first_angle_rad = 0.0;
    double angle_step_rad = 0.0;
};

Sight sight_of(const Scan& scan) {
    const Pose& pose = scan.world_from_sensor;
    return {beams_of(scan, pose.yaw_rad, kResolution, {}),
            {pose.x / kResolution, pose.y / kResolution},
            pose.yaw_rad,
            scan.first_angle_rad,
            scan.angle_step_rad};
}

BitRaster frame_of(const Sight& sight) {
    Cell low = cell_of(sight.sensor);
    Cell high = low;
    for (const Beam& beam : sight.beams) {
        const Cell end = cell_of({sight.sensor.x + beam.direction.x * beam.range,
                                  sight.sensor.y + beam.direction.y * beam.range});
        low = {std::min(low.x, end.x), std::min(low.y, end.y)};
        high = {std::max(high.x, end.x), std::max(high.y, end.y)};
    }
    return {low, high};
}

BitRaster by_star(const Sight& sight) {
    return cells_of(sight.beams, sight.sensor, sight.angle_step_rad).free;
}

BitRaster by_rays(const Sight& sight) {
    BitRaster free = frame_of(sight);
    for (const Beam& beam : sight.beams) {
        if (beam.reach > 0.0) {
            walk_line(sight.sensor,
                      {sight.sensor.x + beam.direction.x * beam.reach,
                       sight.sensor.y + beam.direction.y * beam.reach},
                      [&](Cell cell, double) {
                          free.set(cell);
                          return true;
                      });
        }
    }
    return free;
}

BitRaster by_polar(const Sight& sight) {
    BitRaster free = frame_of(sight);
    const double turn = 2.0 * std::numbers::pi;
    for (std::int32_t y = 0; y < free.height(); ++y) {
        for (std::int32_t x = 0; x < free.width(); ++x) {
            const Cell cell{free.origin().x + x, free.origin().y + y};
            const Point from_sensor{cell.x + 0.5 - sight.sensor.x, cell.y + 0.5 - sight.sensor.y};
            const double bearing =
                std::atan2(from_sensor.y, from_sensor.x) - sight.yaw_rad - sight.first_angle_rad;
            const double position =
                (bearing - turn * std::floor(bearing / turn)) / sight.angle_step_rad;
            const auto left = static_cast<std::size_t>(position);
            if (left + 1 < sight.beams.size() &&
                std::hypot(from_sensor.x, from_sensor.y) <
                    std::min(sight.beams[left].reach, sight.beams[left + 1].reach)) {
                free.set(cell);
            }
        }
    }
    return free;
}

template <typename Work>
double median_us_per_scan(std::size_t num_scans, const Work& work) {
    std::vector<double> times(kRepeats);
    for (double& time : times) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::micro> elapsed =
            std::chrono::steady_clock::now() - start;
        time = elapsed.count() / static_cast<double>(num_scans);
    }
    std::nth_element(times.begin(), times.begin() + kRepeats / 2, times.end());
    return times[kRepeats / 2];
}

template <typename Classify>
Json measure(const std::string& input, const char* name, const std::vector<Sight>& sights,
             const Classify& classify) {
    std::size_t num_cells = 0;
    const double time = median_us_per_scan(sights.size(), [&] {
        num_cells = 0;
        for (const Sight& sight : sights) {
            const BitRaster free = classify(sight);
            for (std::int32_t y = 0; y < free.height() / kTileSide; ++y) {
                for (std::int32_t x = 0; x < free.width() / kTileSide; ++x) {
                    num_cells += static_cast<std::size_t>(std::popcount(free.tile_rows(x, y)));
                }
            }
        }
    });
    const double cells = static_cast<double>(num_cells) / static_cast<double>(sights.size());
    std::printf("  %-8s %8.1f us a scan %10.0f free cells a scan\n", name, time, cells);
    return {{"input", input}, {"method", name}, {"us_a_scan", time}, {"free_cells_a_scan", cells}};
}

void bench(const std::string& name, const std::vector<Scan>& scans, Json& rows) {
    std::printf("%s: %zu scans of %zu beams\n", name.c_str(), scans.size(),
                scans.front().ranges_m.size());
    std::vector<Sight> sights;
    for (const Scan& scan : scans) sights.push_back(sight_of(scan));
    rows.push_back(measure(name, "star", sights, by_star));
    rows.push_back(measure(name, "rays", sights, by_rays));
    rows.push_back(measure(name, "polar", sights, by_polar));
    const double whole = median_us_per_scan(scans.size(), [&] {
        OccupancyMap map(kResolution);
        for (const Scan& scan : scans) integrate_scan(map, scan);
    });
    std::printf("  %-8s %8.1f us a scan, from the scan to the committed map\n", "whole", whole);
    rows.push_back({{"input", name}, {"method", "whole"}, {"us_a_scan", whole}});
}

/// A robot that walks through a hall of about 10 m radius; 270 degrees, 0.25 degrees.
std::vector<Scan> simulated_scans() {
    Random random(5);
    std::vector<Scan> scans(200);
    for (std::size_t i = 0; i < scans.size(); ++i) {
        Scan& scan = scans[i];
        const auto step = static_cast<double>(i);
        scan.world_from_sensor = {0.02 * step, 0.01 * step, 0.01 * step};
        scan.first_angle_rad = -135.0 / 180.0 * std::numbers::pi;
        scan.angle_step_rad = 0.25 / 180.0 * std::numbers::pi;
        scan.max_range_m = 30.0;
        for (int beam = 0; beam < 1080; ++beam) {
            const double angle = scan.first_angle_rad + beam * scan.angle_step_rad;
            const double wall = 10.0 + std::sin(7.0 * (angle + scan.world_from_sensor.yaw_rad));
            scan.ranges_m.push_back(static_cast<float>(wall + 0.01 * random.normal()));
        }
    }
    return scans;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) {
    quadcut::Json rows = quadcut::Json::array();
    const std::filesystem::path logs = std::filesystem::path(QUADCUT_SHARED_DIR) / "data/logs";
    for (const char* name : {"intel.log", "mit_csail.log"}) {
        if (std::filesystem::exists(logs / name)) {
            quadcut::bench(name, quadcut::io::read_carmen_log(logs / name).scans, rows);
        } else {
            std::printf("%s: left out, there is no %s\n", name, (logs / name).c_str());
        }
    }
    quadcut::bench("simulated hall", quadcut::simulated_scans(), rows);
    quadcut::write_results(quadcut::output_path(argc, argv), "scan", std::move(rows));
    return 0;
}
