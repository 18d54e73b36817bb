// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/map_server.hpp"
#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

/// A scan of 181 beams from the middle of a square room of 4 m.
std::string room_scan(double x, double y, double time_s) {
    std::string line = "FLASER 181";
    for (int degree = -90; degree <= 90; ++degree) {
        const double angle = degree * std::acos(-1.0) / 180.0;
        const double range = 2.0 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
        line += " " + std::to_string(range);
    }
    const std::string pose = " " + std::to_string(x) + " " + std::to_string(y) + " 0";
    return line + pose + pose + " " + std::to_string(time_s) + " host " + std::to_string(time_s) +
           "\n";
}

TEST(MapOfLog, OneScanSeesHalfARoom) {
    const Folder folder;
    const Outcome outcome = run_quadcut(
        {"map", folder.write("one.log", room_scan(0, 0, 1)), "-o", folder / "out", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto summary = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(summary.at("scans"), 1);
    EXPECT_NEAR(summary.at("free_m2"), 8.0, 0.8);
    const auto files = files_below(folder / "out");
    EXPECT_EQ(files.size(), 2U);
    EXPECT_TRUE(files.count("map.pgm") == 1 && files.count("map.yaml") == 1);
    const GridMap map = io::read_map(folder / "out/map.yaml").map;
    EXPECT_EQ(map.resolution_m, 0.05);
    EXPECT_NEAR(map.map_from_image.x, 0.0, 0.11);
    EXPECT_NEAR(map.map_from_image.y, -2.0, 0.11);
}

TEST(FollowedLog, SlowAHoleOfYearsHoldsNobodyUp) {
    const Folder folder;
    const std::string log =
        folder.write("hole.log", room_scan(0, 0, 100.0) + room_scan(0, 0, 1.5e9));
    const Outcome outcome = run_quadcut({"follow", log, "-o", folder / "out", "--speed", "1000"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("warning: the time stamps have 1 hole, the longest of 47.5 years"),
              std::string::npos)
        << outcome.err;
}

TEST(MapOfLog, Resolution) {
    const Folder folder;
    const std::string log = folder.write("one.log", room_scan(0, 0, 1));
    ASSERT_EQ(run_quadcut({"map", log, "-o", folder / "out", "--resolution", "0.1"}).exit_code, 0);
    EXPECT_EQ(io::read_map(folder / "out/map.yaml").map.resolution_m, 0.1);
}

TEST(MapOfLog, OptionsOfScansCount) {
    const Folder folder;
    const std::string log = folder.write("one.log", room_scan(0, 0, 1));
    const auto free_m2 = [&](const std::vector<std::string>& more) {
        std::vector<std::string> command{"map", log, "-o", folder / "out", "--force", "--json"};
        command.insert(command.end(), more.begin(), more.end());
        return nlohmann::json::parse(run_quadcut(command).out).at("free_m2").get<double>();
    };
    EXPECT_LT(free_m2({"--set", "scan.max_range=1"}), 0.3 * free_m2({}));
    ASSERT_EQ(
        run_quadcut({"segment", log, "-o", folder / "rooms", "--set", "scan.miss=-2"}).exit_code,
        0);
    const auto report = nlohmann::json::parse(read_bytes(folder / "rooms/report.json"));
    EXPECT_EQ(report.at("options").at("scan.miss"), -2);
    EXPECT_FALSE(report.at("options").contains("scan.hit"));
    const Outcome outcome =
        run_quadcut({"map", log, "-o", folder / "out", "--set", "door_width=2"});
    EXPECT_EQ(outcome.exit_code, 2);
}

TEST(MapOfLog, GarbageLinesAndBadRangesAreSkippedWithAWarning) {
    const Folder folder;
    const std::string bad =
        "\x01\x02 no message\nFLASER 3 1 2\nFLASER 2 nan -1 0 0 0 0 0 0 1 host 1\n";
    const Outcome outcome = run_quadcut(
        {"map", folder.write("bad.log", bad + room_scan(0, 0, 1)), "-o", folder / "out", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NEAR(nlohmann::json::parse(outcome.out).at("free_m2"), 8.0, 0.8);
    EXPECT_NE(outcome.err.find("quadcut: warning: "), std::string::npos);
    EXPECT_NE(outcome.err.find("bad.log"), std::string::npos) << outcome.err;
}

TEST(MapOfLog, PosesReplaceTheLogsOwn) {
    const Folder folder;
    const std::string log =
        folder.write("two.log", room_scan(0, 0, 100.0) + room_scan(0, 0, 101.0));
    const std::string tum = folder.write(
        "poses.tum",
        "100.0 10 20 0 0 0 0 1\n101.0 10 20 0 0 0 0.7071067811865476 0.7071067811865476\n");
    const std::string g2o =
        folder.write("poses.g2o", "VERTEX_SE2 0 10 20 0\nVERTEX_SE2 1 10 20 1.5707963267948966\n");
    for (const std::string& poses : {tum, g2o}) {
        const Outcome outcome =
            run_quadcut({"map", log, "-o", folder / "out", "--poses", poses, "--json"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const GridMap map = io::read_map(folder / "out/map.yaml").map;
        EXPECT_NEAR(map.map_from_image.x, 8.0, 0.11);
        EXPECT_NEAR(map.map_from_image.y, 18.0, 0.11);
        // Three quarters of the room are seen.
        EXPECT_NEAR(nlohmann::json::parse(outcome.out).at("free_m2"), 12.0, 1.0);
    }
}

/// The scans of a room of 4 m, and one far from them; the same in all commands that read logs.
TEST(FarScan, IsLeftOutWithItsLineAndCounted) {
    const Folder folder;
    for (const char* const command : {"map", "segment", "follow"}) {
        for (const std::size_t place : {0, 2, 4}) {
            std::string bytes;
            std::string expected = "# a log\n";
            for (std::size_t i = 0; i < 5; ++i) {
                const double time_s = static_cast<double>(i);
                bytes +=
                    room_scan(i == place ? 1e5 : 0.01 * time_s, i == place ? 30.0 : 0.0, time_s);
                if (i != place) expected += room_scan(0.01 * time_s, 0.0, time_s);
            }
            const Outcome outcome = run_quadcut(
                {command, folder.write("far.log", "# a log\n" + bytes), "-o", folder / "out"});
            ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
            EXPECT_NE(outcome.err.find("far.log: line " + std::to_string(place + 2) +
                                       ": the pose (100000, 30) is 100 km from"),
                      std::string::npos)
                << outcome.err;
            EXPECT_NE(outcome.err.find("left out (1 of 5 scans)"), std::string::npos)
                << outcome.err;
            const std::string without = folder.write("without.log", expected);
            ASSERT_EQ(run_quadcut({command, without, "-o", folder / "without"}).exit_code, 0);
            const std::string map = read_bytes(folder / "out/map.pgm");
            EXPECT_LT(map.size(), 20000U);
            EXPECT_EQ(map, read_bytes(folder / "without/map.pgm"));
        }
    }
}

TEST(FarScan, ByPosesOfAFile) {
    const Folder folder;
    const std::string log = folder.write("three.log", room_scan(0, 0, 100) + room_scan(0, 0, 101) +
                                                          "# between\n" + room_scan(0, 0, 102));
    const std::string poses = folder.write(
        "wild.g2o", "VERTEX_SE2 0 1 1 0\nVERTEX_SE2 1 1 1 0\nVERTEX_SE2 2 1e300 1 0\n");
    for (const char* const command : {"map", "segment", "follow"}) {
        const Outcome outcome = run_quadcut({command, log, "-o", folder / "out", "--poses", poses});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("three.log: line 4: "), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find("left out (1 of 3 scans)"), std::string::npos) << outcome.err;
    }
    const Outcome none =
        run_quadcut({"map", folder.write("one.log", room_scan(0, 0, 0)), "-o", folder / "none",
                     "--poses", folder.write("one.g2o", "VERTEX_SE2 0 0 1e300 0\n")});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_NE(none.err.find("one.log: line 1: "), std::string::npos) << none.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(MapOfLog, PosesOfAnotherTimeAreRefused) {
    const Folder folder;
    const std::string log = folder.write("one.log", room_scan(0, 0, 100.0));
    const std::string tum = folder.write("late.tum", "900.5 0 0 0 0 0 0 1\n");
    const Outcome outcome = run_quadcut({"map", log, "-o", folder / "out", "--poses", tum});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("late.tum"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(SegmentOfLog, WritesMapAndRooms) {
    const Folder folder;
    // The suffix does not say what it is.
    const std::string log = folder.write("scans.txt", "# a log\n" + room_scan(0, 0, 1));
    const Outcome outcome = run_quadcut({"segment", log, "-o", folder / "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto files = files_below(folder / "out");
    for (const std::string name : {"map.pgm", "map.yaml", "rooms.png", "rooms.yaml", "report.json",
                                   "rooms.geojson", "rooms.svg", "rooms_color.png", "graph.json"}) {
        EXPECT_EQ(files.count(name), 1U) << name;
    }
    EXPECT_EQ(files.size(), 9U);
    EXPECT_NE(outcome.out.find("1 room, 0 doors"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace quadcut::test
