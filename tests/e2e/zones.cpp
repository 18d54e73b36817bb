// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/e2e/labels.hpp"
#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

using Json = nlohmann::json;

/// A simulated building in folder/sim; its rooms in folder/`name`.
Outcome segment_building(const Folder& folder, const std::string& name,
                         std::vector<std::string> more) {
    if (read_bytes(folder / "sim/map.yaml").empty()) {
        const Outcome made =
            run_quadcut({"simulate", "-o", folder / "sim", "--seed", "3", "--rooms", "24"});
        EXPECT_EQ(made.exit_code, 0) << made.err;
    }
    more.insert(more.begin(), {"segment", folder / "sim/map.yaml", "-o", folder / name, "--quiet"});
    return run_quadcut(more);
}

Json parsed(const std::string& path) { return Json::parse(read_bytes(path)); }

/// Zone by room id, as rooms.geojson tells it of rooms; as its zones tell it.
std::map<int, int> zone_of_rooms(const Json& geojson, const std::string& type) {
    std::map<int, int> zones;
    for (const Json& feature : geojson.at("features")) {
        const Json& properties = feature.at("properties");
        if (properties.at("type") != type) continue;
        const int id = properties.at("id").get<int>();
        if (type == "room") {
            zones[id] = properties.at("zone").get<int>();
        } else {
            for (const Json& room : properties.at("rooms")) zones[room.get<int>()] = id;
        }
    }
    return zones;
}

TEST(ZonesOfSegment, AreInAllFilesThatTellOfThem) {
    const Folder folder;
    ASSERT_EQ(segment_building(folder, "out", {"--zones", "3"}).exit_code, 0);
    const Json geojson = parsed(folder / "out/rooms.geojson");
    const std::map<int, int> zones = zone_of_rooms(geojson, "room");
    EXPECT_EQ(zones, zone_of_rooms(geojson, "zone"));
    std::set<int> used;
    for (const auto& [room, zone] : zones) used.insert(zone);
    EXPECT_EQ(used, (std::set<int>{1, 2, 3}));

    const Json graph = parsed(folder / "out/graph.json");
    for (const Json& node : graph.at("nodes")) {
        EXPECT_EQ(node.at("zone"), zones.at(node.at("id").get<int>()));
    }
    ASSERT_EQ(graph.at("zones").size(), 3U);
    for (const Json& zone : graph.at("zones")) {
        for (const Json& room : zone.at("rooms")) {
            EXPECT_EQ(zones.at(room.get<int>()), zone.at("id").get<int>());
        }
    }
    const Json report = parsed(folder / "out/report.json");
    EXPECT_EQ(report.at("zones").at("count"), 3);
    EXPECT_EQ(report.at("zones").at("weights"), "conductance");
    EXPECT_EQ(report.at("zones").at("eigenvalues"), graph.at("zone_eigenvalues"));
    EXPECT_EQ(report.at("zones").at("gaps").size() + 1,
              report.at("zones").at("eigenvalues").size());
    EXPECT_EQ(report.at("options").at("zones"), 3);
    const std::string svg = read_bytes(folder / "out/rooms.svg");
    EXPECT_NE(svg.find(">zone 3</text>"), std::string::npos);
    EXPECT_NE(svg.find(", zone 2</title>"), std::string::npos);
}

TEST(ZonesOfSegment, LeaveRoomsAsTheyAreAndNobodyHasThemWithoutAsking) {
    const Folder folder;
    ASSERT_EQ(segment_building(folder, "plain", {}).exit_code, 0);
    ASSERT_EQ(segment_building(folder, "zones", {"--zones", "auto"}).exit_code, 0);
    for (const std::string name : {"rooms.png", "rooms.yaml"}) {
        EXPECT_EQ(read_bytes(folder / ("plain/" + name)), read_bytes(folder / ("zones/" + name)));
    }
    for (const auto& [name, bytes] : files_below(folder / "plain")) {
        EXPECT_EQ(bytes.find("zone"), std::string::npos) << name;
    }
    EXPECT_EQ(parsed(folder / "zones/report.json").at("options").at("zones"), "auto");
}

TEST(ZonesOfSegment, AreKeptByExport) {
    const Folder folder;
    ASSERT_EQ(segment_building(folder, "out", {"--zones", "2"}).exit_code, 0);
    ASSERT_EQ(run_quadcut({"export", folder / "out", "-o", folder / "again"}).exit_code, 0);
    for (const std::string name : {"rooms.geojson", "graph.json"}) {
        EXPECT_EQ(read_bytes(folder / ("out/" + name)), read_bytes(folder / ("again/" + name)))
            << name;
    }
    EXPECT_NE(read_bytes(folder / "again/rooms.svg").find(", zone 2</title>"), std::string::npos);
}

TEST(ZonesOfSegment, ANumberOrAutoIsExpected) {
    const Folder folder;
    for (const std::string wrong : {"0", "-1", "some", "2.5", ""}) {
        const Outcome outcome = segment_building(folder, "out", {"--zones", wrong});
        EXPECT_EQ(outcome.exit_code, 2) << wrong;
        EXPECT_NE(outcome.err.find("zones"), std::string::npos) << outcome.err;
    }
    const Outcome mistyped = segment_building(folder, "out", {"--zones", "auot"});
    EXPECT_NE(mistyped.err.find("did you mean 'auto'"), std::string::npos) << mistyped.err;
}

TEST(ZonesOfFollow, AreThoseOfSegmentOnTheSameRooms) {
    const Folder folder;
    ASSERT_EQ(
        run_quadcut({"simulate", "-o", folder / "sim", "--seed", "2", "--rooms", "8"}).exit_code,
        0);
    const std::string log = folder / "sim/robot.log";
    ASSERT_EQ(run_quadcut({"follow", log, "-o", folder / "followed", "--zones", "2", "--project",
                           folder / "home.quadcut"})
                  .exit_code,
              0);
    const Json report = parsed(folder / "followed/report.json");
    EXPECT_EQ(report.at("zones").at("count"), 2);
    const Json geojson = parsed(folder / "followed/rooms.geojson");
    EXPECT_EQ(zone_of_rooms(geojson, "room"), zone_of_rooms(geojson, "zone"));
    // The project keeps the option: what is exported of it has the zones, too.
    ASSERT_EQ(run_quadcut({"export", folder / "home.quadcut", "-o", folder / "again"}).exit_code,
              0);
    EXPECT_EQ(read_bytes(folder / "followed/rooms.geojson"),
              read_bytes(folder / "again/rooms.geojson"));
}

TEST(SubmapsOfSegment, AreAsManyAsAskedInTheDefaultPresetAndAWarningSaysWhenNot) {
    const Folder folder;
    for (const std::string number : {"3", "30"}) {
        const Outcome outcome = segment_building(folder, "out", {"--submaps", number});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(std::to_string(num_parts_by_label(read_labels(folder / "out/rooms.png")).size()),
                  number);
    }
    const Outcome outcome = segment_building(folder, "out", {"--submaps", "1900"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find("asked for 1900 submaps, found "), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace quadcut::test
