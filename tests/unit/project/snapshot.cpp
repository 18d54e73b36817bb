// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/snapshot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "project/project.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut {
namespace {

using io::test::error_of;
using testing::HasSubstr;

/// Two rooms, the right one with a name.
Project two_rooms() {
    Project project = Project::in_memory({});
    project.add(test::hall_with_wall());
    project.edit(test::rename(RoomId{2}, "Hall"));
    return project;
}

/// The same floor as a finished map with its rooms.
Snapshot finished(const Snapshot& followed) { return {followed.map(), followed.rooms()}; }

TEST(Snapshot, AFinishedMapAnswersAsAFollowedOne) {
    const auto followed = two_rooms().snapshot();
    const Snapshot other = finished(*followed);
    for (const Point& point :
         {Point{2.0, 3.0}, Point{9.0, 3.0}, Point{14.0, 3.0}, Point{-1.0, 20.0}}) {
        EXPECT_EQ(followed->room_at(point), other.room_at(point));
        const Place a = followed->place_of(point);
        const Place b = other.place_of(point);
        EXPECT_EQ(a.room, b.room);
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.is_inside, b.is_inside);
        EXPECT_EQ(a.distance_m, b.distance_m);
    }
    for (const char* const word : {"1", "2", "room 1", " Hall "}) {
        EXPECT_EQ(followed->find_room(word), other.find_room(word)) << word;
    }
    EXPECT_EQ(followed->num_rooms(), other.num_rooms());
}

TEST(Snapshot, OutsideOfRoomsTheNearestIsTold) {
    const auto building = two_rooms().snapshot();
    const Place outside = building->place_of({14.0, 3.0});
    EXPECT_EQ(outside.room, RoomId{2});
    EXPECT_EQ(outside.name, "Hall");
    EXPECT_FALSE(outside.is_inside);
    EXPECT_NEAR(outside.distance_m, 1.5, 1e-9);
    EXPECT_EQ(building->room_at({14.0, 3.0}), RoomId{});
    EXPECT_EQ(building->place_of({9.0, 3.0}).distance_m, 0.0);
}

TEST(Snapshot, AWordIsAnIdOrAName) {
    Project project = two_rooms();
    EXPECT_EQ(project.snapshot()->find_room("Hall"), RoomId{2});
    EXPECT_EQ(project.snapshot()->find_room("room 1"), RoomId{1});
    EXPECT_THAT(
        error_of([&] { static_cast<void>(project.snapshot()->find_room("room 2")); }),
        HasSubstr("there is no room 'room 2': expected the id or the name of one of the 2"));
    project.edit(test::rename(RoomId{1}, "2"));
    EXPECT_THAT(error_of([&] { static_cast<void>(project.snapshot()->find_room("2")); }),
                HasSubstr("'2' is the id of one room and the name of room 1"));
}

TEST(Snapshot, OfNothingIsEmpty) {
    const auto nothing = Project::in_memory({}).snapshot();
    EXPECT_TRUE(nothing->map().states.values.empty());
    EXPECT_EQ(nothing->place_of({0.0, 0.0}).room, RoomId{});
    EXPECT_TRUE(nothing->rooms().rooms.empty());
    EXPECT_EQ(nothing->updates(), "");
}

}  // namespace
}  // namespace quadcut
