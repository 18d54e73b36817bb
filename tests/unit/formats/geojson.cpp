// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "formats/registry.hpp"
#include "tests/unit/io/floor_drawing.hpp"

namespace quadcut::formats {
namespace {

using nlohmann::json;

json geojson_of(const io::test::DrawnFloor& floor) {
    const io::RunInfo info;
    const Result result(floor.map, floor.segmentation, info);
    return json::parse(find_formats("geojson").front().write(result).front());
}

double signed_area(const json& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        twice += ring[i][0].get<double>() * ring[i + 1][1].get<double>() -
                 ring[i + 1][0].get<double>() * ring[i][1].get<double>();
    }
    return twice / 2.0;
}

TEST(GeoJson, SaysThatItIsInTheMapFrame) {
    const json file = geojson_of(io::test::drawn_floor({"ab"}));
    EXPECT_EQ(file["type"], "FeatureCollection");
    EXPECT_EQ(file["frame"], "map");
    EXPECT_EQ(file["format_version"], 1);
    EXPECT_EQ(file["features"].size(), 2U);
}

TEST(GeoJson, RoomsAreExactPolygons) {
    io::test::DrawnFloor floor = io::test::drawn_floor({"aaa", "a#a", "aaa"}, 1, 0.5);
    floor.map.map_from_image = {-10.0, 20.0, 0.0};
    floor.segmentation.rooms[0].name = "Caf\u00E9 \"1\"";
    const json room = geojson_of(floor)["features"][0];
    EXPECT_EQ(room["geometry"]["type"], "Polygon");
    const json expected = {{{-8.5, 20.0}, {-8.5, 21.5}, {-10.0, 21.5}, {-10.0, 20.0}, {-8.5, 20.0}},
                           {{-9.0, 21.0}, {-9.0, 20.5}, {-9.5, 20.5}, {-9.5, 21.0}, {-9.0, 21.0}}};
    EXPECT_EQ(room["geometry"]["coordinates"], expected);
    EXPECT_EQ(room["properties"]["id"], 1);
    EXPECT_EQ(room["properties"]["type"], "room");
    EXPECT_EQ(room["properties"]["kind"], "room");
    EXPECT_EQ(room["properties"]["name"], "Caf\u00E9 \"1\"");
    EXPECT_EQ(room["properties"]["area_m2"], 2.0);
    EXPECT_EQ(room["properties"]["perimeter_m"], 6.0);
    EXPECT_EQ(room["properties"]["neighbours"], json::array());
}

TEST(GeoJson, OuterRingsRunCounterClockwiseAndTheAreaIsThatOfTheCells) {
    io::test::DrawnFloor floor = io::test::drawn_floor(
        {"aaaabbbb", "a#aabbbb", "aaa#bb#b", "cccc.bbb", "cc.c#bbb"}, 3, 0.05);
    floor.map.map_from_image = {3.0, -4.0, 0.7};
    const json file = geojson_of(floor);
    for (std::size_t i = 0; i < 3; ++i) {
        const json& rings = file["features"][i]["geometry"]["coordinates"];
        double area = 0.0;
        for (std::size_t k = 0; k < rings.size(); ++k) {
            EXPECT_EQ(rings[k].front(), rings[k].back());
            EXPECT_EQ(signed_area(rings[k]) > 0.0, k == 0);
            area += signed_area(rings[k]);
        }
        EXPECT_NEAR(area, floor.segmentation.rooms[i].area_m2, 0.005);
    }
}

TEST(GeoJson, AYawTurnsTheRoomsAboutTheOrigin) {
    io::test::DrawnFloor floor = io::test::drawn_floor({"aa"}, 1, 1.0);
    floor.map.map_from_image = {5.0, 6.0, std::numbers::pi / 2.0};
    const json expected = {{{5.0, 8.0}, {4.0, 8.0}, {4.0, 6.0}, {5.0, 6.0}, {5.0, 8.0}}};
    EXPECT_EQ(geojson_of(floor)["features"][0]["geometry"]["coordinates"], expected);
}

TEST(GeoJson, ARoomInPartsIsAMultiPolygon) {
    const json room = geojson_of(io::test::drawn_floor({"a#a"}))["features"][0];
    EXPECT_EQ(room["geometry"]["type"], "MultiPolygon");
    EXPECT_EQ(room["geometry"]["coordinates"].size(), 2U);
    EXPECT_EQ(room["geometry"]["coordinates"][0][0].size(), 5U);
}

TEST(GeoJson, DoorsAreLinesAndMakeNeighbours) {
    io::test::DrawnFloor floor = io::test::drawn_floor({"aa#cc", "aabbb"}, 1, 1.0);
    floor.segmentation.doors.push_back(
        {RoomId{1}, RoomId{3}, {2.0, 1.0}, {3.0, 2.0}, std::sqrt(2.0), 3.5, 2.0, 0.75});
    const json file = geojson_of(floor);
    EXPECT_EQ(file["features"][0]["properties"]["neighbours"], (json{2, 3}));
    EXPECT_EQ(file["features"][1]["properties"]["neighbours"], (json{1, 3}));
    const json& door = file["features"][3];
    EXPECT_EQ(door["properties"]["type"], "door");
    EXPECT_EQ(door["properties"]["a"], 1);
    EXPECT_EQ(door["properties"]["b"], 3);
    EXPECT_EQ(door["properties"]["width_m"], 1.414);
    EXPECT_EQ(door["properties"]["confidence"], 0.75);
    EXPECT_EQ(door["properties"]["reason"], "1.41 m between rooms 3.5 m and 2.0 m wide");
    EXPECT_EQ(door["geometry"]["type"], "LineString");
    EXPECT_EQ(door["geometry"]["coordinates"], (json{{2.0, 1.0}, {3.0, 2.0}}));
}

TEST(GeoJson, FineMapsGetMoreDecimals) {
    const json room = geojson_of(io::test::drawn_floor({"aaa"}, 1, 0.0015))["features"][0];
    EXPECT_EQ(room["geometry"]["coordinates"][0][0], (json{0.0045, 0.0}));
}

TEST(GeoJson, ARoomWithoutCellsHasNoGeometry) {
    const json file = geojson_of(io::test::drawn_floor({"b"}));
    EXPECT_TRUE(file["features"][0]["geometry"].is_null());
}

TEST(GeoJson, OfNoRoomsIsAnEmptyCollection) {
    EXPECT_EQ(geojson_of(io::test::drawn_floor({"#."}))["features"], json::array());
}

}  // namespace
}  // namespace quadcut::formats
