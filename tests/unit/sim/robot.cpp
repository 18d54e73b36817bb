// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/robot.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/map/clearance.hpp"

namespace quadcut::sim {
namespace {

Building small_building(double furniture = 1.0) {
    BuildingOptions options;
    options.seed = 12;
    options.num_rooms = 7;
    options.furniture = furniture;
    return generate_building(options);
}

RobotOptions coarse() {
    RobotOptions options;
    options.laser.angle_step_rad = M_PI / 180.0;
    return options;
}

Cell cell_of(const GridMap& map, const Point& p) {
    return {static_cast<std::int32_t>(std::floor((p.x - map.map_from_image.x) / map.resolution_m)),
            static_cast<std::int32_t>(std::floor((p.y - map.map_from_image.y) / map.resolution_m))};
}

Raster<float> clearance_of(const GridMap& map) {
    Raster<std::uint8_t> open({0, 0}, map.states.width, map.states.height);
    for (std::size_t i = 0; i < open.values.size(); ++i) {
        open.values[i] = map.states.values[i] == CellState::free ? 1 : 0;
    }
    return clearance_m(open, map.resolution_m);
}

// 1 where a beam of some scan has passed or ended, from the true poses.
std::vector<std::uint8_t> seen(const GridMap& map, const Exploration& exploration) {
    std::vector<std::uint8_t> result(map.states.values.size(), 0);
    for (std::size_t k = 0; k < exploration.scans.size(); ++k) {
        const Scan& scan = exploration.scans[k];
        const Pose& pose = exploration.true_poses[k];
        for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
            const auto range = static_cast<double>(scan.ranges_m[i]);
            if (range >= scan.max_range_m) continue;
            const double angle =
                pose.yaw_rad + scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
            for (double t = 0.0; t < range; t += 0.04) {
                const Cell cell =
                    cell_of(map, {pose.x + t * std::cos(angle), pose.y + t * std::sin(angle)});
                if (map.states.contains(cell)) result[map.states.offset(cell)] = 1;
            }
        }
    }
    return result;
}

TEST(Robot, StartsInTheCorridor) {
    const Building building = small_building();
    const Pose start = start_pose(building);
    const std::uint16_t label = building.labels.at(cell_of(building.map, {start.x, start.y}));
    ASSERT_GT(label, 0);
    EXPECT_EQ(building.rooms[label - 1U].kind, RoomKind::corridor);
}

TEST(Robot, SeesAllAndTouchesNothing) {
    for (const double furniture : {0.0, 1.0}) {
        const Building building = small_building(furniture);
        const RobotOptions options = coarse();
        const Exploration exploration = explore(building.map, start_pose(building), options);
        ASSERT_EQ(exploration.scans.size(), exploration.true_poses.size());
        EXPECT_GT(exploration.scans.size(), 30U);
        EXPECT_LT(exploration.scans.size(), 1500U);

        const Raster<float> clearance = clearance_of(building.map);
        std::vector<std::uint8_t> is_visited(building.rooms.size() + 1, 0);
        for (const Pose& pose : exploration.true_poses) {
            const Cell cell = cell_of(building.map, {pose.x, pose.y});
            EXPECT_GE(clearance.at(cell), options.radius_m - building.map.resolution_m);
            is_visited[building.labels.at(cell)] = 1;
        }
        const std::vector<std::uint8_t> is_seen = seen(building.map, exploration);
        double num_free = 0.0;
        double num_seen = 0.0;
        for (std::size_t i = 0; i < is_seen.size(); ++i) {
            if (building.labels.values[i] == 0) continue;
            num_free += 1.0;
            num_seen += is_seen[i];
        }
        EXPECT_GT(num_seen / num_free, 0.97);
        EXPECT_GT(std::count(is_visited.begin(), is_visited.end(), 1),
                  static_cast<std::ptrdiff_t>(building.rooms.size() / 2));
    }
}

TEST(Robot, KeyScansAreSpacedAsWished) {
    const Building building = small_building();
    RobotOptions options = coarse();
    options.key_distance_m = 0.4;
    options.key_turn_rad = 0.5;
    const Exploration exploration = explore(building.map, start_pose(building), options);
    // One period of the laser may pass before a scan is taken.
    const double most_way = 0.4 + options.speed_mps / options.scan_rate_hz;
    const double most_turn = 0.5 + options.turn_rate_radps / options.scan_rate_hz;
    for (std::size_t i = 1; i < exploration.true_poses.size(); ++i) {
        const Pose& a = exploration.true_poses[i - 1];
        const Pose& b = exploration.true_poses[i];
        const double way = std::hypot(b.x - a.x, b.y - a.y);
        const double turn = std::abs(std::remainder(b.yaw_rad - a.yaw_rad, 2.0 * M_PI));
        EXPECT_TRUE(way >= 0.4 || turn >= 0.5);
        EXPECT_LE(way, most_way + 1e-9);
        EXPECT_LE(turn, most_turn + 1e-9);
        EXPECT_GT(exploration.scans[i].time_s, exploration.scans[i - 1].time_s);
    }
    options.key_distance_m = 0.0;
    EXPECT_GT(explore(building.map, start_pose(building), options).scans.size(),
              2 * exploration.scans.size());
}

TEST(Robot, SameSeedSameScans) {
    const Building building = small_building(0.5);
    RobotOptions options = coarse();
    const Exploration a = explore(building.map, start_pose(building), options);
    const Exploration b = explore(building.map, start_pose(building), options);
    ASSERT_EQ(a.scans.size(), b.scans.size());
    for (std::size_t i = 0; i < a.scans.size(); ++i) {
        ASSERT_EQ(a.scans[i].ranges_m, b.scans[i].ranges_m);
        ASSERT_EQ(a.scans[i].world_from_sensor, b.scans[i].world_from_sensor);
    }
    options.seed = 2;
    const Exploration c = explore(building.map, start_pose(building), options);
    EXPECT_NE(a.scans[0].ranges_m, c.scans[0].ranges_m);
}

TEST(Robot, StepByStepIsTheSame) {
    const Building building = small_building(0.5);
    const Exploration whole = explore(building.map, start_pose(building), coarse());
    Explorer explorer(building.map, start_pose(building), coarse());
    std::size_t i = 0;
    while (const std::optional<KeyScan> key = explorer.next()) {
        ASSERT_LT(i, whole.scans.size());
        EXPECT_EQ(key->true_pose, whole.true_poses[i]);
        EXPECT_EQ(key->scan.ranges_m, whole.scans[i].ranges_m);
        ++i;
    }
    EXPECT_EQ(i, whole.scans.size());
    EXPECT_FALSE(explorer.next()) << "it stays at its end";
}

TEST(Robot, PoseErrorsAreAsStated) {
    const Building building = small_building();
    for (const double correlation : {0.0, 0.9}) {
        RobotOptions options = coarse();
        options.key_distance_m = 0.0;  // many scans
        options.pose_noise_m = 0.03;
        options.pose_noise_rad = 0.01;
        options.pose_correlation = correlation;
        const Exploration exploration = explore(building.map, start_pose(building), options);
        std::vector<double> x;
        double yaw_squares = 0.0;
        for (std::size_t i = 0; i < exploration.scans.size(); ++i) {
            const Pose& reported = exploration.scans[i].world_from_sensor;
            const Pose& truth = exploration.true_poses[i];
            x.push_back(reported.x - truth.x);
            const double yaw = std::remainder(reported.yaw_rad - truth.yaw_rad, 2.0 * M_PI);
            yaw_squares += yaw * yaw;
        }
        double squares = 0.0;
        double products = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            squares += x[i] * x[i];
            if (i > 0) products += x[i] * x[i - 1];
        }
        const auto n = static_cast<double>(x.size());
        EXPECT_NEAR(std::sqrt(squares / n), 0.03, 0.006);
        EXPECT_NEAR(std::sqrt(yaw_squares / n), 0.01, 0.002);
        EXPECT_NEAR(products / squares, correlation, 0.08);
    }
}

