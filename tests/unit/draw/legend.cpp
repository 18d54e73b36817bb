// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/legend.hpp"

#include <gtest/gtest.h>

namespace quadcut::draw {
namespace {

TEST(Legend, IsSetInColumnsThatDoNotOverlap) {
    const Typeface typeface;
    std::vector<LegendLine> lines(30, LegendLine{{}, {}, "12: Kitchen, 8.3 m\u00B2", {}, 10.0});
    const LegendBlock block = set_in_columns(lines, {100.0, 20.0}, 390.0, typeface);
    EXPECT_EQ(lines[0].left.x, 100.0);
    EXPECT_EQ(lines[2].left.x, 100.0);
    EXPECT_GT(lines[2].left.y, lines[1].left.y + 10.0);
    EXPECT_LE(lines[25].left.y, 410.0);
    EXPECT_EQ(lines[26].left.y, lines[0].left.y) << "26 lines fit below each other";
    EXPECT_GT(lines[26].left.x, 100.0 + width_of(lines[0], typeface));
    EXPECT_EQ(lines[29].left.x + width_of(lines[29], typeface), 100.0 + block.width);
    EXPECT_LE(block.height, 390.0);
}

TEST(Legend, IsAboutAsHighAsWideBesideAMapThatIsFlat) {
    std::vector<LegendLine> lines(700, LegendLine{{}, {}, "12: Kitchen, 8.3 m\u00B2", {}, 10.0});
    const LegendBlock block = set_in_columns(lines, {0.0, 0.0}, 2.0, Typeface());
    EXPECT_LT(block.width, 1.2 * block.height);
    EXPECT_GT(block.width, 0.8 * block.height);
    std::vector<LegendLine> none;
    EXPECT_EQ(set_in_columns(none, {0.0, 0.0}, 2.0, Typeface()).width, 0.0);
}

}  // namespace
}  // namespace quadcut::draw
