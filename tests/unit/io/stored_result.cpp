// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/stored_result.hpp"

#include <gtest/gtest.h>

#include "formats/registry.hpp"
#include "io/room_text.hpp"
#include "tests/unit/io/floor_drawing.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::ScratchFolder;

test::DrawnFloor two_rooms() {
    test::DrawnFloor floor = test::drawn_floor({"#######", "#aaabb#", "#aaabb#", "#######"}, 8);
    floor.segmentation.doors = {
        {RoomId{1}, RoomId{2}, {1.6, 0.4}, {1.6, 1.2}, 0.8, 2.1500001, 1.25, 0.75}};
    return floor;
}

/// A rooms.geojson with the properties of one door.
std::string geojson_with(const std::string& door) {
    return R"({"type": "FeatureCollection", "features": [{"properties": {"type": "room"}},
 {"properties": {"type": "door", )" +
           door + R"(}, "geometry": {"coordinates": [[0, 1], [2, 3]]}}]})";
}

TEST(StoredResult, IsWhatWasWritten) {
    const ScratchFolder folder;
    const test::DrawnFloor floor = two_rooms();
    RunInfo info;
    info.input = "home.yaml";
    formats::write_results(folder.path(), floor.map, floor.segmentation, info);
    const StoredResult stored = read_stored_result(folder.path());
    EXPECT_EQ(stored.rooms.labels.values, floor.segmentation.labels.values);
    ASSERT_EQ(stored.rooms.rooms.size(), 2U);
    EXPECT_NEAR(stored.rooms.rooms[1].centroid.x, floor.segmentation.rooms[1].centroid.x, 0.001);
    EXPECT_NEAR(stored.rooms.rooms[1].label_point.y, floor.segmentation.rooms[1].label_point.y,
                0.001);
    EXPECT_NEAR(stored.rooms.rooms[0].area_m2, floor.segmentation.rooms[0].area_m2, 1e-9);
    ASSERT_EQ(stored.rooms.doors.size(), 1U);
    EXPECT_EQ(reason_of(stored.rooms.doors[0]), reason_of(floor.segmentation.doors[0]));
    EXPECT_EQ(stored.rooms.doors[0].jamb_2, (Point{1.6, 1.2}));
    EXPECT_EQ(stored.input, "home.yaml");
    EXPECT_EQ(stored.colors.size(), 2U);
}

TEST(StoredResult, SaysWhichDoorIsNone) {
    const std::vector<Room> rooms = two_rooms().segmentation.rooms;
    const std::string good =
        R"("a": 1, "b": 2, "width_m": 1, "room_a_width_m": 1, "room_b_width_m": 1, "confidence": 1)";
    EXPECT_EQ(parse_doors(geojson_with(good), "x", rooms).size(), 1U);
    EXPECT_EQ(parse_doors(R"({"features": []})", "x", rooms).size(), 0U);
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"\"b\": 2", "\"b\": 3"},
             {"\"b\": 2", "\"b\": 1.5"},
             {"\"b\": 2", "\"b\": -1e300"},
             {"\"width_m\": 1", "\"width_m\": \"1\""},
             {"{\"coordinates\": [[0, 1], [2, 3]]}", "[[0, 1]]"},
             {"\"confidence\": 1", "\"other\": 1"}}) {
        std::string bad = geojson_with(good);
        bad.replace(bad.find(from), from.size(), to);
        const std::string message = error_of([&] { (void)parse_doors(bad, "x.geojson", rooms); });
        EXPECT_EQ(message.rfind("x.geojson: feature 2: ", 0), 0U) << to << ": " << message;
    }
    for (const std::string bad : {"", "[1]", "{\"features\": ["}) {
        const std::string message = error_of([&] { (void)parse_doors(bad, "x.geojson", rooms); });
        EXPECT_EQ(message.rfind("x.geojson: is no JSON", 0), 0U) << message;
    }
}

}  // namespace
}  // namespace quadcut::io
