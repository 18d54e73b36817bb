// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/plot.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++found;
    }
    return found;
}

TEST(Plot, HasItsNamesEscaped) {
    const std::string svg = to_svg(Plot{"a < b & c", "scan", "nodes", {{"one", {{1.0, 2.0}}}}});
    EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
    EXPECT_NE(svg.find(">scan<"), std::string::npos);
    EXPECT_NE(svg.find(">nodes<"), std::string::npos);
    EXPECT_EQ(svg.find("a < b"), std::string::npos);
}

TEST(Plot, EachPointIsInItsCurve) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string svg = to_svg(
        Plot{"t", "x", "y", {{"dots", {{1.0, 2.0}, {2.0, nan}, {3.0, 4.0}}, CurveStyle::dots}}});
    EXPECT_EQ(count(svg, "<circle"), 2U);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(
        count(to_svg(Plot{"t", "x", "y", {{"a", {{0.0, 1.0}}}, {"b", {{1.0, 1.0}}}}}), "<polyline"),
        2U);
}

TEST(Plot, NothingToShowIsStillAPlot) {
    EXPECT_NE(to_svg(Plot{"t", "x", "y", {}}).find("</svg>"), std::string::npos);
    EXPECT_NE(to_svg(BarPlot{"t", "ms", "", {}, {}}).find("</svg>"), std::string::npos);
}

TEST(Plot, ALogarithmicAxisShowsSmallAndLarge) {
    Plot plot{
        "t", "scan", "ms", {{"a", {{1.0, 0.0}, {2.0, 5.0}, {3.0, 4000.0}}, CurveStyle::dots}}};
    plot.is_y_log = true;
    const std::string svg = to_svg(plot);
    EXPECT_EQ(count(svg, "<circle"), 2U) << "0 has no place";
    EXPECT_NE(svg.find("ms (logarithmic)"), std::string::npos);
    EXPECT_NE(svg.find(">1,000<"), std::string::npos);
}

TEST(BarPlot, EachValueHasABarWithItsNumber) {
    const BarPlot plot{"t", "ms", "", {"a", "b"}, {{"one", {1.0, 2.0}}, {"two", {3.0, 0.0}}}};
    const std::string svg = to_svg(plot);
    // Three bars, the page and two squares of the legend.
    EXPECT_EQ(count(svg, "<rect"), 6U);
    EXPECT_EQ(count(svg, "class=\"value\""), 3U);
    EXPECT_EQ(svg.find("logarithmic"), std::string::npos);
}

TEST(BarPlot, AWideSpanIsLogarithmicAndSaysSo) {
    const std::string svg =
        to_svg(BarPlot{"t", "count", "", {"a"}, {{"one", {5.0}}, {"two", {4e6}}}});
    EXPECT_NE(svg.find("count (logarithmic)"), std::string::npos);
    EXPECT_NE(svg.find(">4 M<"), std::string::npos);
}

}  // namespace
}  // namespace quadcut
