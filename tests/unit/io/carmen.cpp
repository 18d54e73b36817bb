// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/carmen.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::ScratchFolder;

constexpr double kPi = std::numbers::pi;

LogFile parse(const std::string& text, const LogReadOptions& options = {}) {
    return parse_carmen_log(text, "x.log", options);
}

std::string error_in(const std::string& text) {
    return error_of([&] { parse(text); });
}

/// A FLASER of four beams.
std::string flaser(const std::string& pose, const std::string& time = "1.5",
                   const std::string& ranges = "1 2 3 4") {
    return "FLASER 4 " + ranges + " " + pose + " 0 0 0 " + time + " host 9.5\n";
}

std::string rawlaser(int number) {
    return "RAWLASER" + std::to_string(number) + " 0 -1.5 3 1 20 0.01 0 4 1 2 3 4 0 2.5 host 9.5\n";
}

using Warnings = std::vector<std::string>;

TEST(Carmen, ReadsScansInTheOrderOfTheirLines) {
    const LogFile log = parse(
        "# CARMEN Logfile\n"
        "PARAM robot_length 0.5 nohost 0\n"
        "SYNC tag\n" +
        flaser("1 2 0.5", "20.5") + "\n" + "ODOM 1 2 3 0 0 0 20.6 host 1\n" +
        flaser("3 4 -0.5", "20.7"));
    ASSERT_EQ(log.scans.size(), 2U);
    EXPECT_EQ(log.scans[0].world_from_sensor, (Pose{1.0, 2.0, 0.5}));
    EXPECT_EQ(log.scans[0].time_s, 20.5);
    EXPECT_EQ(log.scans[0].ranges_m, (std::vector<float>{1, 2, 3, 4}));
    EXPECT_NEAR(log.scans[0].first_angle_rad, -kPi / 2, 1e-12);
    EXPECT_NEAR(log.scans[0].angle_step_rad, kPi / 4, 1e-12);
    EXPECT_EQ(log.scans[0].max_range_m, kMaxUsableRange);
    EXPECT_EQ(log.scans[1].world_from_sensor, (Pose{3.0, 4.0, -0.5}));
    EXPECT_EQ(log.lines, (std::vector<std::uint64_t>{4, 7}));
    EXPECT_EQ(log.counts.scans, 2U);
    EXPECT_EQ(log.counts.lines, 7U);
    EXPECT_EQ(log.counts.other_messages, 3U);
    EXPECT_TRUE(log.warnings.empty());
}

TEST(Carmen, OneScanIsEnough) { EXPECT_EQ(parse(flaser("0 0 0")).scans.size(), 1U); }

TEST(Carmen, YawIsBroughtWithinOneTurn) {
    const LogFile log = parse(flaser("0 0 7"));
    EXPECT_NEAR(log.scans[0].world_from_sensor.yaw_rad, 7.0 - 2.0 * kPi, 1e-12);
}

TEST(Carmen, TheRearLaserLooksBack) {
    const std::string rear = "RLASER 4 1 1 1 1 0 0 0.2 0 0 0.2 1 host 1\n";
    EXPECT_NEAR(parse(rear).scans[0].world_from_sensor.yaw_rad, 0.2 - kPi, 1e-12);
    EXPECT_NEAR(parse(flaser("0 0 0.1") + rear).scans[1].world_from_sensor.yaw_rad, 0.2 - kPi,
                1e-12);
}

TEST(Carmen, ARearLaserThatStatesItsOwnHeadingKeepsIt) {
    // Against the front laser's corrected heading; the odometry behind is in another frame.
    const std::string rear = "RLASER 4 1 1 1 1 0 0 -2.9 0 0 -2.9 1 host 1\n";
    EXPECT_NEAR(parse(flaser("0 0 0.2") + rear).scans[1].world_from_sensor.yaw_rad, -2.9, 1e-12);
    // Against its own odometry when there is no front laser.
    const std::string alone = "RLASER 4 1 1 1 1 0 0 -2.9 0 0 0.2 1 host 1\n";
    EXPECT_NEAR(parse(alone).scans[0].world_from_sensor.yaw_rad, -2.9, 1e-12);
}

