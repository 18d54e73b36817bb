// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/label_spots.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace quadcut::draw {
namespace {

void paint(Raster<std::uint16_t>& ground, std::uint16_t room, const Box& box) {
    for (std::int32_t y = box.low.y; y <= box.high.y; ++y) {
        for (std::int32_t x = box.low.x; x <= box.high.x; ++x) ground.at({x, y}) = room;
    }
}

TEST(LabelSpots, TheRoomiestPlaceComesFirst) {
    Raster<std::uint16_t> ground({-20, 5}, 100, 60);
    paint(ground, 2, {{-10, 10}, {70, 13}});
    paint(ground, 2, {{30, 10}, {50, 30}});
    const auto spots = find_label_spots(ground, {2});
    ASSERT_EQ(spots.size(), 1U);
    ASSERT_FALSE(spots[0].empty());
    EXPECT_NEAR(spots[0][0].x, 40.5, 1.0);
    EXPECT_NEAR(spots[0][0].y, 20.5, 1.0);
    for (const Point& spot : spots[0]) {
        EXPECT_EQ(ground.at({static_cast<std::int32_t>(spot.x - 0.5),
                             static_cast<std::int32_t>(spot.y - 0.5)}),
                  2);
    }
}

TEST(LabelSpots, LieInEveryStretchOfABentRoom) {
    Raster<std::uint16_t> ground({0, 0}, 200, 200);
    paint(ground, 1, {{10, 10}, {190, 20}});
    paint(ground, 1, {{10, 10}, {20, 190}});
    const auto spots = find_label_spots(ground, {1});
    const auto has = [&](const auto& is_there) {
        return std::any_of(spots[0].begin(), spots[0].end(), is_there);
    };
    EXPECT_TRUE(has([](const Point& spot) { return spot.x > 80 && spot.x < 120; }));
    EXPECT_TRUE(has([](const Point& spot) { return spot.y > 80 && spot.y < 120; }));
    EXPECT_LE(spots[0].size(), 24U);
}

TEST(LabelSpots, OfARoomWithoutCellsThereAreNone) {
    Raster<std::uint16_t> ground({0, 0}, 10, 10);
    paint(ground, 1, {{2, 2}, {4, 4}});
    const auto spots = find_label_spots(ground, {1, 7});
    EXPECT_FALSE(spots.at(0).empty());
    EXPECT_TRUE(spots.at(1).empty());
    EXPECT_TRUE(find_label_spots(ground, {}).empty());
}

}  // namespace
}  // namespace quadcut::draw
