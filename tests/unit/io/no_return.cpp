// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/no_return.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"

namespace quadcut::io {
namespace {

/// Readings that thin out towards `farthest`, as those of a building do, and among them `share`
/// readings of "no return", spread over `width`.
NoReturnFinder finder_of(double farthest, double no_return, double share, double width = 0.0,
                         int count = 50'000) {
    Random random(7);
    std::vector<float> readings;
    for (int i = 0; i < count; ++i) {
        const double u = random.uniform();
        const double reading =
            random.uniform() < share ? no_return + width * u : farthest * (1.0 - std::sqrt(u));
        readings.push_back(static_cast<float>(reading));
    }
    NoReturnFinder finder;
    finder.add(readings);
    return finder;
}

TEST(NoReturn, FindsTheUsualValues) {
    for (const double value : {8.19, 30.0, 31.99, 50.0, 51.06}) {
        for (const double share : {0.005, 0.05, 0.5}) {
            const double limit = finder_of(0.9 * value, value, share, 0.003 * value).limit_m();
            EXPECT_LE(limit, value) << value << " " << share;
            EXPECT_GE(limit, 0.97 * value) << value << " " << share;
        }
    }
}

TEST(NoReturn, FindsItAmongTrueReadingsThatReachIt) {
    const double limit = finder_of(50.0, 50.0, 0.02).limit_m();
    EXPECT_LE(limit, 50.0);
    EXPECT_GE(limit, 48.5);
}

TEST(NoReturn, ReadingsWithoutOneKeepTheLimit) {
    for (const double farthest : {5.0, 12.0, 40.0}) {
        EXPECT_EQ(finder_of(farthest, 0.0, 0.0).limit_m(), kMaxUsableRange) << farthest;
    }
    // 81.83 lies beyond the limit as it is.
    EXPECT_EQ(finder_of(26.0, 81.83, 0.1).limit_m(), kMaxUsableRange);
    EXPECT_EQ(NoReturnFinder().limit_m(), kMaxUsableRange);
}

TEST(NoReturn, StraysBeyondDoNotHideIt) {
    NoReturnFinder finder = finder_of(40.0, 50.0, 0.02);
    finder.add(std::vector<float>{55.0F, 61.3F, 72.0F, 79.9F});
    EXPECT_GE(finder.limit_m(), 48.0);
    EXPECT_LE(finder.limit_m(), 50.0);
}

TEST(NoReturn, AWallAllAroundIsNone) {
    NoReturnFinder finder;
    finder.add(std::vector<float>(180, 6.0F));
    EXPECT_EQ(finder.limit_m(), kMaxUsableRange);
}

TEST(NoReturn, InvalidReadingsDoNotCount) {
    NoReturnFinder finder;
    finder.add(std::vector<float>{NAN, INFINITY, -3.0F, 0.0F});
    EXPECT_EQ(finder.limit_m(), kMaxUsableRange);
}

}  // namespace
}  // namespace quadcut::io