TEST(Carmen, ARearLaserThatWasNotCorrectedIsSkipped) {
    // FLASER stands 5 m from its odometry, RLASER on its own.
    const std::string front = "FLASER 4 1 1 1 1 5 0 0.2 0 0 0 1 host 1\n";
    const std::string rear = "RLASER 4 1 1 1 1 -0.3 0 0 0 0 0 1 host 1\n";
    const std::string corrected = "RLASER 4 1 1 1 1 4.7 0 0.2 0 0 0 1 host 1\n";
    const LogFile log = parse(front + rear + corrected);
    ASSERT_EQ(log.scans.size(), 2U);
    EXPECT_EQ(log.scans[1].world_from_sensor.x, 4.7);
    EXPECT_EQ(log.warnings, Warnings{"x.log: 1 rear scan skipped, the first in line 2: expected a "
                                     "corrected pose, as FLASER has"});
    EXPECT_EQ(parse(rear + rear).scans.size(), 2U);
}

TEST(Carmen, ARobotLaserBringsPoseAnglesAndRange) {
    const LogFile log = parse(
        "ROBOTLASER1 0 -2 4 0.5 30 0.01 0 4 1 29.5 30 81.8 0 5 6 0.25 4 6 0.2 0 0 0 0 0 12.5 h "
        "1\n");
    const Scan& scan = log.scans.at(0);
    EXPECT_EQ(scan.world_from_sensor, (Pose{5.0, 6.0, 0.25}));
    EXPECT_EQ(scan.first_angle_rad, -2.0);
    EXPECT_EQ(scan.angle_step_rad, 0.5);
    EXPECT_EQ(scan.max_range_m, 30.0);
    EXPECT_EQ(scan.time_s, 12.5);
}

TEST(Carmen, RawLasersStandWhereTheOdometrySays) {
    const LogFile log = parse(
        "PARAM robot_frontlaser_offset 0.3 nohost 0\n"
        "PARAM robot_rearlaser_offset -0.2 nohost 0\n"
        "ODOM 1 2 1.5707963267948966 0 0 0 1 host 1\n" +
        rawlaser(1) + rawlaser(2) + "ODOM 5 5 0 0 0 0 1 host 1\n" + rawlaser(3));
    ASSERT_EQ(log.scans.size(), 3U);
    EXPECT_NEAR(log.scans[0].world_from_sensor.x, 1.0, 1e-12);
    EXPECT_NEAR(log.scans[0].world_from_sensor.y, 2.3, 1e-12);
    EXPECT_NEAR(log.scans[0].world_from_sensor.yaw_rad, kPi / 2, 1e-12);
    EXPECT_NEAR(log.scans[1].world_from_sensor.y, 1.8, 1e-12);
    EXPECT_NEAR(log.scans[1].world_from_sensor.yaw_rad, -kPi / 2, 1e-12);
    EXPECT_EQ(log.scans[2].world_from_sensor, (Pose{5.0, 5.0, 0.0}));
    EXPECT_EQ(log.scans[0].max_range_m, 20.0);
}

TEST(Carmen, RawLasersBeforeTheFirstOdometryAreSkipped) {
    const LogFile log = parse(rawlaser(1) + "ODOM 0 0 0 0 0 0 1 h 1\n" + rawlaser(1));
    EXPECT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.warnings, Warnings{"x.log: 1 raw scan without a pose skipped, the first in line "
                                     "1: expected ODOM before it"});
    EXPECT_EQ(error_in(rawlaser(1)),
              "x.log: none of the laser lines can be used; the first is line 1: expected ODOM "
              "before it");
}

TEST(Carmen, RawLasersAreLeftOutWhereOthersStatePoses) {
    const LogFile log =
        parse("ODOM 9 9 0 0 0 0 1 h 1\n" + rawlaser(1) + flaser("1 1 0") + rawlaser(1));
    ASSERT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.scans[0].world_from_sensor, (Pose{1.0, 1.0, 0.0}));
    EXPECT_TRUE(log.warnings.empty());
}

