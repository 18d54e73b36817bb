// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/borders.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "tests/unit/rooms/drawing.hpp"

namespace quadcut {
namespace {

struct Drawn {
    Raster<std::uint32_t> labels = test::drawn_labels({"aabb",  //
                                                       "aabb",  //
                                                       "cccc"});
    Raster<float> clearance{labels.origin, labels.width, labels.height, 0.2F};
    Raster<float> free_clearance = clearance;

    [[nodiscard]] std::array<BorderSaddles, 2> saddles(const WallLines& lines = {}) const {
        return border_saddles(labels, clearance, free_clearance, lines, {});
    }
};

TEST(Borders, ASaddleLiesWhereABorderIsWidest) {
    Drawn drawn;
    drawn.clearance.at({1, 2}) = 0.5F;
    drawn.clearance.at({2, 2}) = 0.4F;
    const auto [walls, all] = drawn.saddles();
    ASSERT_EQ(walls.size(), 3U);
    const Saddle& saddle = walls.at({1, 2});
    EXPECT_EQ(saddle.clearance_m, 0.4F);
    EXPECT_EQ(saddle.a, (Cell{1, 2}));
    EXPECT_EQ(saddle.num_contacts, 2U);
    EXPECT_EQ(all.at({1, 2}).clearance_m, 0.2F);
}

TEST(Borders, WhereFurnitureStandsAllAlongThereIsABorderAmongWallsOnly) {
    Drawn drawn;
    for (std::int32_t y = 1; y < 3; ++y) drawn.free_clearance.at({1, y}) = 0.0F;
    const auto [walls, all] = drawn.saddles();
    EXPECT_EQ(walls.count({1, 2}), 1U);
    EXPECT_EQ(all.count({1, 2}), 0U);
    EXPECT_EQ(all.at({1, 3}).num_contacts, 1U) << "beside the furniture";
}

TEST(Borders, WallsInLineAreCounted) {
    const Drawn drawn;
    WallLines lines{
        {}, Raster<std::uint8_t>(drawn.labels.box()), Raster<std::uint8_t>(drawn.labels.box())};
    lines.less_dm.at({1, 1}) = 5;
    lines.more_dm.at({1, 1}) = 20;
    const Saddle saddle = drawn.saddles(lines)[0].at({1, 2});
    EXPECT_EQ(saddle.num_in_line, 1U);
    EXPECT_EQ(saddle.less_wall_dm, 5U);
    EXPECT_EQ(saddle.more_wall_dm, 20U);
}

TEST(Borders, AJoinKeepsTheWiderOfTwoSaddlesAndAddsUpTheirBorders) {
    Drawn drawn;
    drawn.clearance.at({3, 1}) = 0.3F;
    drawn.clearance.at({3, 0}) = 0.3F;
    Borders borders(drawn.saddles()[0], 3);
    borders.join(1, 2);
    ASSERT_NE(borders.find(1, 3), nullptr);
    EXPECT_EQ(borders.find(1, 3)->clearance_m, 0.3F);
    EXPECT_EQ(borders.find(1, 3)->num_contacts, 4U);
    EXPECT_EQ(borders.find(1, 3)->a, (Cell{3, 1}));
    EXPECT_EQ(borders.find(1, 2), nullptr);
    EXPECT_EQ(borders.of(3).size(), 1U);
    EXPECT_TRUE(borders.of(2).empty());
}

TEST(Borders, AnOpeningIsMeasuredOnceUntilItsSaddleMoves) {
    Drawn drawn;
    drawn.clearance.at({3, 1}) = 0.3F;
    drawn.clearance.at({3, 0}) = 0.3F;
    Borders borders(drawn.saddles()[0], 3);
    EXPECT_TRUE(borders.place_for_opening(1, 3).second);
    EXPECT_FALSE(borders.place_for_opening(1, 3).second);
    const auto wider = borders.place_for_opening(2, 3);
    wider.first->width_m = 0.7;
    borders.join(1, 2);
    EXPECT_FALSE(borders.place_for_opening(1, 3).second) << "that of the wider saddle";
    EXPECT_EQ(borders.opening(1, 3).width_m, 0.7);
}

TEST(Walks, HoldUntilWhatTheyCameUpAgainstJoins) {
    std::vector<std::uint32_t> region(4);
    std::iota(region.begin(), region.end(), 0U);
    Walks walks(3);
    walks.place_for(1, 10).first->met = {2};
    walks.place_for(1, 11).first->met = {3};
    walks.place_for(2, 20).first->met = {};
    walks.join(1, 2, region);
    EXPECT_TRUE(walks.place_for(1, 10).second) << "walked anew";
    EXPECT_FALSE(walks.place_for(1, 11).second);
    EXPECT_FALSE(walks.place_for(1, 20).second) << "that of the region that joined";
}

}  // namespace
}  // namespace quadcut
