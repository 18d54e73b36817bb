// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/map/clearance.hpp"
#include "quadcut/rooms/describe.hpp"
#include "quadcut/rooms/doors.hpp"
#include "quadcut/rooms/regions.hpp"
#include "quadcut/segment/inside.hpp"
#include "tests/unit/rooms/drawing.hpp"
#include "tests/unit/rooms/plain_ground.hpp"

namespace quadcut {
namespace {

using test::as_drawing;
using test::drawn_labels;
using test::drawn_map;
using Rows = std::vector<std::string>;

TEST(Regions, DetachedPartsGoToTheNeighbourWithTheLongestBorder) {
    Raster<std::uint32_t> labels = drawn_labels({"aaaabb",  //
                                                 "aaaabb",  //
                                                 "cca.bb",  //
                                                 "cccabb"});
    connect_regions(labels);
    EXPECT_EQ(as_drawing(labels), (Rows{"aaaabb",  //
                                        "aaaabb",  //
                                        "cca.bb",  //
                                        "cccbbb"}));
}

TEST(Regions, DetachedPartsBesideEachOtherGoToOneThatIsConnected) {
    // The detached a touches only the detached b, which touches c.
    Raster<std::uint32_t> labels = drawn_labels({"aaa.bbb",  //
                                                 ".......",  //
                                                 "abccccc"});
    connect_regions(labels);
    EXPECT_EQ(as_drawing(labels), (Rows{"aaa.bbb",  //
                                        ".......",  //
                                        "ccccccc"}));
}

TEST(Regions, ADetachedPartWithoutNeighboursIsRemoved) {
    Raster<std::uint32_t> labels = drawn_labels({"aaa.a", "aaa..", "aaa.."});
    connect_regions(labels);
    EXPECT_EQ(as_drawing(labels), (Rows{"aaa..", "aaa..", "aaa.."}));
}

TEST(Regions, AnOutlinedBoxBelongsToItsRoom) {
    // One cell is 0.1 m: the outline is as thick as is let through.
    Raster<std::uint32_t> labels = drawn_labels({"aaaaaa",  //
                                                 "a....a",  //
                                                 "a....a",  //
                                                 "a....a",  //
                                                 "aaaaaa"});
    const Raster<CellState> states = drawn_map({"......",  //
                                                ".####.",  //
                                                ".#..#.",  //
                                                ".####.",  //
                                                "......"})
                                         .states;
    EXPECT_TRUE(adopt_pockets(labels, states, 0.1, 1.0).is_any);
    EXPECT_EQ(as_drawing(labels), (Rows{"aaaaaa",  //
                                        "a.aa.a",  //
                                        "aaaaaa",  //
                                        "a.aa.a",  //
                                        "aaaaaa"}));
}

TEST(Regions, APocketBehindAThickWallOrTooLargeStaysOut) {
    const Rows rows{"aaaaaaaa",  //
                    "a......a",  //
                    "a......a",  //
                    "a......a",  //
                    "a......a",  //
                    "a......a",  //
                    "aaaaaaaa"};
    Raster<std::uint32_t> labels = drawn_labels(rows);
    const Raster<CellState> states = drawn_map({"........",  //
                                                ".######.",  //
                                                ".######.",  //
                                                ".##..##.",  //
                                                ".######.",  //
                                                ".######.",  //
                                                "........"})
                                         .states;
    EXPECT_FALSE(adopt_pockets(labels, states, 0.1, 1.0).is_any);
    EXPECT_EQ(as_drawing(labels), rows) << "0.2 m of wall";
    EXPECT_FALSE(adopt_pockets(labels, states, 0.05, 0.0008).is_any);
    EXPECT_EQ(as_drawing(labels), rows) << "larger than a pocket may be";
    EXPECT_TRUE(adopt_pockets(labels, states, 0.05, 1.0).is_any);
    EXPECT_NE(as_drawing(labels), rows) << "thin at this resolution";
}

TEST(Regions, ACupboardThatWasTakenForARoomIsAdopted) {
    const Raster<CellState> states = drawn_map({"......",  //
                                                ".####.",  //
                                                ".#..#.",  //
                                                ".####.",  //
                                                "......"})
                                         .states;
    const Rows rows{"aaaaaa",  //
                    "a....a",  //
                    "a.bb.a",  //
                    "a....a",  //
                    "aaaaaa"};
    Raster<std::uint32_t> labels = drawn_labels(rows);
    EXPECT_FALSE(adopt_pockets(labels, states, 0.1, 0.2).is_any);
    EXPECT_EQ(as_drawing(labels), rows) << "two small rooms are no pockets of each other";
    EXPECT_TRUE(adopt_pockets(labels, states, 0.1, 0.1).is_any);
    EXPECT_EQ(as_drawing(labels), (Rows{"aaaaaa",  //
                                        "a.aa.a",  //
                                        "aaaaaa",  //
                                        "a.aa.a",  //
                                        "aaaaaa"}));
}

TEST(Regions, FurnitureAloneIsNoRoom) {
    Raster<std::uint32_t> labels = drawn_labels({"aabb", "aabb", "ccbb"});
    const Raster<CellState> states = drawn_map({"..#.", "..##", "####"}).states;
    drop_without_floor(labels, states);
    EXPECT_EQ(as_drawing(labels), (Rows{"aabb", "aabb", "..bb"}));
}

TEST(Regions, WhereNoRobotFitsIsNoRoom) {
    Raster<std::uint32_t> labels = drawn_labels({"aa.b", "aa.b"});
    Raster<float> clearance({0, 0}, 4, 2, 0.1F);
    clearance.at({1, 0}) = 0.3F;
    drop_impassable(labels, clearance, 0.5);
    EXPECT_EQ(as_drawing(labels), (Rows{"aa..", "aa.."}));
}

TEST(Doors, EveryOpeningBetweenTwoRoomsIsOne) {
    // Two rooms of 4 x 6 m; doors of 0.8 m and 1.2 m in the wall between.
    GridMap map;
    map.map_from_image = {10.0, 20.0, 0.0};
    map.states = Raster<CellState>({0, 0}, 170, 130, CellState::occupied);
    Raster<std::uint32_t> labels({0, 0}, 170, 130);
    const auto clear = [&](std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) {
        for (std::int32_t y = y0; y < y1; ++y) {
            for (std::int32_t x = x0; x < x1; ++x) {
                map.states.at({x, y}) = CellState::free;
                labels.at({x, y}) = x < 84 ? 1 : 2;
            }
        }
    };
    clear(3, 5, 83, 125);
    clear(87, 5, 167, 125);
    clear(83, 20, 87, 36);
    clear(83, 90, 87, 114);
    const Raster<float> clearance = clearance_m(mask_of(map, CellState::free), 0.05);
    const test::PlainGround plain(clearance, 0.05);
    const std::vector<Door> doors = find_doors(
        labels, 2, plain.ground(), {as_it_lies(labels.box()), 0.05, map.map_from_image}, 0.3);
    ASSERT_EQ(doors.size(), 2U);
    EXPECT_NEAR(doors[0].width_m, 0.8, 0.06);
    EXPECT_NEAR(doors[1].width_m, 1.2, 0.06);
    for (const Door& door : doors) {
        EXPECT_EQ(index(door.a), 1U);
        EXPECT_EQ(index(door.b), 2U);
        EXPECT_NEAR(door.jamb_1.x, 10.0 + 84 * 0.05, 0.15);
        EXPECT_NEAR(door.jamb_2.x, 10.0 + 84 * 0.05, 0.15);
        EXPECT_GT(door.confidence, 0.5);
    }
    EXPECT_NEAR(std::min(doors[0].jamb_1.y, doors[0].jamb_2.y), 20.0 + 1.0, 0.05);
    EXPECT_NEAR(std::max(doors[0].jamb_1.y, doors[0].jamb_2.y), 20.0 + 1.8, 0.05);
    EXPECT_EQ(
        find_doors(labels, 2, plain.ground(), {as_it_lies(labels.box()), 0.05, {}}, 1.0).size(), 1U)
        << "the narrow one is out";
}

TEST(Describe, ARoomHasAreaCentroidAndAFreeLabelPoint) {
    // A U: its centroid is outside of it.
    const GridMap drawing = drawn_map({"....####....", "....####....", "....####....",
                                       "............", "............", "............"},
                                      0.05, 10);
    GridMap map = drawing;
    map.map_from_image = {1.0, 2.0, std::acos(0.0)};
    Raster<std::uint32_t> labels({0, 0}, map.states.width, map.states.height);
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        labels.values[i] = map.states.values[i] == CellState::free ? 1 : 0;
    }
    const std::vector<Room> rooms = describe_rooms(labels, 1, map, as_it_lies(labels.box()), {});
    ASSERT_EQ(rooms.size(), 1U);
    EXPECT_NEAR(rooms[0].area_m2, 60 * 0.25, 1e-9);
    // The image is turned a quarter: its x axis points up in the map frame.
    EXPECT_NEAR(rooms[0].centroid.y, 2.0 + 3.0, 1e-9);
    const std::vector<Cell> at =
        visited_cells(map, std::vector<Point>{rooms[0].label_point, rooms[0].centroid});
    ASSERT_EQ(at.size(), 2U);
    EXPECT_EQ(labels.at(at[0]), 1U) << "a robot can stand at the label point";
    EXPECT_EQ(rooms[0].name, "room 1");
}

TEST(Describe, KindsFollowShapeAndDoors) {
    // A corridor of 16 x 2 m over a hall of 16 x 6 m and a room of 3 x 3 m.
    GridMap map;
    map.resolution_m = 0.1;
    map.states = Raster<CellState>({0, 0}, 170, 130, CellState::free);
    Raster<std::uint32_t> labels({0, 0}, 170, 130);
    const auto paint = [&](std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                           std::uint32_t label) {
        for (std::int32_t y = y0; y < y1; ++y) {
            for (std::int32_t x = x0; x < x1; ++x) labels.at({x, y}) = label;
        }
    };
    paint(2, 100, 162, 120, 1);
    paint(2, 36, 162, 96, 2);
    paint(2, 2, 32, 32, 3);
    Door door;
    door.a = RoomId{1};
    door.b = RoomId{2};
    const std::vector<Room> rooms =
        describe_rooms(labels, 3, map, as_it_lies(labels.box()), {door, door});
    EXPECT_EQ(rooms[0].kind, RoomKind::corridor);
    EXPECT_EQ(rooms[1].kind, RoomKind::hall);
    EXPECT_EQ(rooms[2].kind, RoomKind::room);
    EXPECT_EQ(rooms[0].name, "corridor 1");
    EXPECT_EQ(rooms[1].name, "hall 2");
}

}  // namespace
}  // namespace quadcut
