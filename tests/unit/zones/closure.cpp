// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/closure.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/route/drawn_rooms.hpp"

namespace quadcut {
namespace {

using Poses = std::vector<std::size_t>;

/// Two rooms that share a door, and one behind a wall.
DrawnRooms three_rooms() {
    return DrawnRooms({"##############",  //
                       "#aaaaa#bbbbbb#",  //
                       "#aaaaaabbbbbb#",  //
                       "#aaaaa#bbbbbb#",  //
                       "##############",  //
                       "#cccccccccccc#",  //
                       "##############"});
}

TEST(ClosureIndex, LooksInItsOwnRoomAndBeyondOpeningsThatAreNear) {
    const DrawnRooms drawn = three_rooms();
    ClosureIndex index(drawn.frame, drawn.rooms, {30.0, 2.0, 0.0});
    index.add({2.8, 2.2});   // 0: room a, at the door
    index.add({0.7, 2.2});   // 1: room a, far from it
    index.add({1.0, 0.75});  // 2: room c
    index.add({3.8, 2.2});   // 3: room b, at the door
    index.add({6.0, 2.2});   // 4: room b, far from it
    EXPECT_EQ(index.candidates(0), Poses{});
    EXPECT_EQ(index.candidates(1), Poses{0});
    EXPECT_EQ(index.candidates(2), Poses{}) << "behind a wall";
    EXPECT_EQ(index.candidates(3), Poses{0});
    EXPECT_EQ(index.candidates(4), Poses{3});
}

TEST(ClosureIndex, LeavesOutWhatWasJustSeenAndWhatIsOutOfRange) {
    const DrawnRooms drawn = three_rooms();
    ClosureIndex index(drawn.frame, drawn.rooms, {2.0, 2.0, 3.0});
    for (const double x : {1.0, 2.0, 1.0, 2.0, 1.0}) index.add({x, 0.75});
    EXPECT_EQ(index.candidates(2), Poses{}) << "2 m of way since the first";
    EXPECT_EQ(index.candidates(3), Poses{0});
    EXPECT_EQ(index.candidates(4), (Poses{0, 1}));
    index.add({6.0, 0.75});
    EXPECT_EQ(index.candidates(5), Poses{}) << "4 m away";
}

TEST(ClosureIndex, ComparesWhatIsInNoRoomWithAll) {
    const DrawnRooms drawn = three_rooms();
    ClosureIndex index(drawn.frame, drawn.rooms, {30.0, 2.0, 0.0});
    index.add({1.0, 0.75});
    index.add({20.0, 20.0});
    index.add({6.0, 2.2});
    EXPECT_EQ(index.candidates(1), Poses{0});
    EXPECT_EQ(index.candidates(2), Poses{1});
    index.add({0.45, 0.75});
    EXPECT_EQ(index.candidates(3), (Poses{0, 1})) << "in the wall, half a cell from its room";
}

}  // namespace
}  // namespace quadcut
