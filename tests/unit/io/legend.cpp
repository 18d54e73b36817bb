// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/legend.hpp"

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

TEST(Legend, IsSetInColumnsThatDoNotOverlap) {
    const Typeface typeface;
    std::vector<LegendLine> lines(7, LegendLine{{}, {}, "12: Kitchen, 8.3 m\u00B2", {}, 10.0});
    const double width = set_in_columns(lines, {100.0, 20.0}, 50.0, typeface);
    EXPECT_EQ(lines[0].left.x, 100.0);
    EXPECT_EQ(lines[2].left.x, 100.0);
    EXPECT_GT(lines[2].left.y, lines[1].left.y + 10.0);
    EXPECT_LE(lines[2].left.y, 70.0);
    EXPECT_EQ(lines[3].left.y, lines[0].left.y) << "three lines fit below each other";
    EXPECT_GT(lines[3].left.x, 100.0 + width_of(lines[0], typeface));
    EXPECT_EQ(lines[6].left.x + width_of(lines[6], typeface), 100.0 + width);
}

TEST(Legend, HasAColumnALineOnAPageThatIsFlat) {
    std::vector<LegendLine> lines(3, LegendLine{{}, {}, "12", {}, 10.0});
    EXPECT_GT(set_in_columns(lines, {0.0, 0.0}, 2.0, Typeface()), 0.0);
    EXPECT_EQ(lines[2].left.y, lines[0].left.y);
    std::vector<LegendLine> none;
    EXPECT_EQ(set_in_columns(none, {0.0, 0.0}, 2.0, Typeface()), 0.0);
}

}  // namespace
}  // namespace quadcut::io