TEST(Carmen, ParametersLimitTheRange) {
    const LogFile log = parse("PARAM robot_front_laser_max 25.5 nohost 0\n" + flaser("0 0 0"));
    EXPECT_EQ(log.scans[0].max_range_m, 25.5);
    EXPECT_EQ(parse("PARAM robot_front_laser_max nan\n" + flaser("0 0 0")).scans[0].max_range_m,
              kMaxUsableRange);
    EXPECT_EQ(parse("PARAM robot_front_laser_max 25.5\n" + flaser("0 0 0"), {.max_range_m = 10.0})
                  .scans[0]
                  .max_range_m,
              10.0);
}

TEST(Carmen, ALimitIsNeverAboveTheReadingItNames) {
    // 29.99 is no float; the float next to it is less.
    const LogFile log =
        parse("ROBOTLASER1 0 -1 2 0.5 29.99 0 0 4 1 1 1 29.99 0 0 0 0 0 0 0 0 0 0 0 0 1 h 1\n");
    EXPECT_GE(static_cast<double>(log.scans[0].ranges_m[3]), log.scans[0].max_range_m);
}

TEST(Carmen, FindsTheValueThatMeansNoReturn) {
    std::string text;
    for (int i = 0; i < 200; ++i) {
        const std::string near = std::to_string(2.0 + 0.1 * i);
        text += flaser("0 0 0", std::to_string(i), "1.5 " + near + " 51.06 3.5");
    }
    const LogFile log = parse(text);
    for (const Scan& scan : log.scans) {
        EXPECT_LE(scan.max_range_m, 51.06);
        EXPECT_GE(scan.max_range_m, 50.0);
    }
    EXPECT_EQ(parse(text, {.max_range_m = 70.0}).scans[0].max_range_m, 70.0);
}

TEST(Carmen, TimesThatRunBackwardsAreCountedAndKept) {
    const LogFile log = parse(flaser("1 0 0", "10") + flaser("2 0 0", "9") + flaser("3 0 0", "9") +
                              flaser("4 0 0", "8"));
    EXPECT_EQ(log.scans[3].world_from_sensor.x, 4.0);
    EXPECT_EQ(log.scans[3].time_s, 8.0);
    EXPECT_EQ(log.warnings, Warnings{"x.log: 2 time stamps run backwards (the order of the lines "
                                     "is kept), the first in line 2"});
}

TEST(Carmen, AScanWithoutATimeHasTheOneBefore) {
    const LogFile log =
        parse("FLASER 2 1 1 0 0 0\n" + flaser("0 0 0", "5") + "FLASER 2 1 1 0 0 0\n");
    EXPECT_EQ(log.scans[0].time_s, 0.0);
    EXPECT_EQ(log.scans[2].time_s, 5.0);
    EXPECT_TRUE(log.warnings.empty());
}

TEST(Carmen, GarbageIsSkippedCountedAndNamed) {
    const LogFile log = parse("what is this\n" + flaser("0 0 0") + "\x01\x02\n" +
                              "FLASER 4 1 2 3\n" + "FLASER x\n");
    EXPECT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.warnings,
              (Warnings{"x.log: 2 lines that are no messages skipped, the first in line 1: "
                        "expected a message, found \"what is this\"",
                        "x.log: 2 unusable laser lines skipped, the first in line 4: expected 4 "
                        "ranges, the line is too short for them"}));
}

TEST(Carmen, UnusablePosesAreSkipped) {
    const LogFile log = parse(flaser("nan 0 0") + flaser("1 1 1") + flaser("0 1e300 0") +
                              "ODOM x 0 0 0 0 0 1 h 1\n");
    EXPECT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.warnings, Warnings{"x.log: 3 lines with unusable poses skipped, the first in "
                                     "line 1: expected a finite pose"});
    EXPECT_EQ(error_in(flaser("nan 0 0")),
              "x.log: none of the laser lines can be used; the first is line 1: expected a finite "
              "pose");
}

