// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/no_rooms_in_map.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "tests/unit/segment/painted_floor.hpp"

// Small maps with one fault each that users report.

namespace quadcut {
namespace {

using test::flat;
using test::flat_with_fans;
using test::PaintedFloor;
using test::room_at;
using test::seen_as;

TEST(Field, FansOfRaysOutsideAreGlimpsesAndNoPartOfTheRooms) {
    const PaintedFloor floor = flat_with_fans();
    const Segmentation bare = segment(flat().map);
    const Segmentation rooms = segment(floor.map);
    ASSERT_EQ(bare.rooms.size(), 7U);
    ASSERT_EQ(seen_as(rooms, Seen::glimpse).size(), 5U);
    ASSERT_EQ(rooms.rooms.size(), 12U);
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(rooms.rooms[i].seen, Seen::whole) << i;
        EXPECT_EQ(rooms.rooms[i].name, bare.rooms[i].name);
        EXPECT_NEAR(rooms.rooms[i].area_m2, bare.rooms[i].area_m2, 0.5);
    }
    for (std::size_t i = 7; i < 12; ++i) {
        const Room& glimpse = rooms.rooms[i];
        EXPECT_EQ(glimpse.seen, Seen::glimpse) << i;
        EXPECT_EQ(glimpse.name, "glimpse " + std::to_string(i + 1));
        EXPECT_GT(glimpse.open_border, 0.9);
        EXPECT_EQ(room_at(rooms, floor.map, {3.5 + 2.2 * static_cast<double>(i - 7), 18.5}), i + 1);
    }
}

TEST(Field, WhereTheRobotStoodIsNoGlimpse) {
    const PaintedFloor floor = flat_with_fans();
    const std::vector<Point> way{{3.5, 10.0}, {3.5, 18.0}};
    const Segmentation rooms = segment(floor.map, {}, {}, way);
    EXPECT_EQ(seen_as(rooms, Seen::glimpse).size(), 4U);
    const std::size_t entered = room_at(rooms, floor.map, {3.5, 18.0});
    ASSERT_NE(entered, 0U);
    EXPECT_EQ(rooms.rooms[entered - 1].seen, Seen::partly);
}

TEST(Field, EveryRoomIsAUnionOfTheFinestRegionsAlsoWhereFansAreCutOff) {
    SegmentOptions options;
    options.with_hierarchy = true;
    const Segmentation rooms = segment(flat_with_fans().map, options);
    std::vector<std::size_t> room_of(65536, 0);
    for (std::size_t i = 0; i < rooms.labels.values.size(); ++i) {
        const std::size_t room = rooms.labels.values[i];
        const std::size_t region = rooms.hierarchy.finest.values[i];
        if (room == 0 || region == 0) continue;
        if (room_of[region] == 0) room_of[region] = room;
        ASSERT_EQ(room_of[region], room) << region;
        for (const HierarchyLevel& level : rooms.hierarchy.levels) {
            ASSERT_LE(region, level.region_of_finest.size());
        }
    }
    EXPECT_EQ(std::set<std::size_t>(room_of.begin(), room_of.end()).size(), rooms.rooms.size() + 1);
}

/// Four rooms of 5.8 x 4.8 m in the white of a page; doors between them, and the front door.
PaintedFloor plan() {
    PaintedFloor floor(20.0, 18.0, CellState::free);
    floor.is_ground_free = true;
    for (const double x : {4.0, 9.95}) {
        for (const double y : {4.0, 8.95}) floor.room({x, y}, {x + 5.8, y + 4.8});
    }
    floor.door({9.75, 5.5}, {10.0, 6.4});
    floor.door({9.75, 11.5}, {10.0, 12.4});
    floor.door({6.0, 8.75}, {6.9, 9.0});
    floor.door({6.0, 3.8}, {6.9, 4.05});
    return floor;
}

TEST(Field, GroundAroundABuildingIsOutsideThoughItsFrontDoorIsOpen) {
    const PaintedFloor floor = plan();
    const Segmentation rooms = segment(floor.map);
    EXPECT_EQ(rooms.rooms.size(), 4U);
    EXPECT_EQ(room_at(rooms, floor.map, {1.0, 1.0}), 0U);
    EXPECT_NE(room_at(rooms, floor.map, {6.0, 6.0}), 0U);
    EXPECT_EQ(seen_as(rooms, Seen::whole).size(), 4U);
}

TEST(Field, GroundAroundABuildingIsARoomWhereTheRobotWas) {
    const PaintedFloor floor = plan();
    const std::vector<Point> way{{6.0, 6.0}, {6.4, 4.0}, {6.0, 1.0}};
    const Segmentation rooms = segment(floor.map, {}, {}, way);
    EXPECT_EQ(rooms.rooms.size(), 5U);
    EXPECT_NE(room_at(rooms, floor.map, {1.0, 1.0}), 0U);
}

TEST(Field, GroundThatACrackLeadsToIsOutside) {
    PaintedFloor floor = plan();
    floor.paint({6.0, 3.8}, {6.8, 4.05}, CellState::occupied);
    const Segmentation rooms = segment(floor.map);
    EXPECT_EQ(rooms.rooms.size(), 4U);
    EXPECT_EQ(room_at(rooms, floor.map, {1.0, 1.0}), 0U);
}

TEST(Field, RoomsWhoseOuterWallsTheImageCutsOffAreNotOutside) {
    PaintedFloor floor(12.0, 12.0, CellState::free);
    floor.paint({5.95, 0.0}, {6.05, 12.0}, CellState::occupied);
    floor.paint({0.0, 5.95}, {12.0, 6.05}, CellState::occupied);
    for (const double at : {2.5, 8.5}) {
        floor.door({5.9, at}, {6.1, at + 0.9});
        floor.door({at, 5.9}, {at + 0.9, 6.1});
    }
    EXPECT_EQ(segment(floor.map).rooms.size(), 4U);
}

TEST(Field, AMeetingRoomWithATableIsNoCorridor) {
    PaintedFloor floor(16.0, 10.0, CellState::unknown);
    floor.room({1.0, 1.0}, {14.0, 3.0});
    floor.room({1.0, 3.15}, {8.0, 8.15});
    floor.door({2.0, 2.95}, {2.9, 3.2});
    floor.door({6.5, 2.95}, {7.4, 3.2});
    floor.paint({2.3, 4.8}, {6.7, 6.6}, CellState::occupied);
    const Segmentation rooms = segment(floor.map);
    ASSERT_EQ(rooms.rooms.size(), 2U);
    EXPECT_EQ(rooms.rooms[room_at(rooms, floor.map, {1.5, 7.5}) - 1].kind, RoomKind::room);
    EXPECT_EQ(rooms.rooms[room_at(rooms, floor.map, {10.0, 2.0}) - 1].kind, RoomKind::corridor);
}

TEST(Field, OneSmallRoomIsARoom) {
    PaintedFloor floor(4.0, 4.0, CellState::unknown);
    floor.room({1.0, 1.0}, {2.8, 2.8});
    const Segmentation rooms = segment(floor.map);
    ASSERT_EQ(rooms.rooms.size(), 1U);
    EXPECT_NEAR(rooms.rooms.front().area_m2, 3.24, 1e-6);
}

TEST(Field, ARoomTooSmallIsLeftOutForAReason) {
    PaintedFloor floor(4.0, 4.0, CellState::unknown);
    floor.room({1.0, 1.0}, {2.4, 2.4});
    EXPECT_TRUE(segment(floor.map).rooms.empty());
    const std::string why = io::why_no_rooms(floor.map, {});
    EXPECT_NE(why.find("1.96 m²"), std::string::npos) << why;
    EXPECT_NE(why.find("than 2 m²"), std::string::npos) << why;
}

}  // namespace
}  // namespace quadcut
