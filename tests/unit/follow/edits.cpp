// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"
#include "quadcut/follow/follower.hpp"
#include "quadcut/rooms/describe.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut {
namespace {

using io::test::error_of;
using test::bare_hall;
using test::hall_with_wall;
using testing::HasSubstr;

/// A change that makes the follower cut all of the hall again: a pillar comes, or goes.
void cut_again(Follower& follower, CellState state) {
    follower.update_cells(Raster<CellState>({150, 60}, 12, 12, state));
}

const Room* room_called(const Segmentation& rooms, const std::string& name) {
    for (const Room& room : rooms.rooms) {
        if (room.name == name) return &room;
    }
    return nullptr;
}

TEST(FollowEdit, ANameStaysWithItsRoom) {
    Follower follower;
    follower.update_cells(hall_with_wall());
    ASSERT_EQ(follower.num_rooms(), 2U);
    const RoomId room = follower.room_at({9.0, 3.0});
    follower.edit(test::rename(room, "Kitchen"));
    cut_again(follower, CellState::occupied);
    const Segmentation rooms = follower.rooms();
    const Room* kitchen = room_called(rooms, "Kitchen");
    ASSERT_NE(kitchen, nullptr);
    EXPECT_EQ(kitchen->id, room);
    EXPECT_THAT(error_of([&] { follower.edit(test::rename(RoomId{77}, "x")); }),
                HasSubstr("no room 77"));
    follower.edit(test::rename(room, ""));
    EXPECT_EQ(room_called(follower.rooms(), "Kitchen"), nullptr);
}

TEST(FollowEdit, DefaultNamesBelongToTheirRooms) {
    EXPECT_EQ(room_with_default_name("room 7"), RoomId{7});
    EXPECT_EQ(room_with_default_name("corridor 12"), RoomId{12});
    for (const char* const name :
         {"room", "room 007", "Room 7 b", "7", "", "cellar 7", "room -1"}) {
        EXPECT_EQ(room_with_default_name(name), RoomId{}) << name;
    }
}

TEST(FollowEdit, ANameIsNoOtherRooms) {
    Follower follower;
    follower.update_cells(hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    const std::string number = std::to_string(index(right));
    follower.edit(test::rename(right, "Store"));
    EXPECT_THAT(error_of([&] { follower.edit(test::rename(left, "Store")); }),
                HasSubstr("'Store' is the name of room " + number));
    for (const std::string word : {"room ", "corridor ", "hall "}) {
        EXPECT_THAT(error_of([&] { follower.edit(test::rename(left, word + number)); }),
                    HasSubstr("is the name of room " + number));
        EXPECT_THAT(error_of([&] { follower.edit(test::rename(left, word + "4711")); }),
                    HasSubstr("is the name of room 4711"))
            << "a room of later has it";
    }
    follower.edit(test::rename(left, "room " + std::to_string(index(left))));
    follower.edit(test::rename(right, "Store"));
    EXPECT_EQ(follower.state().rooms.at(static_cast<std::uint32_t>(right)).name, "Store");
}

TEST(FollowEdit, AMergeStaysMerged) {
    Follower follower;
    follower.update_cells(hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    ASSERT_NE(left, right);
    const FollowUpdate merged = follower.edit(test::merge(left, right)).update;
    ASSERT_EQ(merged.events.size(), 1U);
    EXPECT_EQ(merged.events.front().change, RoomChange::merged);
    EXPECT_EQ(merged.events.front().room, right);
    EXPECT_EQ(follower.room_at({9.0, 3.0}), left);
    cut_again(follower, CellState::occupied);
    cut_again(follower, CellState::free);
    EXPECT_EQ(follower.num_rooms(), 1U);
    EXPECT_EQ(follower.room_at({9.0, 3.0}), left);
    EXPECT_EQ(follower.rooms().rooms.size(), 1U);
    EXPECT_THAT(error_of([&] { follower.edit(test::merge(left, left)); }), HasSubstr("itself"));
    EXPECT_THAT(error_of([&] { follower.edit(test::merge(left, right)); }), HasSubstr("no room"));
}

TEST(FollowEdit, WhatWasMergedIsOneAgainWhenADoorOpens) {
    Follower follower;
    follower.update_cells(hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    follower.edit(test::merge(left, follower.room_at({9.0, 3.0})));
    follower.update_cells(Raster<CellState>({100, 50}, 4, 18, CellState::occupied));
    ASSERT_EQ(follower.num_rooms(), 2U) << "the door is shut: a room is connected";
    follower.update_cells(Raster<CellState>({100, 50}, 4, 18, CellState::free));
    EXPECT_EQ(follower.num_rooms(), 1U);
}

TEST(FollowEdit, RoomsThatDoNotTouchCannotBeMerged) {
    Follower follower;
    Raster<CellState> states = hall_with_wall();
    for (std::int32_t y = 10; y < 110; ++y) {
        for (std::int32_t x = 100; x < 104; ++x) states.at({x, y}) = CellState::occupied;
    }
    follower.update_cells(states);
    ASSERT_EQ(follower.num_rooms(), 2U);
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    EXPECT_THAT(error_of([&] { follower.edit(test::merge(left, right)); }),
                HasSubstr("do not touch"));
    EXPECT_EQ(follower.num_rooms(), 2U);
}

TEST(FollowEdit, ASplitLineStaysACut) {
    Follower follower;
    follower.update_cells(bare_hall());
    ASSERT_EQ(follower.num_rooms(), 1U);
    const RoomId hall = follower.room_at({9.0, 3.0});
    // The points are half a metre away from the walls.
    const FollowUpdate split = follower.edit(test::split({4.0, 1.0}, {4.0, 5.0})).update;
    ASSERT_EQ(split.events.size(), 1U);
    EXPECT_EQ(split.events.front().change, RoomChange::split);
    const RoomId part = split.events.front().room;
    EXPECT_EQ(split.events.front().other, hall);
    EXPECT_EQ(follower.room_at({9.0, 3.0}), hall) << "the larger part keeps the id";
    EXPECT_EQ(follower.room_at({2.0, 3.0}), part);
    cut_again(follower, CellState::occupied);
    cut_again(follower, CellState::free);
    EXPECT_EQ(follower.num_rooms(), 2U);
    EXPECT_EQ(follower.room_at({2.0, 3.0}), part);
    EXPECT_EQ(follower.room_at({9.0, 3.0}), hall);
    const Segmentation rooms = follower.rooms();
    ASSERT_EQ(rooms.rooms.size(), 2U);
    const Raster<CellState> states = follower.map().to_grid().states;
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        const bool has_room = rooms.labels.values[i] != 0;
        ASSERT_EQ(has_room, states.values[i] == CellState::free) << "the line belongs to a room";
    }
    ASSERT_EQ(rooms.doors.size(), 1U);
    EXPECT_NEAR(rooms.doors.front().width_m, 5.0, 0.3);
}

TEST(FollowEdit, AMergeTakesASplitBack) {
    Follower follower;
    follower.update_cells(bare_hall());
    const RoomId hall = follower.room_at({9.0, 3.0});
    const RoomId part = follower.edit(test::split({4.0, 1.0}, {4.0, 5.0})).inverse.other;
    follower.edit(test::merge(hall, part));
    EXPECT_TRUE(follower.state().split_lines.empty());
    cut_again(follower, CellState::occupied);
    cut_again(follower, CellState::free);
    EXPECT_EQ(follower.num_rooms(), 1U);
    EXPECT_EQ(follower.room_at({2.0, 3.0}), hall);
}

TEST(FollowEdit, WhatCannotBeSplitIsSaidWithTheNearestCut) {
    Follower follower;
    follower.update_cells(bare_hall());
    const RoomId hall = follower.room_at({9.0, 3.0});
    // 0.2 m of floor would be cut off; across the middle of the hall it ends far from the walls.
    const std::string sliver = error_of([&] {
        follower.edit(test::split({0.7, 1.0}, {0.7, 5.0}));
    });
    EXPECT_THAT(sliver, HasSubstr("the smaller part would have"));
    EXPECT_THAT(sliver, HasSubstr("the nearest cut is from ("));
    const std::string short_line = error_of([&] {
        follower.edit(test::split({6.0, 2.8}, {6.0, 3.2}));
    });
    EXPECT_THAT(short_line, HasSubstr("before a wall"));
    EXPECT_THAT(error_of([&] {
                    follower.edit(test::split({6.0, 3.0}, {6.0, 3.0}));
                }),
                HasSubstr("less than 0.1 m of the line"));
    EXPECT_THAT(error_of([&] {
                    follower.edit(test::split({50.0, 3.0}, {50.0, 4.0}));
                }),
                HasSubstr("no room is within 3 m of (50.00, 3.50)"));
    EXPECT_EQ(follower.num_rooms(), 1U);
    // The cut that it names can be made.
    double x1 = 0.0, y1 = 0.0, x2 = 0.0, y2 = 0.0;
    const std::size_t at = short_line.find("is from (");
    ASSERT_NE(at, std::string::npos);
    ASSERT_EQ(std::sscanf(short_line.c_str() + at, "is from (%lf, %lf) to (%lf, %lf)", &x1, &y1,
                          &x2, &y2),
              4);
    follower.edit(test::split({x1, y1}, {x2, y2}));
    EXPECT_EQ(follower.num_rooms(), 2U);
    EXPECT_EQ(follower.room_at({9.0, 3.0}), hall);
}

TEST(FollowEdit, ALineAcrossARingDoesNotCutIt) {
    Follower follower;
    Raster<CellState> states = bare_hall();
    for (std::int32_t y = 45; y < 75; ++y) {
        for (std::int32_t x = 60; x < 200; ++x) states.at({x, y}) = CellState::occupied;
    }
    follower.update_cells(states);
    ASSERT_EQ(follower.num_rooms(), 1U);
    // One way round is cut; the room goes on the other way.
    EXPECT_THAT(error_of([&] {
                    follower.edit(test::split({6.0, 0.6}, {6.0, 2.2}));
                }),
                HasSubstr("goes on around"));
    EXPECT_EQ(follower.num_rooms(), 1U);
}

TEST(FollowEdit, ALockedRoomKeepsItsBorder) {
    Follower follower;
    follower.update_cells(hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    follower.edit(test::lock(left));
    const std::size_t cells = follower.state().rooms.at(static_cast<std::uint32_t>(left)).num_cells;
    // The wall between goes: they would be one room.
    follower.update_cells(Raster<CellState>({100, 10}, 4, 100, CellState::free));
    cut_again(follower, CellState::occupied);
    EXPECT_EQ(follower.room_at({2.0, 3.0}), left);
    EXPECT_EQ(follower.room_at({9.0, 3.0}), right);
    EXPECT_EQ(follower.state().rooms.at(static_cast<std::uint32_t>(left)).num_cells, cells);
    EXPECT_THAT(error_of([&] { follower.edit(test::merge(right, left)); }), HasSubstr("locked"));
    EXPECT_THAT(error_of([&] {
                    follower.edit(test::split({2.0, 1.0}, {2.0, 5.0}));
                }),
                HasSubstr("locked"));
    // What was the wall is part of the other room now.
    EXPECT_EQ(follower.room_at({5.1, 1.0}), right);
}

TEST(FollowEdit, HoldInThePresetPaperToo) {
    FollowOptions options;
    options.segment.preset = Preset::paper;
    Follower follower(options);
    follower.update_cells(hall_with_wall());
    ASSERT_EQ(follower.num_rooms(), 2U);
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    ASSERT_NE(left, right);
    Follower locked(options, follower.state());
    locked.edit(test::lock(left));
    const std::size_t cells = locked.state().rooms.at(static_cast<std::uint32_t>(left)).num_cells;
    follower.edit(test::merge(left, right));
    for (const CellState state : {CellState::occupied, CellState::free}) {
        cut_again(follower, state);
        cut_again(locked, state);
    }
    EXPECT_EQ(follower.num_rooms(), 1U);
    EXPECT_EQ(follower.room_at({9.0, 3.0}), left);
    EXPECT_EQ(locked.state().rooms.at(static_cast<std::uint32_t>(left)).num_cells, cells);
}

TEST(FollowEdit, TheStateGoesOnAsIfNothingHadHappened) {
    Follower one;
    one.update_cells(hall_with_wall());
    one.edit(test::rename(one.room_at({2.0, 3.0}), "Store"));
    one.edit(test::split({9.0, 1.0}, {9.0, 5.0}));
    Follower other({}, one.state());
    for (Follower* follower : {&one, &other}) cut_again(*follower, CellState::occupied);
    EXPECT_EQ(one.rooms().labels.values, other.rooms().labels.values);
    EXPECT_NE(room_called(other.rooms(), "Store"), nullptr);
    EXPECT_EQ(one.map().num_leaves(), other.map().num_leaves());
    EXPECT_EQ(one.finish().num_rooms, other.finish().num_rooms);
}

}  // namespace
}  // namespace quadcut
