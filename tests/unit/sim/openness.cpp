// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/openness.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace quadcut::sim {
namespace {

// A corridor of 20 m along x, 2 m wide, and a room of 6 m above it; a door of 0.9 m between.
Plan corridor_and_room() {
    Plan plan;
    const std::size_t corridor = plan.add_room(RoomUse::corridor, {}, {0.0, 0.0, 20.0, 2.0}, 0.2);
    const std::size_t room = plan.add_room(RoomUse::office, {}, {4.0, 2.1, 10.0, 7.0}, 0.2);
    plan.doors.push_back({corridor, room, {}, {5.0, 2.0, 5.9, 2.1}, false});
    return plan;
}

TEST(Openness, WidenedDoorsStayInTheWallBetweenTheirRooms) {
    bool is_wide = false;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Plan plan = corridor_and_room();
        widen_doors(plan, 1.0, Random(seed));
        const PlanDoor& door = plan.doors.front();
        EXPECT_TRUE(door.is_open_passage);
        EXPECT_GE(door.opening.width(), 1.3);
        EXPECT_LE(door.opening.width(), 0.8 * 6.0);
        EXPECT_GT(door.opening.x0, 4.1);
        EXPECT_LT(door.opening.x1, 9.9);
        is_wide = is_wide || door.opening.width() > 3.0;
    }
    EXPECT_TRUE(is_wide);
}

TEST(Openness, DoorsBetweenCorridorsAndToToiletsKeepTheirWidth) {
    for (const RoomUse use : {RoomUse::corridor, RoomUse::toilet}) {
        Plan plan = corridor_and_room();
        plan.rooms[1].use = use;
        widen_doors(plan, 1.0, Random(1));
        EXPECT_FALSE(plan.doors.front().is_open_passage);
        EXPECT_DOUBLE_EQ(plan.doors.front().opening.width(), 0.9);
    }
}

TEST(Openness, LobbiesLieInTheirSpaceAndAreEnteredAtFullWidth) {
    Random random(4);
    bool is_round = false;
    for (int i = 0; i < 30; ++i) {
        const Lobby lobby = draw_lobby(2.2, random);
        Plan plan;
        const std::size_t corridor =
            plan.add_room(RoomUse::corridor, {}, {-1.1, -10.0, 1.1, 0.0}, 0.2);
        add_lobby(plan, lobby, {}, corridor);
        ASSERT_EQ(plan.rooms.size(), 2U);
        const Rect space = lobby.space();
        for (const Polygon& wedge : plan.rooms[1].wedges) {
            is_round = true;
            for (const Point& p : wedge) EXPECT_TRUE(space.contains({p.x, std::max(p.y, 0.31)}));
        }
        EXPECT_DOUBLE_EQ(plan.doors.front().opening.width(), 2.2);
        EXPECT_TRUE(plan.doors.front().is_open_passage);
    }
    EXPECT_TRUE(is_round);
}

}  // namespace
}  // namespace quadcut::sim
