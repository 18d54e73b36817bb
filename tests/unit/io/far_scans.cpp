// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/far_scans.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/follow/follower.hpp"

namespace quadcut::io {
namespace {

constexpr double kResolution = 0.05;

/// Four beams of so many metres.
Scan scan_at(const Pose& pose, float range_m = 5.0F) {
    Scan scan;
    scan.world_from_sensor = pose;
    scan.first_angle_rad = -1.5;
    scan.angle_step_rad = 1.0;
    scan.max_range_m = 80.0;
    scan.ranges_m.assign(4, range_m);
    return scan;
}

/// Once around a circle of 2 m.
std::vector<Scan> around_the_origin(std::size_t count) {
    std::vector<Scan> scans;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 6.28 * static_cast<double>(i) / static_cast<double>(count);
        scans.push_back(scan_at({2.0 * std::cos(angle), 2.0 * std::sin(angle), angle}));
    }
    return scans;
}

std::vector<Scan> drive(double to_x, double to_y, std::size_t count, float range_m) {
    std::vector<Scan> scans;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(count - 1);
        scans.push_back(scan_at({t * to_x, t * to_y, 0.0}, range_m));
    }
    return scans;
}

std::vector<ScanReach> reaches_of(const std::vector<Scan>& scans) {
    std::vector<ScanReach> reaches;
    for (const Scan& scan : scans) {
        reaches.push_back({scan.world_from_sensor, longest_reading_m(scan), 0});
    }
    return reaches;
}

std::vector<std::size_t> far_ones(const std::vector<Scan>& scans, const ExtentLimit& limit = {}) {
    const FarScans far = find_far_scans(reaches_of(scans), kResolution, limit);
    EXPECT_EQ(far.is_far.size(), far.count == 0 ? 0 : scans.size());
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < far.is_far.size(); ++i) {
        if (far.is_far[i]) result.push_back(i);
    }
    EXPECT_EQ(result.size(), far.count);
    if (far.count > 0) {
        EXPECT_EQ(result.front(), far.first);
    }
    return result;
}

TEST(FarScans, NoneInAnOrdinaryLog) {
    EXPECT_TRUE(far_ones(around_the_origin(30)).empty());
    EXPECT_TRUE(far_ones({}).empty());
    EXPECT_TRUE(far_ones({scan_at({5e6, 5e6, 0.0})}).empty());
}

TEST(FarScans, AWildPoseWhereverItIsInTheLog) {
    for (const std::size_t place : {0, 15, 30}) {
        for (const Pose& wild : {Pose{100000, 0, 0}, Pose{1414, 1414, 0}, Pose{-700, 710, 1},
                                 Pose{0, 2000, 0}, Pose{1e7, -1e7, 0}}) {
            std::vector<Scan> scans = around_the_origin(30);
            scans.insert(scans.begin() + static_cast<std::ptrdiff_t>(place), scan_at(wild));
            EXPECT_EQ(far_ones(scans), std::vector<std::size_t>{place}) << wild.x << " " << wild.y;
        }
    }
}

TEST(FarScans, ThoseThatAreNoPlace) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const Pose& wild : {Pose{kNan, 0, 0}, Pose{0, kInfinite, 0}, Pose{0, 0, kNan},
                             Pose{1e300, -1e300, 0}, Pose{0, 0, 1e300}, Pose{1.4e7, 0, 0}}) {
        std::vector<Scan> scans = around_the_origin(10);
        scans[4].world_from_sensor = wild;
        EXPECT_EQ(far_ones(scans), std::vector<std::size_t>{4}) << wild.x << " " << wild.yaw_rad;
        EXPECT_EQ(far_ones({scans[4]}), std::vector<std::size_t>{0});
    }
}

TEST(FarScans, AScanThatSeesNothingTakesNoRoom) {
    std::vector<Scan> scans = around_the_origin(30);
    scans[3] = scan_at({1000.0, 1000.0, 0.0}, 80.0F);
    scans[5] = scan_at({1000.0, 1000.0, 0.0}, -1.0F);
    scans[7] = scan_at({1000.0, 1000.0, 0.0}, std::numeric_limits<float>::quiet_NaN());
    scans[9].ranges_m.clear();
    EXPECT_TRUE(far_ones(scans).empty());
}

