// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/pose_match.hpp"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

TEST(PoseMatch, ByTimeStampAndInBetween) {
    const PoseMatch match(
        {{102.0, {4.0, 0.0, 0.0}}, {100.0, {0.0, 0.0, 0.0}}, {101.0, {2.0, 8.0, 0.0}}}, 3);
    EXPECT_EQ(match.pose_of(0, 100.25), (Pose{0.5, 2.0, 0.0}));
    EXPECT_EQ(match.pose_of(1, 101.0), (Pose{2.0, 8.0, 0.0}));
    EXPECT_EQ(match.pose_of(2, 101.5), (Pose{3.0, 4.0, 0.0}));
}

TEST(PoseMatch, TurnsTheShorterWay) {
    const PoseMatch match({{10.0, {0, 0, 3.0}}, {11.0, {0, 0, -3.0}}}, 1);
    EXPECT_NEAR(std::cos(match.pose_of(0, 10.5).value().yaw_rad), -1.0, 1e-12);
}

TEST(PoseMatch, NumbersOfScans) {
    // Vertices 0 and 2 of three scans whose clock has nothing to do with numbers.
    const PoseMatch match({{0.0, {0, 0, 0}}, {2.0, {4, 2, 0}}}, 3);
    EXPECT_EQ(match.pose_of(1, 7e8 + 1), (Pose{2.0, 1.0, 0.0}));
    EXPECT_EQ(match.pose_of(2, 7e8 + 2), (Pose{4.0, 2.0, 0.0}));
}

TEST(PoseMatch, NoneFarOutside) {
    const PoseMatch match({{10.0, {1, 0, 0}}, {12.0, {3, 0, 0}}}, 5);
    EXPECT_EQ(match.pose_of(0, 9.0), std::nullopt);
    EXPECT_EQ(match.pose_of(1, 9.6)->x, 1.0);
    EXPECT_EQ(match.pose_of(2, 10.5)->x, 1.5);
    EXPECT_EQ(match.pose_of(3, 12.4)->x, 3.0);
    EXPECT_EQ(match.pose_of(4, 12.6), std::nullopt);
}

TEST(PoseMatch, WhyNoneSaysBothTimes) {
    const PoseMatch match({{100.5, {}}, {200.0, {}}}, 2);
    EXPECT_EQ(match.why_none(5.0, 6.0), "the poses are of 100.5 to 200 s, the scans of 5 to 6 s");
}

}  // namespace
}  // namespace quadcut::io
