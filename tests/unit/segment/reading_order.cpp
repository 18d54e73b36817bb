// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/reading_order.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/rooms/describe.hpp"
#include "tests/unit/rooms/drawing.hpp"

namespace quadcut {
namespace {

using test::as_drawing;
using test::drawn_labels;
using Rows = std::vector<std::string>;

/// The rooms of a drawing, a letter each, as segment() hands them to be numbered.
Segmentation rooms_of(const Rows& rows, GridMap& map) {
    Segmentation result;
    const Raster<std::uint32_t> labels = drawn_labels(rows);
    map.resolution_m = 1.0;
    map.states = Raster<CellState>({0, 0}, labels.width, labels.height, CellState::free);
    std::uint32_t count = 0;
    for (const std::uint32_t label : labels.values) count = std::max(count, label);
    result.labels = Raster<std::uint16_t>({0, 0}, labels.width, labels.height);
    std::copy(labels.values.begin(), labels.values.end(), result.labels.values.begin());
    result.rooms = describe_rooms(labels, count, map, as_it_lies(labels.box()), {});
    return result;
}

/// The letters of the rooms in the order of their numbers.
std::string order_of(const Rows& rows, const Pose& map_from_image = {}) {
    GridMap map;
    map.map_from_image = map_from_image;
    Segmentation result = rooms_of(rows, map);
    const Segmentation before = result;
    number_in_reading_order(result, map);
    std::string letters(result.rooms.size(), ' ');
    for (std::size_t i = 0; i < result.labels.values.size(); ++i) {
        if (result.labels.values[i] == 0) continue;
        letters[result.labels.values[i] - 1U] =
            static_cast<char>('a' + before.labels.values[i] - 1);
    }
    for (std::size_t i = 0; i < result.rooms.size(); ++i) {
        const auto was = static_cast<std::size_t>(letters[i] - 'a');
        EXPECT_EQ(index(result.rooms[i].id), i + 1);
        EXPECT_EQ(result.rooms[i].area_m2, before.rooms[was].area_m2);
        EXPECT_EQ(result.rooms[i].name, "room " + std::to_string(i + 1));
    }
    return letters;
}

TEST(ReadingOrder, RegionsAreNumberedByTheirFirstCellsHoweverTheyAreLaidOut) {
    Raster<std::uint32_t> labels = drawn_labels({"..e.c", "b.e.c"});
    EXPECT_EQ(number_by_first_cells(labels, as_it_lies(labels.box())), 3U);
    EXPECT_EQ(as_drawing(labels), (Rows{"..a.b", "c.a.b"}));
    Layout mirrored = as_it_lies(labels.box());
    mirrored.is_x_reversed = true;
    EXPECT_EQ(number_by_first_cells(labels, mirrored), 3U);
    EXPECT_EQ(as_drawing(labels), (Rows{"..b.a", "c.b.a"}));
}

const Rows kOffices{".....cccc.", "aaaa.cccc.", "aaaa.cccc.", "aaaa......", "..........",
                    ".......bb.", "dddd.eebb.", "dddd.ee...", "dddd.ee..."};

TEST(ReadingOrder, ARoomThatBeginsALittleHigherIsInTheRow) {
    EXPECT_EQ(order_of(kOffices), "acdeb");
}

TEST(ReadingOrder, IsThatOfThePageWhateverTheFrame) {
    EXPECT_EQ(order_of(kOffices, {30.0, -7.0, 2.0}), "acdeb");
}

TEST(ReadingOrder, ARoomAroundOthersIsReadWhereItsLabelIs) {
    // The middle of the ring lies in room b; the ring is thickest at its lower edge.
    EXPECT_EQ(order_of({"aaaaaaaaa", "a.......a", "a.bbb.c.a", "a.bbb.c.a", "a.bbb.c.a",
                        "a.......a", "aaaaaaaaa", "aaaaaaaaa", "aaaaaaaaa", "aaaaaaaaa"}),
              "bca");
}

TEST(ReadingOrder, DoorsGoWithTheirRooms) {
    GridMap map;
    Segmentation result = rooms_of({"..bb.aa", "..bb.aa", ".......", ".......", "cccc..."}, map);
    Door door;
    door.a = RoomId{1};
    door.b = RoomId{2};
    door.room_a_width_m = 1.0;
    door.room_b_width_m = 2.0;
    Door other = door;
    other.b = RoomId{3};
    result.doors = {door, other};
    number_in_reading_order(result, map);
    ASSERT_EQ(result.doors.size(), 2U);
    EXPECT_EQ(index(result.doors[0].a), 1U);
    EXPECT_EQ(index(result.doors[0].b), 2U);
    EXPECT_EQ(result.doors[0].room_a_width_m, 2.0) << "room b is the first now";
    EXPECT_EQ(index(result.doors[1].a), 2U);
    EXPECT_EQ(index(result.doors[1].b), 3U);
    EXPECT_EQ(result.doors[1].room_a_width_m, 1.0);
}

TEST(ReadingOrder, NoRoomsAreNoTrouble) {
    GridMap map;
    Segmentation result = rooms_of({"...", "..."}, map);
    number_in_reading_order(result, map);
    EXPECT_TRUE(result.rooms.empty());
}

}  // namespace
}  // namespace quadcut