TEST(Carmen, ImpossibleRangesAreCounted) {
    const LogFile log = parse(flaser("0 0 0") + flaser("0 0 0", "2", "nan -1 3 4"));
    EXPECT_EQ(log.scans.size(), 2U);
    EXPECT_TRUE(std::isinf(log.scans[1].ranges_m[0]));
    EXPECT_EQ(log.warnings,
              Warnings{"x.log: 2 beams with negative ranges or none ignored, the first in line 2"});
}

TEST(Carmen, ACutOffLastLineIsSkipped) {
    const std::string line = flaser("123.456 0 0");
    const std::string whole = line + line.substr(0, line.size() - 1);
    EXPECT_EQ(parse(whole).scans.size(), 2U);  // Only the line end is missing.
    for (std::size_t length = 10; length < line.size() - 6; ++length) {
        const LogFile log = parse(line + line.substr(0, length));
        EXPECT_EQ(log.scans.size(), 1U) << length;
        EXPECT_EQ(log.warnings.size(), 1U) << length;
    }
    const std::string cut = line.substr(0, line.find("3.456"));
    EXPECT_EQ(parse(line + cut).warnings[0],
              "x.log: 1 unusable laser line skipped, the first in line 2: expected the laser's x, "
              "y and theta after the ranges");
}

TEST(Carmen, ALogWithoutALaserIsRefused) {
    EXPECT_EQ(error_in(""), "x.log: the file is empty, expected a CARMEN log");
    EXPECT_EQ(error_in("# nothing\nODOM 1 2 3 0 0 0 1 h 1\n"),
              "x.log: no laser line in 2 lines, expected FLASER, RLASER, ROBOTLASER1 or RAWLASER1");
    EXPECT_EQ(error_in("hello\n"),
              "x.log: no laser line in 1 lines, expected FLASER, RLASER, ROBOTLASER1 or RAWLASER1");
    EXPECT_EQ(error_in("FLASER 3 1\n"),
              "x.log: none of the laser lines can be used; the first is line 1: expected 3 ranges, "
              "the line is too short for them");
}

TEST(Carmen, AnEndlessLineIsSkipped) {
    const LogFile log = parse("FLASER " + std::string(3'000'000, '1') + "\n" + flaser("0 0 0"));
    EXPECT_EQ(log.scans.size(), 1U);
    EXPECT_EQ(log.warnings, Warnings{"x.log: 1 line that is no message skipped, the first in line "
                                     "1: expected a shorter line"});
}

TEST(Carmen, ReadsOneScanAtATime) {
    const std::string text =
        flaser("1 0 0") + "junk\n" + flaser("2 0 0") + "RLASER 4 1 1 1 1 2 0 0 0 0 0 1 host 1\n";
    CarmenReader reader([&text] { return pieces_of(text); }, "x.log");
    ASSERT_TRUE(reader.next().has_value());
    EXPECT_EQ(reader.counts().lines, 1U);
    EXPECT_EQ(reader.last_laser(), 0U);
    const std::optional<Scan> second = reader.next();
    ASSERT_TRUE(second.has_value());
    EXPECT_EQ(second->world_from_sensor.x, 2.0);
    EXPECT_EQ(reader.counts().garbage_lines.count, 1U);
    ASSERT_TRUE(reader.next().has_value());
    EXPECT_EQ(reader.last_laser(), 1U);
    EXPECT_EQ(reader.no_return_limits_m().size(), 2U);
    EXPECT_FALSE(reader.next().has_value());
    EXPECT_FALSE(reader.next().has_value());
}

TEST(Carmen, ReadsFilesAndHashesTheirBytes) {
    const ScratchFolder folder;
    const auto path = folder.write("a.log", flaser("0 0 0") + "junk\n");
    const LogFile log = read_carmen_log(path);
    EXPECT_EQ(log.content_hash, hash_bytes(flaser("0 0 0") + "junk\n"));
    EXPECT_EQ(log.warnings.at(0).find(path.string() + ": 1 line"), 0U);
    EXPECT_EQ(error_of([] { (void)read_carmen_log("/nowhere.log"); }),
              "/nowhere.log: cannot be opened: No such file or directory");
}

}  // namespace
}  // namespace quadcut::io
