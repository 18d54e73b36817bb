// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/line_of_sight.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/paper/small_map.hpp"

namespace quadcut {
namespace {

/// A drawing and, in it, the sight from one corner or centre to another, in half cells from the
/// lower left.
bool sees(const std::vector<std::string>& rows, HalfCell a, HalfCell b) {
    const test::States states = test::map_from_text(rows);
    const BlockedCells blocked(test::table_of(states), {0, 0},
                               {states.width - 1, states.height - 1});
    EXPECT_EQ(blocked.sees(a, b), blocked.sees(b, a));
    return blocked.sees(a, b);
}

TEST(LineOfSight, AWallBlocksAndAGapDoesNot) {
    const std::vector<std::string> rows{
        "..#.",
        "..#.",
        "....",
        "..#.",
    };
    EXPECT_FALSE(sees(rows, {1, 7}, {7, 7}));
    EXPECT_TRUE(sees(rows, {1, 3}, {7, 3}));
    EXPECT_TRUE(sees(rows, {1, 1}, {3, 7}));
    EXPECT_FALSE(sees(rows, {1, 1}, {7, 1}));
}

TEST(LineOfSight, UnknownBlocksLikeAnObstacle) { EXPECT_FALSE(sees({"..?."}, {1, 1}, {7, 1})); }

TEST(LineOfSight, TouchingOneCornerOfOneCellIsFree) {
    const std::vector<std::string> rows{
        "#...",
        "....",
        "....",
        "...#",
    };
    // Through (2, 6), the lower right corner of the upper left obstacle, and ending in it.
    EXPECT_TRUE(sees(rows, {1, 5}, {3, 7}));
    EXPECT_TRUE(sees(rows, {3, 5}, {2, 6}));
    EXPECT_FALSE(sees(rows, {1, 7}, {7, 1}));
}

TEST(LineOfSight, SlippingBetweenTwoDiagonalCellsIsBlocked) {
    const std::vector<std::string> rising{
        ".#",
        "#.",
    };
    const std::vector<std::string> falling{
        "#.",
        ".#",
    };
    EXPECT_FALSE(sees(rising, {1, 3}, {3, 1}));
    EXPECT_FALSE(sees(falling, {1, 1}, {3, 3}));
    // Along the line that both cells touch, from either side.
    EXPECT_FALSE(sees(rising, {0, 2}, {4, 2}));
    EXPECT_FALSE(sees(falling, {2, 0}, {2, 4}));
}

TEST(LineOfSight, SlidingAlongOneBlockedCellIsFree) {
    const std::vector<std::string> rows{
        "....",
        "....",
        "####",
        "....",
    };
    EXPECT_TRUE(sees(rows, {2, 4}, {6, 4}));
    EXPECT_TRUE(sees(rows, {2, 2}, {6, 2}));
}

TEST(LineOfSight, RunningBetweenTwoBlockedCellsIsBlocked) {
    const std::vector<std::string> rows{
        "....",
        ".##.",
        ".##.",
        "....",
    };
    EXPECT_FALSE(sees(rows, {0, 4}, {8, 4}));
    EXPECT_FALSE(sees(rows, {4, 0}, {4, 8}));
    // The common corner of the four is inside the block as well.
    EXPECT_FALSE(sees(rows, {4, 4}, {8, 8}));
}

TEST(LineOfSight, TheRimOfTheRectangleIsFreeAndBeyondItIsBlocked) {
    const std::vector<std::string> rows{
        "..",
        "..",
    };
    EXPECT_TRUE(sees(rows, {1, 0}, {3, 0}));
    EXPECT_TRUE(sees(rows, {4, 1}, {4, 3}));
    // In the corner of the rectangle two of the cells beyond it meet diagonally.
    EXPECT_FALSE(sees(rows, {1, 0}, {4, 0}));
    const BlockedCells blocked(test::table_of(test::map_from_text(rows)), {-1, 0}, {1, 1});
    EXPECT_FALSE(blocked.sees({-1, 1}, {3, 1}));
}

TEST(LineOfSight, EachPlaceOfALongLatticeLineIsLookedAt) {
    constexpr std::int32_t kLength = 200;
    for (std::int32_t place = 0; place + 1 < kLength; ++place) {
        const auto line_is_clear = [&](const std::vector<Cell>& obstacles) {
            BlockedCells blocked({0, 0}, {kLength - 1, 1});
            for (std::int32_t i = 0; i < 2 * kLength; ++i) {
                const Cell cell{i / 2, i % 2};
                if (std::find(obstacles.begin(), obstacles.end(), cell) == obstacles.end()) {
                    blocked.open_square(cell, 1);
                }
            }
            // Inside the lower row a single obstacle is enough.
            EXPECT_FALSE(blocked.sees({0, 1}, {2 * kLength, 1}));
            return blocked.sees({0, 2}, {2 * kLength, 2});
        };
        EXPECT_FALSE(line_is_clear({{place, 0}, {place, 1}})) << place;
        EXPECT_FALSE(line_is_clear({{place, 0}, {place + 1, 1}})) << place;
        EXPECT_FALSE(line_is_clear({{place + 1, 0}, {place, 1}})) << place;
        // Along one side only it is free, but at the ends an obstacle would pinch with the outside.
        EXPECT_EQ(line_is_clear({{place, 0}, {place + 1, 0}}), place > 0 && place + 2 < kLength);
    }
}

TEST(LineOfSight, KnownClearEndsAreNotLookedAt) {
    BlockedCells blocked({0, 0}, {15, 0});
    blocked.open_square({8, 0}, 1);
    EXPECT_FALSE(blocked.sees({1, 1}, {31, 1}));
    EXPECT_TRUE(blocked.sees({1, 1}, {31, 1}, 15, 13));
    EXPECT_TRUE(blocked.sees({31, 1}, {1, 1}, 13, 15));
    EXPECT_FALSE(blocked.sees({31, 1}, {1, 1}, 15, 12));
}

TEST(LineOfSight, CentresAreLatticePoints) {
    EXPECT_EQ(centre({{3, -2}, 0, CellState::free}), (HalfCell{7, -3}));
    EXPECT_EQ(centre({{-8, 4}, 2, CellState::free}), (HalfCell{-12, 12}));
}

TEST(LineOfSight, AnEmptyRectangleIsRefused) {
    EXPECT_THROW(BlockedCells({0, 0}, {-1, 0}), std::logic_error);
}

}  // namespace
}  // namespace quadcut
