// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/power_fit.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

TEST(PowerFit, FindsThePower) {
    std::vector<Point> points;
    for (const double x : {10.0, 70.0, 3000.0, 1e6}) points.push_back({x, 2.5 * std::pow(x, 1.3)});
    const PowerFit fit = fit_power(points);
    EXPECT_NEAR(fit.exponent, 1.3, 1e-12);
    EXPECT_NEAR(fit.factor, 2.5, 1e-10);
    EXPECT_NEAR(fit.largest_deviation, 1.0, 1e-12);
    EXPECT_EQ(fit.num_points, 4U);
}

TEST(PowerFit, SaysHowFarPointsLieOff) {
    // Off by a factor of 2 in turn, so that the line stays.
    const std::vector<Point> points{{1.0, 2.0}, {10.0, 5.0}, {10.0, 20.0}, {100.0, 200.0 / 4.0}};
    const PowerFit fit = fit_power(points);
    EXPECT_NEAR(fit.exponent, std::log10(25.0) / 2.0, 1e-12);
    EXPECT_NEAR(fit.largest_deviation, 2.0, 1e-12);
}

TEST(PowerFit, NothingToFit) {
    EXPECT_EQ(fit_power({}).exponent, 0.0);
    const std::vector<Point> same{{5.0, 1.0}, {5.0, 2.0}};
    EXPECT_EQ(fit_power(same).exponent, 0.0);
    const std::vector<Point> none{{0.0, 1.0}, {5.0, 0.0}, {-1.0, 2.0}, {7.0, 3.0}};
    EXPECT_EQ(fit_power(none).num_points, 1U);
    EXPECT_EQ(fit_power(none).exponent, 0.0);
}

}  // namespace
}  // namespace quadcut