TEST(FarScans, ALongDriveIsKept) {
    // 1 km along a diagonal with 20 m of sight; three sides of a square with less.
    EXPECT_TRUE(far_ones(drive(707.0, 707.0, 500, 20.0F)).empty());
    std::vector<Scan> scans = drive(600.0, 0.0, 300, 3.0F);
    const std::vector<Scan> up = drive(0.0, 600.0, 300, 3.0F);
    scans.insert(scans.end(), up.begin(), up.end());
    EXPECT_TRUE(far_ones(scans).empty());
}

TEST(FarScans, ADriveBeyondTheLimitIsKeptAroundItsMiddle) {
    const std::vector<Scan> scans = drive(1414.0, 1414.0, 501, 20.0F);
    const std::vector<std::size_t> far = far_ones(scans);
    ASSERT_FALSE(far.empty());
    // As many on both sides of the middle, within one.
    const auto num_before = static_cast<std::size_t>(
        std::count_if(far.begin(), far.end(), [](std::size_t i) { return i < 250; }));
    EXPECT_LE(std::max(num_before, far.size() - num_before) -
                  std::min(num_before, far.size() - num_before),
              1U);
    EXPECT_LT(far.size(), 300U);
    for (std::size_t i = 120; i < 380; ++i) {
        EXPECT_TRUE(std::find(far.begin(), far.end(), i) == far.end()) << i;
    }
}

TEST(FarScans, AnotherPartCountsByWhatIsConnectedInIt) {
    // 120 m off is too far for a scan, but not for a part of the map with as many cells.
    ExtentLimit limit;
    limit.scattered = 0;
    std::vector<Scan> scans = around_the_origin(30);
    scans.push_back(scan_at({120.0, 120.0, 0.0}));
    EXPECT_EQ(far_ones(scans, limit), std::vector<std::size_t>{30});
    scans.pop_back();
    for (Scan scan : drive(60.0, 60.0, 60, 10.0F)) {
        scan.world_from_sensor.x += 60.0;
        scan.world_from_sensor.y += 60.0;
        scans.push_back(scan);
    }
    EXPECT_TRUE(far_ones(scans, limit).empty());
    limit.most = 1000000;
    EXPECT_FALSE(far_ones(scans, limit).empty());
}

TEST(FarScans, TheOrderPlaysNoPart) {
    std::vector<Scan> scans = drive(900.0, 900.0, 100, 15.0F);
    scans.push_back(scan_at({-300.0, 900.0, 0.0}));
    std::vector<std::size_t> expected = far_ones(scans);
    EXPECT_FALSE(expected.empty());
    std::reverse(scans.begin(), scans.end());
    std::vector<std::size_t> reversed = far_ones(scans);
    for (std::size_t& i : reversed) i = scans.size() - 1 - i;
    std::sort(reversed.begin(), reversed.end());
    EXPECT_EQ(reversed, expected);
}

TEST(FarScans, TheReasonSaysHowFarAndWhatIsExpected) {
    std::vector<Scan> scans = around_the_origin(30);
    scans.push_back(scan_at({100000.0, 0.0, 0.0}));
    const FarScans far = find_far_scans(reaches_of(scans), kResolution);
    for (const char* const part : {"(100000, 0)", "100 km", " cells, expected at most "}) {
        EXPECT_NE(far.reason.find(part), std::string::npos) << far.reason;
    }
}

/// The follower's own limit, which holds for streams, refuses no scan that is kept.
TEST(FarScans, AFollowerTakesAllThatIsKept) {
    const std::vector<Scan> scans = drive(900.0, 900.0, 40, 5.0F);
    ExtentLimit limit;
    limit.scattered = limit.most;
    const FarScans far = find_far_scans(reaches_of(scans), kResolution, limit);
    EXPECT_GT(far.count, 0U);
    Follower follower;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        if (far.is_far[i]) continue;
        EXPECT_NO_THROW(follower.add_scan(scans[i])) << i;
    }
}

}  // namespace
}  // namespace quadcut::io
