// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/poses.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::ScratchFolder;

constexpr double kPi = std::numbers::pi;

std::vector<TimedPose> parse(std::string_view text) { return parse_poses(text, "p.txt"); }
std::string error_in(std::string_view text) {
    return error_of([&] { (void)parse(text); });
}

TEST(Poses, ReadsTum) {
    const auto poses = parse(
        "# time x y z qx qy qz qw\n"
        "\n"
        "1305.5 1.5 -2 9 0 0 0 1\r\n"
        "1306.5\t2.5 -3 9  0 0 0.70710678 0.70710678\n"
        "1307.5 0 0 0 0 0 1 0");
    ASSERT_EQ(poses.size(), 3U);
    EXPECT_EQ(poses[0].time_s, 1305.5);
    EXPECT_EQ(poses[0].pose, (Pose{1.5, -2.0, 0.0}));
    EXPECT_NEAR(poses[1].pose.yaw_rad, kPi / 2, 1e-9);
    EXPECT_NEAR(poses[2].pose.yaw_rad, kPi, 1e-12);
}

TEST(Poses, YawDoesNotDependOnTheQuaternionsLengthOrSign) {
    const auto poses = parse(
        "0 0 0 0 0 0 -0.3826834 -0.9238795\n"
        "1 0 0 0 0 0 1e3 2.41421356e3\n"
        "2 0 0 0 0.1 -0.2 0.3826834 0.9238795\n");
    EXPECT_NEAR(poses[0].pose.yaw_rad, kPi / 4, 1e-7);
    EXPECT_NEAR(poses[1].pose.yaw_rad, kPi / 4, 1e-7);
    // Tilted: the heading of the x axis in the plane, from the rotation matrix.
    const double n = 0.1 * 0.1 + 0.2 * 0.2 + 0.3826834 * 0.3826834 + 0.9238795 * 0.9238795;
    const double r00 = 1.0 - 2.0 * (0.2 * 0.2 + 0.3826834 * 0.3826834) / n;
    const double r10 = 2.0 * (-0.1 * 0.2 + 0.3826834 * 0.9238795) / n;
    EXPECT_NEAR(poses[2].pose.yaw_rad, std::atan2(r10, r00), 1e-9);
}

TEST(Poses, ReadsG2o) {
    const auto poses = parse(
        "PARAMS_SE2OFFSET 0 0 0 0\n"
        "VERTEX_SE2 7 1 2 0.5\n"
        "VERTEX_SE2 3 4 5 -0.5\n"
        "FIX 7\n"
        "VERTEX_XY 9 1 1\n"
        "EDGE_SE2 7 3 1 0 0 1 0 0 1 0 1\n"
        "VERTEX_SE3:QUAT 8 6 7 1 0 0 0 2\n");
    ASSERT_EQ(poses.size(), 3U);
    EXPECT_EQ(poses[0].time_s, 7.0);
    EXPECT_EQ(poses[0].pose, (Pose{1.0, 2.0, 0.5}));
    EXPECT_EQ(poses[1].time_s, 3.0);  // As they stand, not sorted.
    EXPECT_EQ(poses[2].pose, (Pose{6.0, 7.0, 0.0}));
}

TEST(Poses, NamesTheLine) {
    EXPECT_EQ(error_in("0 0 0 0 0 0 0 1\n1 2 3\n"),
              "p.txt: line 2: expected eight finite numbers t x y z qx qy qz qw, found \"1 2 3\"");
    EXPECT_EQ(error_in("0 0 nan 0 0 0 0 1"),
              "p.txt: line 1: expected eight finite numbers t x y z qx qy qz qw, found "
              "\"0 0 nan 0 0 0 0 1\"");
    EXPECT_EQ(error_in("#\n0 0 0 0 0 0 0 0\n"),
              "p.txt: line 2: expected a quaternion that is not zero, found \"0 0 0 0 0 0 0 0\"");
    EXPECT_EQ(error_in("VERTEX_SE2 1 2 inf 4\n"),
              "p.txt: line 1: expected four finite numbers id x y yaw after VERTEX_SE2, found "
              "\"VERTEX_SE2 1 2 inf 4\"");
    EXPECT_EQ(error_in("VERTEX_SE2 1 2 3 4\n5 6 7\n"),
              "p.txt: line 2: expected an entry of a g2o file, found \"5 6 7\"");
}

TEST(Poses, RefusesFilesWithoutAPose) {
    EXPECT_EQ(error_in(""), "p.txt: the file is empty, expected poses (TUM or g2o)");
    EXPECT_EQ(error_in("# nothing\n\n"),
              "p.txt: no pose in it, expected TUM lines or g2o's VERTEX_SE2");
    EXPECT_EQ(error_in("hello world\n"),
              "p.txt: no pose in it, expected TUM lines or g2o's VERTEX_SE2");
}

TEST(Poses, ReadsFiles) {
    const ScratchFolder folder;
    EXPECT_EQ(read_poses(folder.write("a.tum", "1 2 3 0 0 0 0 1\n")).size(), 1U);
    EXPECT_EQ(error_of([] { (void)read_poses("/nowhere.tum"); }),
              "/nowhere.tum: cannot be opened: No such file or directory");
}

}  // namespace
}  // namespace quadcut::io
