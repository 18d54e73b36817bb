// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/typeface.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace quadcut::draw {
namespace {

TEST(Typeface, WidthGrowsWithTextAndSize) {
    const Typeface typeface;
    EXPECT_EQ(typeface.width("", 20.0), 0.0);
    EXPECT_GT(typeface.width("MM", 20.0), typeface.width("M", 20.0));
    EXPECT_NEAR(typeface.width("Kitchen", 40.0), 2.0 * typeface.width("Kitchen", 20.0), 1e-9);
    // An m of a sans serif is about one size wide; digits are all alike.
    EXPECT_NEAR(typeface.width("M", 100.0), 86.0, 5.0);
    EXPECT_EQ(typeface.width("111", 10.0), typeface.width("888", 10.0));
}

TEST(Typeface, OutlinesStandOnTheBaseLine) {
    const Typeface typeface;
    double top = 0.0;
    double bottom = -100.0;
    double right = 0.0;
    for (const auto& line : typeface.outlines("HH", 100.0)) {
        for (const Point& point : line) {
            top = std::min(top, point.y);
            bottom = std::max(bottom, point.y);
            right = std::max(right, point.x);
        }
    }
    EXPECT_NEAR(-top, typeface.cap_height(100.0), 1e-9);
    EXPECT_EQ(bottom, 0.0);
    EXPECT_LE(right, typeface.width("HH", 100.0));
    EXPECT_GT(right, 0.8 * typeface.width("HH", 100.0));
}

TEST(Typeface, HasOutlinesWithHoles) {
    const Typeface typeface;
    EXPECT_EQ(typeface.outlines("o", 20.0).size(), 2U);
    EXPECT_EQ(typeface.outlines("i", 20.0).size(), 2U);
    EXPECT_EQ(typeface.outlines(" ", 20.0).size(), 0U);
}

TEST(Typeface, DrawsSomethingForTextItHasNotAndForNoText) {
    const Typeface typeface;
    EXPECT_GT(typeface.outlines("\U000F0000", 20.0).size(), 0U);
    EXPECT_GT(typeface.width("\xFF\xFE", 20.0), 0.0);
    EXPECT_GT(typeface.width("\u00E4\u20AC\u00B2", 20.0), 0.0);
}

}  // namespace
}  // namespace quadcut::draw
