// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_list.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/io/floor_drawing.hpp"

namespace quadcut::io {
namespace {

Segmentation three_rooms() {
    Segmentation rooms = test::drawn_floor({"aabbbbbbc"}, 4, 0.5).segmentation;
    rooms.rooms[0].name = "Caf\u00E9";
    rooms.rooms[1].kind = RoomKind::corridor;
    rooms.doors = {{RoomId{1}, RoomId{2}, {4.0, 0.0}, {4.0, 1.0}, 1.0},
                   {RoomId{2}, RoomId{3}, {16.0, 0.5}, {16.0, 1.5}, 1.0}};
    return rooms;
}

TEST(RoomTable, HasTheLargestFirstInAlignedColumns) {
    EXPECT_EQ(room_table(three_rooms()),
              "id  name    kind         area  doors\n"
              " 2  Room 2  corridor  24.0 m\u00B2      2\n"
              " 1  Caf\u00E9    room       8.0 m\u00B2      1\n"
              " 3  Room 3  room       4.0 m\u00B2      1\n");
}

TEST(RoomTable, LeavesOutTheEndOfLongNames) {
    Segmentation rooms = three_rooms();
    rooms.rooms[0].name = "\u00C4\u00C4\u00C4\u00C4\u00C4\u00C4\u00C4\u00C4";
    const std::string table = room_table(rooms, {20, 7});
    EXPECT_NE(table.find(" 1  \u00C4\u00C4\u00C4\u00C4...  room"), std::string::npos) << table;
}

TEST(RoomTable, CountsWhatItLeavesOut) {
    const std::string table = room_table(three_rooms(), {1});
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
    EXPECT_NE(table.find("and 2 smaller rooms\n"), std::string::npos) << table;
    EXPECT_EQ(room_table({}), "");
}

TEST(RoomList, AsJsonHasRoomsAndDoors) {
    JsonWriter writer;
    writer.begin_object();
    write_rooms_and_doors(writer, three_rooms());
    writer.end_object();
    const auto json = nlohmann::json::parse(writer.finish());
    EXPECT_EQ(json.at("num_rooms"), 3);
    EXPECT_EQ(json.at("num_doors"), 2);
    EXPECT_EQ(json.at("area_m2"), 36.0);
    EXPECT_EQ(json.at("rooms")[1].at("num_doors"), 2);
    EXPECT_EQ(json.at("rooms")[1].at("kind"), "corridor");
    EXPECT_EQ(json.at("rooms")[0].at("name"), "Caf\u00E9");
    EXPECT_EQ(json.at("doors")[1].at("a"), 2);
    EXPECT_EQ(json.at("doors")[1].at("y"), 1.0);
}

}  // namespace
}  // namespace quadcut::io
