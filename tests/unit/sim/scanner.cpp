// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/scanner.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace quadcut::sim {
namespace {

// 6 m by 4 m of floor with a wall around, and a pane across at x = 3.
World hall_with_pane() {
    World world;
    world.map.resolution_m = 0.05;
    world.map.states = Raster<CellState>({0, 0}, 120, 80, CellState::free);
    world.glass = Raster<std::uint8_t>({0, 0}, 120, 80);
    for (std::int32_t y = 0; y < 80; ++y) {
        for (std::int32_t x = 0; x < 120; ++x) {
            const bool is_wall = x < 2 || y < 2 || x >= 118 || y >= 78;
            if (is_wall || x == 60) world.map.states.at({x, y}) = CellState::occupied;
            if (!is_wall && x == 60) world.glass.at({x, y}) = 1;
        }
    }
    return world;
}

ScannerOptions exact() {
    ScannerOptions options;
    options.laser = {M_PI, M_PI / 180.0, 20.0, 0.0, 0.0};
    options.glints = 0.0;
    return options;
}

TEST(Scanner, GlassReturnsABeamThatMeetsItSquarelyAndLetsOthersThrough) {
    Scanner scanner(hall_with_pane(), exact(), Random(1));
    const Scan scan = scanner.scan({1.0, 2.0, 0.0});
    EXPECT_NEAR(scan.ranges_m[90], 2.0, 0.01);  // straight ahead: the pane
    EXPECT_NEAR(scan.ranges_m[90 + 15], 4.9 / std::cos(15.0 * M_PI / 180.0), 0.02);
    EXPECT_NEAR(scan.ranges_m[0], 1.9, 0.01);  // to the side: the wall
}

TEST(Scanner, GlintsReturnAnyBeam) {
    ScannerOptions options = exact();
    options.glints = 1.0;
    Scanner scanner(hall_with_pane(), options, Random(1));
    const Scan scan = scanner.scan({1.0, 2.0, 0.0});
    EXPECT_NEAR(scan.ranges_m[90 + 15], 2.0 / std::cos(15.0 * M_PI / 180.0), 0.02);
}

TEST(Scanner, SomeBeamsPassBesideALeg) {
    World world = hall_with_pane();
    for (std::uint8_t& glass : world.glass.values) {
        if (glass != 0) glass = World::kThin;
    }
    ScannerOptions options = exact();
    const auto num_beyond = [&](double passes) {
        options.passes = passes;
        Scanner scanner(world, options, Random(1));
        const Scan scan = scanner.scan({1.0, 2.0, 0.0});
        return std::count_if(scan.ranges_m.begin() + 70, scan.ranges_m.begin() + 110,
                             [](float range) { return range > 3.0F; });
    };
    EXPECT_EQ(num_beyond(0.0), 0);
    EXPECT_GT(num_beyond(0.5), 10);
    EXPECT_LT(num_beyond(0.5), 30);
}

TEST(Scanner, PeopleStandInTheWay) {
    ScannerOptions options = exact();
    const auto sum_of = [&](double people) {
        options.people = people;
        Scanner scanner(hall_with_pane(), options, Random(2));
        double sum = 0.0;
        for (int i = 0; i < 10; ++i) {
            for (const float range : scanner.scan({1.0, 2.0, 0.0}).ranges_m) {
                sum += static_cast<double>(range);
            }
        }
        return sum;
    };
    EXPECT_LT(sum_of(1.0), sum_of(0.0) - 5.0);
}

TEST(Scanner, WhatIsOutOfReachIsTheMaximumItself) {
    ScannerOptions options = exact();
    options.laser.max_range_m = 1.5;
    Scanner scanner(hall_with_pane(), options, Random(1));
    const Scan scan = scanner.scan({1.0, 2.0, 0.0});
    EXPECT_GE(static_cast<double>(scan.ranges_m[90]), scan.max_range_m);
}

}  // namespace
}  // namespace quadcut::sim
