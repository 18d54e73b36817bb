// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/carmen_line.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

std::string ranges(int count, const std::string& value = "1.5") {
    std::string text = std::to_string(count);
    for (int i = 0; i < count; ++i) text += " " + value;
    return text;
}

LaserLine parse(LaserKind kind, const std::string& fields) {
    const ParsedLaserLine parsed = parse_laser_line({kind, 1}, fields);
    EXPECT_EQ(parsed.problem, "");
    return parsed.line.value_or(LaserLine{});
}

std::string problem_of(LaserKind kind, const std::string& fields) {
    const ParsedLaserLine parsed = parse_laser_line({kind, 1}, fields);
    EXPECT_FALSE(parsed.line.has_value());
    return parsed.problem;
}

TEST(CarmenLine, KnowsTheLasersByTheirMessages) {
    EXPECT_EQ(find_laser("FLASER"), (LaserName{LaserKind::front, 1}));
    EXPECT_EQ(find_laser("RLASER"), (LaserName{LaserKind::rear, 1}));
    EXPECT_EQ(find_laser("ROBOTLASER2"), (LaserName{LaserKind::robot, 2}));
    EXPECT_EQ(find_laser("RAWLASER4"), (LaserName{LaserKind::raw, 4}));
    for (const char* other : {"ODOM", "FLASER1", "ROBOTLASER", "RAWLASER0", "RAWLASER12", "flaser",
                              "LASER3", "REMISSIONFLASER", ""}) {
        EXPECT_FALSE(find_laser(other).has_value()) << other;
    }
}

TEST(CarmenLine, ReadsAFrontLaser) {
    const LaserLine line =
        parse(LaserKind::front, " 2 1.25 81.83 1 2 0.5 3 4 -0.5 976055541.25 host 2683.5");
    EXPECT_EQ(line.ranges_m, (std::vector<float>{1.25F, 81.83F}));
    EXPECT_EQ(line.laser_pose, (Pose{1.0, 2.0, 0.5}));
    EXPECT_EQ(line.odometry, (Pose{3.0, 4.0, -0.5}));
    EXPECT_EQ(line.time_s, 976055541.25);
    EXPECT_TRUE(line.is_whole);
    EXPECT_TRUE(std::isinf(line.max_range_m));
    EXPECT_EQ(line.num_invalid_ranges, 0U);
}

TEST(CarmenLine, BeamsFollowFromTheirNumber) {
    struct Expected {
        int count;
        double first_degrees;
        double step_degrees;
    };
    for (const Expected& expected :
         {Expected{180, -90, 1}, Expected{181, -90, 1}, Expected{360, -90, 0.5},
          Expected{361, -90, 0.5}, Expected{721, -90, 0.25}, Expected{401, -100, 0.5},
          Expected{540, -135, 0.5}, Expected{541, -135, 0.5}, Expected{1081, -135, 0.25},
          Expected{3, -90, 90}, Expected{2, -90, 90}}) {
        const LaserLine line = parse(LaserKind::front, ranges(expected.count) + " 0 0 0");
        EXPECT_NEAR(line.first_angle_rad / kDegree, expected.first_degrees, 1e-9) << expected.count;
        EXPECT_NEAR(line.angle_step_rad / kDegree, expected.step_degrees, 1e-9) << expected.count;
    }
}

TEST(CarmenLine, TheEndMayBeMissing) {
    const LaserLine bare = parse(LaserKind::front, "2 1 1 1 2 0.5");
    EXPECT_FALSE(bare.odometry.has_value());
    EXPECT_FALSE(bare.time_s.has_value());
    EXPECT_FALSE(bare.is_whole);
    EXPECT_FALSE(parse(LaserKind::front, "2 1 1 1 2 0.5 1 2 0.5 77.5 host").is_whole);
    EXPECT_FALSE(parse(LaserKind::front, "2 1 1 0 0 0 0 0 0 nan h 1").time_s.has_value());
}

TEST(CarmenLine, ImpossibleRangesSayNothing) {
    const LaserLine line = parse(LaserKind::front, "6 nan -1 inf 1e9 0 2 0 0 0");
    ASSERT_EQ(line.ranges_m.size(), 6U);
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(std::isinf(line.ranges_m[static_cast<std::size_t>(i)]));
    EXPECT_EQ(line.ranges_m[4], 0.0F);
    EXPECT_EQ(line.ranges_m[5], 2.0F);
    EXPECT_EQ(line.num_invalid_ranges, 4U);
}