TEST(Robot, RefusesToStartInAWall) {
    const Building building = small_building();
    EXPECT_THROW(
        Explorer(building.map,
                 {building.map.map_from_image.x + 0.1, building.map.map_from_image.y + 0.1, 0.0},
                 coarse()),
        std::logic_error);
}

// A room that it passes by it sees from outside at most; all of them: it does not set out.
TEST(Robot, PassesByWhatItNeedNotSee) {
    const Building building = small_building(0.0);
    const Raster<CellState>& states = building.map.states;
    const auto num_scans = [&](std::uint8_t passed_by) {
        Explorer explorer(building.map, start_pose(building), coarse(),
                          {states.origin, states.width, states.height, passed_by});
        std::size_t count = 0;
        while (explorer.next()) ++count;
        return count;
    };
    EXPECT_EQ(num_scans(1), 1U);
    EXPECT_GT(num_scans(0), 20U);
}

TEST(Robot, ASurveyOfTheFloorIsShorterThanOneOfTheCorners) {
    const Building building = small_building(1.0);
    RobotOptions options = coarse();
    const std::size_t with_corners =
        explore(building.map, start_pose(building), options).scans.size();
    options.survey = RobotOptions::Survey::floor;
    EXPECT_LT(explore(building.map, start_pose(building), options).scans.size(), with_corners);
}

}  // namespace
}  // namespace quadcut::sim
