// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/write.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/authorship.hpp"
#include "io/carmen.hpp"
#include "io/file.hpp"
#include "io/image.hpp"
#include "io/map_server.hpp"
#include "sim/workplace.hpp"
#include "tests/unit/io/image_file.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::sim {
namespace {

RobotOptions robot(double field_of_view_deg, double step_deg) {
    RobotOptions options;
    options.laser.field_of_view_rad = field_of_view_deg * M_PI / 180.0;
    options.laser.angle_step_rad = step_deg * M_PI / 180.0;
    options.laser.dropout = 0.02;
    return options;
}

void expect_round_trip(const RobotOptions& options, std::string_view message) {
    const Building workplace = paper_workplace();
    const Exploration exploration = explore(workplace.map, start_pose(workplace), options);
    const std::string log = encode_carmen_log(exploration.scans);
    EXPECT_NE(log.find(std::string("\n") + std::string(message) + " "), std::string::npos);
    io::LogReadOptions read;
    read.max_range_m = options.laser.max_range_m;
    const io::LogFile file = io::parse_carmen_log(log, "robot.log", read);
    EXPECT_TRUE(file.warnings.empty()) << file.warnings.front();
    ASSERT_EQ(file.scans.size(), exploration.scans.size());
    for (std::size_t i = 0; i < file.scans.size(); ++i) {
        const Scan& a = exploration.scans[i];
        const Scan& b = file.scans[i];
        EXPECT_NEAR(a.world_from_sensor.x, b.world_from_sensor.x, 1e-6);
        EXPECT_NEAR(a.world_from_sensor.y, b.world_from_sensor.y, 1e-6);
        EXPECT_NEAR(a.world_from_sensor.yaw_rad, b.world_from_sensor.yaw_rad, 1e-6);
        EXPECT_NEAR(a.first_angle_rad, b.first_angle_rad, 1e-6);
        EXPECT_NEAR(a.angle_step_rad, b.angle_step_rad, 1e-8);
        EXPECT_NEAR(a.time_s, b.time_s, 1e-6);
        ASSERT_EQ(a.ranges_m.size(), b.ranges_m.size());
        for (std::size_t k = 0; k < a.ranges_m.size(); ++k) {
            ASSERT_NEAR(a.ranges_m[k], b.ranges_m[k], 0.0006);
            ASSERT_EQ(a.ranges_m[k] >= a.max_range_m, b.ranges_m[k] >= b.max_range_m);
        }
    }
}

TEST(WriteSimulation, LogOfTheDefaultScannerReadsBack) {
    expect_round_trip(robot(270.0, 0.25), "ROBOTLASER1");
}

TEST(WriteSimulation, LogsOfOldScannersReadBack) {
    expect_round_trip(robot(180.0, 1.0), "FLASER");
    expect_round_trip(robot(180.0, 0.5), "FLASER");
    expect_round_trip(robot(179.0, 1.0), "ROBOTLASER1");  // 180 beams, but not from -90 degrees
}

TEST(WriteSimulation, FolderHoldsMapTruthAndLog) {
    const io::test::ScratchFolder scratch;
    BuildingOptions options;
    options.seed = 9;
    options.num_rooms = 8;
    const Building building = generate_building(options);
    const Exploration exploration = explore(building.map, start_pose(building), robot(180.0, 1.0));
    const std::filesystem::path folder = scratch.path() / "new" / "folder";
    io::FileBatch batch(folder);
    add_simulation(batch, building, options, exploration);
    EXPECT_EQ(batch.names(), simulation_files());
    batch.commit();

    const io::MapFile map = io::read_map(folder / "map.yaml");
    EXPECT_TRUE(map.warnings.empty());
    EXPECT_EQ(map.map.states.values, building.map.states.values);
    EXPECT_EQ(map.map.resolution_m, building.map.resolution_m);
    EXPECT_EQ(map.map.map_from_image, building.map.map_from_image);

    const io::Image rooms = io::read_image(folder / "rooms.png");
    EXPECT_EQ(rooms.header.max_value, 65535);
    ASSERT_EQ(rooms.header.width, building.labels.width);
    ASSERT_EQ(rooms.header.height, building.labels.height);
    for (std::int32_t y = 0; y < rooms.header.height; ++y) {
        for (std::int32_t x = 0; x < rooms.header.width; ++x) {
            ASSERT_EQ(rooms.row(rooms.header.height - 1 - y)[static_cast<std::size_t>(x)],
                      building.labels.at({x, y}));
        }
    }

    const nlohmann::json truth = nlohmann::json::parse(io::read_file(folder / "truth.json"));
    EXPECT_EQ(truth.at("format_version"), 1);
    EXPECT_EQ(truth.at("options").at("seed"), 9);
    EXPECT_EQ(truth.at("options").at("furniture"), 0.5);
    ASSERT_EQ(truth.at("rooms").size(), building.rooms.size());
    EXPECT_EQ(truth.at("rooms")[1].at("name"), building.rooms[1].name);
    EXPECT_EQ(truth.at("rooms")[0].at("kind"), "corridor");
    ASSERT_EQ(truth.at("doors").size(), building.doors.size());
    EXPECT_NEAR(truth.at("doors")[0].at("width_m"), building.doors[0].width_m, 0.001);
    EXPECT_NEAR(truth.at("doors")[0].at("jamb_1")[0], building.doors[0].jamb_1.x, 0.001);

    EXPECT_EQ(io::read_carmen_log(folder / "robot.log").scans.size(), exploration.scans.size());
    const std::string poses = io::read_file(folder / "true_poses.tum");
    EXPECT_EQ(std::count(poses.begin(), poses.end(), '\n'),
              static_cast<std::ptrdiff_t>(exploration.scans.size() + 1));
}

TEST(WriteSimulation, WithoutScansThereIsNoLog) {
    const io::test::ScratchFolder scratch;
    io::FileBatch batch(scratch.path());
    add_simulation(batch, paper_workplace(), {}, {});
    batch.commit();
    const std::vector<std::string> names = scratch.names();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()),
              (std::set<std::string>{"map.pgm", "map.yaml", "rooms.png", "truth.json"}));
}

TEST(WriteSimulation, SaysWhoWroteIt) {
    const io::test::ScratchFolder scratch;
    const Exploration one{{Scan{}}, {Pose{}}};
    io::FileBatch batch(scratch.path());
    add_simulation(batch, paper_workplace(), {}, one);
    batch.commit();
    for (const std::string& name : simulation_files()) {
        EXPECT_TRUE(io::is_own_file(scratch.path() / name)) << name;
    }
}

}  // namespace
}  // namespace quadcut::sim