TEST(CarmenLine, SaysWhatIsWrong) {
    EXPECT_EQ(problem_of(LaserKind::front, ""),
              "expected a number of ranges, at least 2, found \"\"");
    EXPECT_EQ(problem_of(LaserKind::front, "1 2.5 0 0 0"),
              "expected a number of ranges, at least 2, found \"1\"");
    EXPECT_EQ(problem_of(LaserKind::front, "-5 1 1 1"),
              "expected a number of ranges, at least 2, found \"-5\"");
    EXPECT_EQ(problem_of(LaserKind::front, "999999999999 1 1 1"),
              "expected 999999999999 ranges, the line is too short for them");
    EXPECT_EQ(problem_of(LaserKind::front, "3 1 x 1 0 0 0"), "expected 3 ranges, range 2 is \"x\"");
    EXPECT_EQ(problem_of(LaserKind::front, "3 1.0 1.0"), "expected 3 ranges, range 3 is \"\"");
    EXPECT_EQ(problem_of(LaserKind::rear, "2 1 1 0 0"),
              "expected the laser's x, y and theta after the ranges");
}

TEST(CarmenLine, ReadsARobotLaserWithItsOwnAngles) {
    const LaserLine line = parse(LaserKind::robot,
                                 "0 -2.356194 4.712389 0.004363 30.0 0.01 0 3 1 2 3 2 7 8 "
                                 "5 6 0.25 4 6 0.25 0.1 0.2 0.3 0.4 1e6 1234.5 nohost 99.5");
    EXPECT_EQ(line.first_angle_rad, -2.356194);
    EXPECT_EQ(line.angle_step_rad, 0.004363);
    EXPECT_EQ(line.max_range_m, 30.0);
    EXPECT_EQ(line.ranges_m, (std::vector<float>{1.0F, 2.0F, 3.0F}));
    EXPECT_EQ(line.laser_pose, (Pose{5.0, 6.0, 0.25}));
    EXPECT_EQ(line.odometry, (Pose{4.0, 6.0, 0.25}));
    EXPECT_EQ(line.time_s, 1234.5);
    EXPECT_TRUE(line.is_whole);
}

TEST(CarmenLine, ReadsARawLaser) {
    const LaserLine line =
        parse(LaserKind::raw, "0 -1.57 3.14 0 0 0.01 0 3 1 2 3 0 1234.5 nohost 99.5");
    EXPECT_EQ(line.angle_step_rad, 1.57);  // From the field of view when none is stated.
    EXPECT_TRUE(std::isinf(line.max_range_m));
    EXPECT_EQ(line.time_s, 1234.5);
    EXPECT_TRUE(line.is_whole);
}

TEST(CarmenLine, SaysWhatIsWrongWithTheNewerLines) {
    EXPECT_EQ(problem_of(LaserKind::robot, "0 -1.57 3.14 0.1 x 0 0 2 1 1 0 0 0 0"),
              "expected the seven numbers of the laser, found \"x\"");
    EXPECT_EQ(problem_of(LaserKind::robot, "0 nan 3.14 0.1 50 0 0 2 1 1 0 0 0 0"),
              "expected a start angle within one turn");
    EXPECT_EQ(problem_of(LaserKind::robot, "0 -1.57 3.14 3 50 0 0 4 1 1 1 1 0 0 0 0"),
              "expected beams that sweep at most one turn");
    EXPECT_EQ(problem_of(LaserKind::robot, "0 -1.57 nan 0 50 0 0 2 1 1 0 0 0 0"),
              "expected beams that sweep at most one turn");
    EXPECT_EQ(problem_of(LaserKind::robot, "0 -1.57 3.14 0.1 50 0 0 2 1 1 999999999 0 0 0"),
              "expected 999999999 remission values, found 3");
    EXPECT_EQ(problem_of(LaserKind::robot, "0 -1.57 3.14 0.1 50 0 0 2 1 1 -1 0 0 0"),
              "expected the number of remission values");
    EXPECT_EQ(problem_of(LaserKind::robot, "0 -1.57 3.14 0.1 50 0 0 2 1 1 0 0 0"),
              "expected the laser's x, y and theta after the remission values");
}

TEST(CarmenLine, PosesMustBePlausible) {
    EXPECT_TRUE(is_plausible({5e6, -5e6, 100.0}));
    EXPECT_FALSE(is_plausible({std::nan(""), 0.0, 0.0}));
    EXPECT_FALSE(is_plausible({0.0, 1e8, 0.0}));
    EXPECT_FALSE(is_plausible({0.0, 0.0, INFINITY}));
}

}  // namespace
}  // namespace quadcut::io
