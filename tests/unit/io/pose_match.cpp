// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/pose_match.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

std::vector<Scan> scans_at(const std::vector<double>& times_s) {
    std::vector<Scan> scans(times_s.size());
    for (std::size_t i = 0; i < times_s.size(); ++i) {
        scans[i].time_s = times_s[i];
        scans[i].ranges_m = {static_cast<float>(i)};
    }
    return scans;
}

TEST(WithPoses, ByTimeStampAndInBetween) {
    const PosedScans posed = with_poses(
        scans_at({100.25, 101.0, 101.5}),
        {{102.0, {4.0, 0.0, 0.0}}, {100.0, {0.0, 0.0, 0.0}}, {101.0, {2.0, 8.0, 0.0}}}, "poses");
    ASSERT_EQ(posed.scans.size(), 3U);
    EXPECT_EQ(posed.scans[0].world_from_sensor, (Pose{0.5, 2.0, 0.0}));
    EXPECT_EQ(posed.scans[1].world_from_sensor, (Pose{2.0, 8.0, 0.0}));
    EXPECT_EQ(posed.scans[2].world_from_sensor, (Pose{3.0, 4.0, 0.0}));
    EXPECT_EQ(posed.num_left_out, 0U);
}

TEST(WithPoses, TurnsTheShorterWay) {
    const PosedScans posed =
        with_poses(scans_at({10.5}), {{10.0, {0, 0, 3.0}}, {11.0, {0, 0, -3.0}}}, "poses");
    EXPECT_NEAR(std::cos(posed.scans[0].world_from_sensor.yaw_rad), -1.0, 1e-12);
}

TEST(WithPoses, NumbersOfScans) {
    // Vertices 0 and 2 of three scans whose clock has nothing to do with numbers.
    const PosedScans posed = with_poses(scans_at({7e8, 7e8 + 1, 7e8 + 2}),
                                        {{0.0, {0, 0, 0}}, {2.0, {4, 2, 0}}}, "poses");
    ASSERT_EQ(posed.scans.size(), 3U);
    EXPECT_EQ(posed.scans[1].world_from_sensor, (Pose{2.0, 1.0, 0.0}));
    EXPECT_EQ(posed.scans[2].world_from_sensor, (Pose{4.0, 2.0, 0.0}));
}

TEST(WithPoses, ScansOutsideAreLeftOut) {
    const PosedScans posed = with_poses(scans_at({9.0, 9.6, 10.5, 12.4, 12.6}),
                                        {{10.0, {1, 0, 0}}, {12.0, {3, 0, 0}}}, "poses");
    ASSERT_EQ(posed.scans.size(), 3U);
    EXPECT_EQ(posed.num_left_out, 2U);
    EXPECT_EQ(posed.places, (std::vector<std::size_t>{1, 2, 3}));
    EXPECT_EQ(posed.scans[0].ranges_m[0], 1.0F);
    EXPECT_EQ(posed.scans[0].world_from_sensor.x, 1.0);
    EXPECT_EQ(posed.scans[1].world_from_sensor.x, 1.5);
    EXPECT_EQ(posed.scans[2].world_from_sensor.x, 3.0);
}

TEST(WithPoses, NoneNearIsAnErrorThatSaysBothTimes) {
    try {
        static_cast<void>(with_poses(scans_at({5.0, 6.0}), {{100.5, {}}, {200.0, {}}}, "a.tum"));
        FAIL() << "no error";
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.rfind("a.tum: ", 0), 0U) << message;
        EXPECT_NE(message.find("100.5 to 200 s"), std::string::npos) << message;
        EXPECT_NE(message.find("5 to 6 s"), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace quadcut::io
