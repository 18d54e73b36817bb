// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_pairs.hpp"

#include <gtest/gtest.h>

#include "tests/unit/io/floor_drawing.hpp"

namespace quadcut::io {
namespace {

std::vector<RoomPair> pairs_of(const std::vector<std::string>& rows, std::int32_t max_gap) {
    return find_room_pairs(test::drawn_floor(rows).segmentation.labels, max_gap);
}

TEST(RoomPairs, TouchOrLieAcrossAWall) {
    const std::vector<RoomPair> expected = {{1, 2, Closeness::touching},
                                            {1, 3, Closeness::across_wall},
                                            {2, 4, Closeness::across_wall}};
    EXPECT_EQ(pairs_of({"aaabbb", "aaabbb", "######", "cc####", "cc###d"}, 2), expected);
}

TEST(RoomPairs, SeeNoFartherThanAsked) {
    const std::vector<std::string> rows = {"a###b"};
    EXPECT_TRUE(pairs_of(rows, 2).empty());
    EXPECT_EQ(pairs_of(rows, 3).size(), 1U);
    EXPECT_TRUE(pairs_of(rows, 0).empty());
    EXPECT_EQ(pairs_of({"ab"}, 0).size(), 1U);
}

TEST(RoomPairs, ATouchAnywhereCountsAsTouching) {
    const std::vector<RoomPair> expected = {{1, 2, Closeness::touching}};
    EXPECT_EQ(pairs_of({"a#b", "aab", "a#b"}, 3), expected);
}

TEST(RoomPairs, DoNotLookThroughARoom) {
    const std::vector<RoomPair> expected = {{1, 2, Closeness::touching},
                                            {2, 3, Closeness::touching}};
    EXPECT_EQ(pairs_of({"abc"}, 5), expected);
}

}  // namespace
}  // namespace quadcut::io
