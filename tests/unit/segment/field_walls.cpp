// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cstdint>

#include <gtest/gtest.h>

#include "quadcut/segment/segment.hpp"
#include "tests/unit/segment/painted_floor.hpp"

// Small maps whose walls are seen in pieces, are none, or are missing where a corridor ends.

namespace quadcut {
namespace {

using test::PaintedFloor;
using test::room_at;

TEST(FieldWalls, LowPartitionsBetweenDesksMakeNoRooms) {
    PaintedFloor floor(18.0, 17.0, CellState::unknown);
    floor.room({1.0, 1.0}, {17.0, 12.5});
    floor.room({1.0, 12.65}, {17.0, 15.5});
    floor.door({8.0, 12.45}, {8.9, 12.7});
    for (const double y : {3.5, 8.5}) {
        floor.paint({3.0, y + 1.5}, {15.0, y + 1.6}, CellState::occupied);
        for (int k = 0; k <= 6; ++k) {
            const double x = 3.0 + 2.0 * k;
            floor.paint({x, y}, {x + 0.1, y + 3.0}, CellState::occupied);
        }
    }
    const Segmentation rooms = segment(floor.map);
    ASSERT_EQ(rooms.rooms.size(), 2U);
    EXPECT_NE(room_at(rooms, floor.map, {1.5, 1.5}), room_at(rooms, floor.map, {2.0, 14.0}));
    EXPECT_EQ(room_at(rooms, floor.map, {1.5, 1.5}), room_at(rooms, floor.map, {6.0, 6.0}));
}

/// Walls one cell thick, of which some cells were not hit: less than half, in no order.
void draw_dotted(PaintedFloor& floor, Cell from, Cell step, std::int32_t length) {
    std::uint32_t mixed = 7;
    for (std::int32_t k = 0; k < length; ++k) {
        mixed = mixed * 1'664'525U + 1'013'904'223U;
        const bool is_hit = (mixed >> 16U) % 3U != 0;
        floor.map.states.at({from.x + k * step.x, from.y + k * step.y}) =
            is_hit ? CellState::occupied : CellState::free;
    }
}

TEST(FieldWalls, DottedOnesSeparateRooms) {
    PaintedFloor floor(13.0, 12.0, CellState::unknown);
    floor.paint({1.0, 1.0}, {12.0, 11.0}, CellState::free);
    for (const std::int32_t x : {20, 239}) draw_dotted(floor, {x, 20}, {0, 1}, 200);
    for (const std::int32_t y : {20, 219}) draw_dotted(floor, {20, y}, {1, 0}, 220);
    draw_dotted(floor, {130, 20}, {0, 1}, 200);
    draw_dotted(floor, {20, 120}, {1, 0}, 220);
    floor.door({3.0, 5.9}, {3.9, 6.2});
    floor.door({9.0, 5.9}, {9.9, 6.2});
    floor.door({6.4, 8.0}, {6.7, 8.9});
    const Segmentation rooms = segment(floor.map);
    ASSERT_EQ(rooms.rooms.size(), 4U);
    EXPECT_NE(room_at(rooms, floor.map, {3.0, 3.0}), room_at(rooms, floor.map, {10.0, 3.0}));
    for (const Room& room : rooms.rooms) EXPECT_NEAR(room.area_m2, 27.5, 3.0);
}

TEST(FieldWalls, PostsThatNoRobotFitsBetweenAreAWall) {
    PaintedFloor floor(14.0, 8.0, CellState::unknown);
    floor.room({1.0, 1.0}, {13.0, 7.0});
    for (double y = 1.1; y < 6.95; y += 0.2) {
        if (y > 3.0 && y < 3.9) continue;
        floor.paint({7.0, y}, {7.1, y + 0.1}, CellState::occupied);
    }
    const Segmentation rooms = segment(floor.map);
    EXPECT_EQ(rooms.rooms.size(), 2U);
    EXPECT_NE(room_at(rooms, floor.map, {3.0, 6.0}), room_at(rooms, floor.map, {11.0, 6.0}));
}

TEST(FieldWalls, ACorridorOpenAtBothEndsIsNoPartOfTheHallsItJoins) {
    PaintedFloor floor(38.0, 10.0, CellState::unknown);
    floor.room({1.0, 1.0}, {9.0, 9.0});
    floor.room({29.0, 1.0}, {37.0, 9.0});
    floor.room({9.15, 4.0}, {28.85, 6.0});
    floor.door({8.9, 4.0}, {9.2, 6.0});
    floor.door({28.8, 4.0}, {29.1, 6.0});
    const Segmentation rooms = segment(floor.map);
    ASSERT_EQ(rooms.rooms.size(), 3U);
    EXPECT_NE(room_at(rooms, floor.map, {5.0, 5.0}), room_at(rooms, floor.map, {19.0, 5.0}));
    EXPECT_NE(room_at(rooms, floor.map, {33.0, 5.0}), room_at(rooms, floor.map, {19.0, 5.0}));
    const Room& corridor = rooms.rooms[room_at(rooms, floor.map, {19.0, 5.0}) - 1];
    EXPECT_EQ(corridor.kind, RoomKind::corridor);
    EXPECT_NEAR(corridor.area_m2, 40.0, 4.0);
}

TEST(FieldWalls, ALobbyThatACorridorEntersAtFullWidthIsARoom) {
    PaintedFloor floor(34.0, 13.0, CellState::unknown);
    floor.room({1.0, 1.0}, {11.0, 11.0});
    floor.room({11.15, 5.0}, {31.0, 7.0});
    floor.door({10.9, 5.0}, {11.2, 7.0});
    for (int k = 0; k < 4; ++k) {
        const double x = 11.15 + 5.0 * k;
        for (const double y : {1.0, 7.15}) {
            floor.room({x, y}, {x + 4.85, y + 3.85});
            floor.door({x + 2.0, y == 1.0 ? 4.8 : 6.95}, {x + 2.9, y == 1.0 ? 5.05 : 7.2});
        }
    }
    const Segmentation rooms = segment(floor.map);
    ASSERT_EQ(rooms.rooms.size(), 10U);
    EXPECT_NE(room_at(rooms, floor.map, {3.0, 3.0}), room_at(rooms, floor.map, {25.0, 6.0}));
    EXPECT_NEAR(rooms.rooms[room_at(rooms, floor.map, {3.0, 3.0}) - 1].area_m2, 100.0, 5.0);
}

}  // namespace
}  // namespace quadcut
