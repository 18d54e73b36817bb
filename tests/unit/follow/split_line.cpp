// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/split_line.hpp"

#include <cstdio>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "quadcut/follow/follower.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut {
namespace {

using io::test::error_of;
using testing::HasSubstr;

/// One room at any granularity.
FollowOptions one_room() {
    FollowOptions options;
    options.segment.rooms.granularity = 0.0;
    return options;
}

/// A hall of 12 x 5 m with a stub of a wall from its lower side up to a height, at x = 5 m.
Raster<CellState> hall_with_stub(double height_m) {
    Raster<CellState> states = test::bare_hall();
    const auto top = 10 + static_cast<std::int32_t>(height_m / 0.05);
    for (std::int32_t y = 10; y < top; ++y) {
        for (std::int32_t x = 99; x < 103; ++x) states.at({x, y}) = CellState::occupied;
    }
    return states;
}

/// Makes the cut that an error names.
void split_as_offered(Follower& follower, const std::string& error) {
    Point from;
    Point to;
    const std::size_t at = error.find("the nearest cut is from (");
    ASSERT_NE(at, std::string::npos) << error;
    ASSERT_EQ(std::sscanf(error.c_str() + at, "the nearest cut is from (%lf, %lf) to (%lf, %lf)",
                          &from.x, &from.y, &to.x, &to.y),
              4);
    const std::size_t before = follower.num_rooms();
    EXPECT_EQ(error_of([&] { follower.edit(test::split(from, to)); }), "no error");
    EXPECT_EQ(follower.num_rooms(), before + 1);
}

TEST(SplitLine, AlongAWallCutsWhereTheWallEnds) {
    for (const double height_m : {0.5, 1.5, 2.5, 3.5, 4.5}) {
        Follower follower(one_room());
        follower.update_cells(hall_with_stub(height_m));
        ASSERT_EQ(follower.num_rooms(), 1U) << height_m;
        follower.edit(test::split({5.05, 0.6}, {5.05, 5.4}));
        EXPECT_EQ(follower.num_rooms(), 2U) << height_m;
        EXPECT_NE(follower.room_at({4.0, 1.0}), follower.room_at({6.0, 1.0}));
        const SplitLine line = follower.state().split_lines.front();
        EXPECT_NEAR(std::min(line.from.y, line.to.y), 10 + height_m / 0.05, 5.0);
    }
}

TEST(SplitLine, MayCrossAPillar) {
    Follower follower(one_room());
    Raster<CellState> states = test::bare_hall();
    for (std::int32_t y = 50; y < 66; ++y) {
        for (std::int32_t x = 95; x < 111; ++x) states.at({x, y}) = CellState::occupied;
    }
    follower.update_cells(states);
    ASSERT_EQ(follower.num_rooms(), 1U);
    follower.edit(test::split({5.1, 0.7}, {5.1, 5.3}));
    EXPECT_EQ(follower.num_rooms(), 2U);
    EXPECT_NE(follower.room_at({4.0, 3.0}), follower.room_at({6.5, 3.0}));
}

TEST(SplitLine, AcrossTheWallOfARoomCutsTheRoomWhereMostOfItLies) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    ASSERT_EQ(follower.num_rooms(), 2U);
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    // From wall to wall in the left room, on through the wall into the right one.
    follower.edit(test::split({0.6, 4.0}, {5.9, 4.0}));
    EXPECT_EQ(follower.num_rooms(), 3U);
    EXPECT_EQ(follower.room_at({9.0, 3.0}), right);
    EXPECT_NE(follower.room_at({2.0, 5.0}), follower.room_at({2.0, 2.0}));
    EXPECT_TRUE(follower.room_at({2.0, 5.0}) == left || follower.room_at({2.0, 2.0}) == left);
    // The line ends at that wall.
    EXPECT_LE(follower.state().split_lines.front().to.x, 108);
    follower.update_cells(Raster<CellState>({150, 60}, 12, 12, CellState::occupied));
    EXPECT_EQ(follower.num_rooms(), 3U);
}

TEST(SplitLine, WhollyInAWallIsRefusedWithACutThatCanBeMade) {
    Follower follower(one_room());
    follower.update_cells(hall_with_stub(3.0));
    const std::string in_stub = error_of([&] {
        follower.edit(test::split({5.05, 0.8}, {5.05, 2.0}));
    });
    split_as_offered(follower, in_stub);
}

TEST(SplitLine, WhatIsOfferedCanBeMadeAtAnyResolution) {
    for (const double resolution_m : {0.01, 0.025, 0.05, 0.1}) {
        FollowOptions options = one_room();
        options.resolution_m = resolution_m;
        Follower follower(options);
        const auto cells = [&](double length_m) {
            return static_cast<std::int32_t>(length_m / resolution_m);
        };
        Raster<CellState> states({0, 0}, cells(7.0), cells(5.0), CellState::occupied);
        for (std::int32_t y = cells(0.5); y < cells(4.5); ++y) {
            for (std::int32_t x = cells(0.5); x < cells(6.5); ++x) {
                states.at({x, y}) = CellState::free;
            }
        }
        follower.update_cells(states);
        ASSERT_EQ(follower.num_rooms(), 1U);
        const std::string error = error_of([&] {
            follower.edit(test::split({3.0, 2.0}, {3.9, 2.9}));
        });
        EXPECT_THAT(error, HasSubstr("before a wall"));
        split_as_offered(follower, error);
    }
}

TEST(SplitLine, MayEndAtTheEdgeOfWhatCanBe) {
    Follower follower(one_room());
    follower.update_cells(test::bare_hall());
    EXPECT_THAT(error_of([&] {
                    follower.edit(test::split({-1e5, 3.0}, {1e5, 3.0}));
                }),
                HasSubstr("no error"));
    EXPECT_NE(error_of([&] {
                  follower.edit(test::split({-1e300, 3.0}, {1e300, 3.0}));
              }),
              "no error");
}

}  // namespace
}  // namespace quadcut
