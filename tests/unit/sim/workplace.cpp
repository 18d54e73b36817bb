// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/workplace.hpp"

#include <gtest/gtest.h>

namespace quadcut::sim {
namespace {

TEST(Workplace, FiveRoomsInARectangle) {
    const Building workplace = paper_workplace();
    ASSERT_EQ(workplace.rooms.size(), 5U);
    ASSERT_EQ(workplace.doors.size(), 4U);
    double area = 0.0;
    for (const TrueRoom& room : workplace.rooms) {
        EXPECT_EQ(room.kind, RoomKind::room);
        area += room.area_m2;
    }
    EXPECT_NEAR(area, 4 * 5.4 * 4.9 + 4.8 * 10.0 + 4 * 0.2, 0.5);
    for (const TrueDoor& door : workplace.doors) {
        EXPECT_NEAR(door.width_m, 1.0, 1e-9);
        EXPECT_TRUE(index(door.a) == 1 || index(door.b) == 1);
    }
    EXPECT_EQ(workplace.map.states.values, workplace.bare.states.values);

    // Walls, floor and 1 m of unknown around: 18 x 12 m.
    EXPECT_NEAR(workplace.map.states.width, 360, 2);
    EXPECT_NEAR(workplace.map.states.height, 240, 2);
}

}  // namespace
}  // namespace quadcut::sim
