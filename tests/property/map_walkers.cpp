// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// People who walk by leave no trace in the map once they are gone.
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "sim/building.hpp"
#include "sim/robot.hpp"

namespace quadcut {
namespace {

constexpr double kResolutionM = 0.05;
constexpr double kLegM = 0.2;
constexpr double kRoomM = 0.15;

/// Someone stands in front of some beams, where there is room; the end points on them, none when
/// there is no room.
std::vector<Point> put_walker(Scan& scan, Random& random) {
    std::vector<Point> hits;
    const std::size_t beam = random.below(scan.ranges_m.size());
    const double distance_m = random.uniform(0.8, 6.0);
    if (!(scan.ranges_m[beam] > distance_m + 0.5)) return hits;
    const double yaw = scan.first_angle_rad + scan.angle_step_rad * static_cast<double>(beam);
    const Point walker{distance_m * std::cos(yaw), distance_m * std::sin(yaw)};
    const Scan before = scan;
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
        const double angle = scan.first_angle_rad + scan.angle_step_rad * static_cast<double>(i);
        const Point way{std::cos(angle), std::sin(angle)};
        const double along_m = walker.x * way.x + walker.y * way.y;
        const double aside_m = walker.x * way.y - walker.y * way.x;
        if (along_m <= 0.0 || std::abs(aside_m) >= kLegM) continue;
        const double range_m = along_m - std::sqrt(kLegM * kLegM - aside_m * aside_m);
        if (!(scan.ranges_m[i] > along_m + kLegM + kRoomM)) {
            scan = before;
            return {};
        }
        scan.ranges_m[i] = static_cast<float>(range_m);
        hits.push_back(transform(scan.world_from_sensor, Point{range_m * way.x, range_m * way.y}));
    }
    return hits;
}

TEST(MapWalkers, LeaveNoTraceOnceTheyAreGone) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        sim::BuildingOptions options;
        options.seed = seed;
        options.num_rooms = 8;
        options.furniture = 0.3;
        const sim::Building building = sim::generate_building(options);
        sim::RobotOptions robot;
        robot.seed = seed;
        robot.key_distance_m = 0.1;
        std::vector<Scan> scans =
            sim::explore(building.map, sim::start_pose(building), robot).scans;
        Random random(seed);
        std::set<std::pair<std::int32_t, std::int32_t>> touched;
        std::size_t num_walkers = 0;
        OccupancyMap map(kResolutionM);
        const Pose image_from_map = inverse(building.map.map_from_image);
        for (Scan& scan : scans) {
            if (random.uniform() < 0.2) {
                std::vector<Point> hits;
                for (int i = 0; i < 100 && hits.empty(); ++i) hits = put_walker(scan, random);
                if (!hits.empty()) ++num_walkers;
                for (const Point& hit : hits) {
                    const Cell cell = map.cell_at(hit);
                    touched.emplace(cell.x, cell.y);
                }
            }
            integrate_scan(map, scan);
        }
        std::size_t num_free_in_truth = 0;
        std::size_t num_free = 0;
        for (const auto& [x, y] : touched) {
            const Point centre{(x + 0.5) * kResolutionM, (y + 0.5) * kResolutionM};
            const Point in_image = transform(image_from_map, centre);
            const Cell in_truth{
                static_cast<std::int32_t>(std::floor(in_image.x / building.map.resolution_m)),
                static_cast<std::int32_t>(std::floor(in_image.y / building.map.resolution_m))};
            if (!building.map.states.contains(in_truth)) continue;
            if (building.map.states.at(in_truth) != CellState::free) continue;
            ++num_free_in_truth;
            if (map.state({x, y}) == CellState::free) ++num_free;
        }
        EXPECT_GT(num_walkers, scans.size() / 8);
        ASSERT_GT(num_free_in_truth, 500U);
        EXPECT_GE(static_cast<double>(num_free), 0.99 * static_cast<double>(num_free_in_truth))
            << "seed " << seed << ": " << num_free << " of " << num_free_in_truth;
    }
}

}  // namespace
}  // namespace quadcut
