// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/label_placement.hpp"

#include <gtest/gtest.h>

namespace quadcut::draw {
namespace {

/// Room 1: a rectangle in a raster with a margin of 5.
Raster<std::uint16_t> room_of(std::int32_t width, std::int32_t height) {
    Raster<std::uint16_t> ground({-5, -5}, width + 10, height + 10);
    for (std::int32_t y = 0; y < height; ++y) {
        for (std::int32_t x = 0; x < width; ++x) ground.at({x, y}) = 1;
    }
    return ground;
}

std::optional<RoomLabel> label_in(std::int32_t width, std::int32_t height, double unit = 1.0) {
    const Point middle{width / 2.0, height / 2.0};
    const PageScale scale{10.0, 10.0 + height, 1.0};
    return place_label({1, "Kitchen", "12.3 m\u00B2", middle, middle}, room_of(width, height),
                       scale, unit, Typeface());
}

TEST(LabelPlacement, SetsNameAndAreaInTheMiddle) {
    const auto label = label_in(300, 200);
    ASSERT_TRUE(label);
    EXPECT_EQ(label->room, 1U);
    EXPECT_EQ(label->direction, TextDirection::along_rows);
    EXPECT_EQ(label->name.text, "Kitchen");
    EXPECT_EQ(label->name.size, 30.0);
    EXPECT_EQ(label->name.anchor.x, 160.0);
    ASSERT_TRUE(label->area);
    EXPECT_LT(label->area->size, label->name.size);
    EXPECT_GT(label->area->anchor.y, label->name.anchor.y);
    // The block's middle is the room's.
    const Typeface typeface;
    const double top = label->name.anchor.y - typeface.cap_height(label->name.size);
    EXPECT_NEAR((top + label->area->anchor.y) / 2.0, 110.0, 1e-9);
}

TEST(LabelPlacement, ShrinksTheTextAndDropsTheAreaFirst) {
    const auto small = label_in(90, 60);
    ASSERT_TRUE(small);
    EXPECT_LT(small->name.size, 30.0);
    EXPECT_TRUE(small->area);
    const auto flat = label_in(120, 24);
    ASSERT_TRUE(flat);
    EXPECT_FALSE(flat->area);
}

TEST(LabelPlacement, LeavesOutWhatDoesNotFit) {
    EXPECT_FALSE(label_in(30, 30));
    EXPECT_FALSE(label_in(200, 8));
    EXPECT_FALSE(label_in(90, 60, 10.0));
}

TEST(LabelPlacement, TurnsTheTextInANarrowRoom) {
    const auto label = label_in(40, 300);
    ASSERT_TRUE(label);
    EXPECT_EQ(label->direction, TextDirection::upwards);
    EXPECT_EQ(label->name.anchor.y, 160.0);
}

TEST(LabelPlacement, GoesToTheLabelPointWhereTheCentroidHasNoSpace) {
    // An L whose centroid lies outside of it.
    Raster<std::uint16_t> ground({0, 0}, 300, 300);
    for (std::int32_t i = 0; i < 300 * 60; ++i) {
        ground.at({i % 300, i / 300}) = 1;
        ground.at({i / 300, i % 300}) = 1;
    }
    const auto label = place_label({1, "Hall", "", {200.0, 30.0}, {110.0, 110.0}}, ground,
                                   {0.0, 300.0, 1.0}, 1.0, Typeface());
    ASSERT_TRUE(label);
    EXPECT_EQ(label->name.anchor.x, 200.0);
    EXPECT_FALSE(label->area);
}

}  // namespace
}  // namespace quadcut::draw
