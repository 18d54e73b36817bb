// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// A result of the office, in a folder `rooms`.
void cut_office(const Folder& folder) {
    folder.write("map.pgm", office_pgm());
    const std::string map = folder.write("home.yaml", yaml_for("map.pgm"));
    ASSERT_EQ(run_quadcut({"segment", map, "-o", folder / "rooms", "--quiet"}).exit_code, 0);
}

Json label_point(const std::string& folder, std::size_t room) {
    const Json rooms = Json::parse(run_quadcut({"rooms", folder, "--json"}).out)["rooms"];
    return rooms[room - 1];
}

std::string point_text(const Json& room) { return room["x"].dump() + "," + room["y"].dump(); }

TEST(Route, TakesPointsIdsAndNames) {
    const Folder folder;
    cut_office(folder);
    const Json from = label_point(folder / "rooms", 1);
    const Json to = label_point(folder / "rooms", 2);
    const Outcome by_id = run_quadcut({"route", folder / "rooms", "1", "2"});
    ASSERT_EQ(by_id.exit_code, 0) << by_id.err;
    EXPECT_THAT(by_id.out, HasSubstr(" m through "));
    EXPECT_THAT(by_id.out, HasSubstr("\n1 " + from["name"].get<std::string>() + "\n"));
    EXPECT_THAT(by_id.out, HasSubstr("\n2 " + to["name"].get<std::string>() + ", after "));
    EXPECT_THAT(by_id.out, HasSubstr(" m by door "));
    EXPECT_EQ(run_quadcut({"route", folder / "rooms", from["name"], to["name"]}).out, by_id.out);
    const Outcome by_point =
        run_quadcut({"route", folder / "rooms", point_text(from), point_text(to)});
    EXPECT_EQ(by_point.out, by_id.out);
    const Outcome below = run_quadcut({"route", folder / "rooms", "2.5,-0.8", "2"});
    EXPECT_EQ(below.exit_code, 0) << below.err;
    EXPECT_EQ(below.err, "");
}

TEST(Route, WritesGeoJsonAndJson) {
    const Folder folder;
    cut_office(folder);
    const Outcome plain = run_quadcut({"route", folder / "rooms", "1", "2", "--as", "json"});
    ASSERT_EQ(plain.exit_code, 0) << plain.err;
    const Json json = Json::parse(plain.out);
    const Json geojson =
        Json::parse(run_quadcut({"route", folder / "rooms", "1", "2", "--as", "geojson"}).out);
    ASSERT_EQ(geojson["features"].size(), 1U);
    const Json& feature = geojson["features"][0];
    EXPECT_EQ(feature["geometry"]["type"], "LineString");
    EXPECT_EQ(feature["geometry"]["coordinates"], json["points"]);
    EXPECT_EQ(feature["properties"]["rooms"], json["rooms"]);
    EXPECT_EQ(json["rooms"].front()["id"], 1);
    EXPECT_EQ(json["rooms"].back()["id"], 2);
    EXPECT_EQ(json["doors"].size() + 1, json["rooms"].size());
    EXPECT_EQ(json["doors"][0]["from"], 1);
    const Json from = label_point(folder / "rooms", 1);
    EXPECT_NEAR(json["points"].front()[0], from["x"], 0.06);
    EXPECT_NEAR(json["points"].front()[1], from["y"], 0.06);
    EXPECT_EQ(json["robot_width_m"], 0.4);
}

TEST(Route, TellsTheZonesWhereThereAreSome) {
    const Folder folder;
    folder.write("map.pgm", office_pgm());
    const std::string map = folder.write("home.yaml", yaml_for("map.pgm"));
    ASSERT_EQ(
        run_quadcut({"segment", map, "-o", folder / "rooms", "--zones", "2", "--quiet"}).exit_code,
        0);
    const Outcome text = run_quadcut({"route", folder / "rooms", "1", "2"});
    EXPECT_THAT(text.out, HasSubstr("\nzone "));
    const Json json =
        Json::parse(run_quadcut({"route", folder / "rooms", "1", "2", "--as", "json"}).out);
    for (const Json& room : json["rooms"]) EXPECT_GE(room["zone"], 1);
}

TEST(Route, SaysWhatIsWrongWithAnEnd) {
    const Folder folder;
    cut_office(folder);
    const auto refusal = [&](const std::vector<std::string>& words) {
        std::vector<std::string> all{"route", folder / "rooms"};
        all.insert(all.end(), words.begin(), words.end());
        const Outcome outcome = run_quadcut(all);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    };
    EXPECT_THAT(refusal({"room l", "2"}),
                HasSubstr("FROM: there is no room 'room l': did you mean"));
    EXPECT_THAT(refusal({"1", "Kitchen"}), HasSubstr("TO: there is no room 'Kitchen'"));
    EXPECT_THAT(refusal({"-90,-3.5", "2"}),
                HasSubstr("FROM: -90,-3.5 is in no room, but in a wall or outside; the nearest"));
    EXPECT_THAT(refusal({"1", "2", "--as", "svg"}),
                HasSubstr("--as: 'svg': expected text, geojson or json"));
    EXPECT_THAT(refusal({"1", "2", "--robot-width", "0"}), HasSubstr("more than 0"));
    EXPECT_THAT(refusal({"1", "2", "--robot-width", "9"}), HasSubstr("does not fit there"));
    EXPECT_EQ(run_quadcut({"route", folder / "none", "1", "2"}).exit_code, 2);
}

TEST(Route, SaysWhyThereIsNone) {
    const Folder folder;
    cut_office(folder);
    const Outcome outcome =
        run_quadcut({"route", folder / "rooms", "1", "2", "--robot-width", "1.2"});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, StartsWith("no way for a robot 1.20 m wide from 1 to 2: one of 0."));
    EXPECT_THAT(outcome.out, HasSubstr("the narrowest door on its way is "));
    for (const std::string form : {"json", "geojson"}) {
        const Outcome written = run_quadcut(
            {"route", folder / "rooms", "1", "2", "--robot-width", "1.2", "--as", form});
        EXPECT_EQ(written.exit_code, 1);
        EXPECT_EQ(Json::parse(written.out)["reason"].get<std::string>() + "\n", outcome.out);
    }
}

TEST(Route, FromWhereItIsHasNoLength) {
    const Folder folder;
    cut_office(folder);
    EXPECT_THAT(run_quadcut({"route", folder / "rooms", "1", "1"}).out,
                StartsWith("0.0 m through 1 room\n"));
}

TEST(Route, OfAProjectKnowsTheNamesThatPeopleGave) {
    const Folder folder;
    run_quadcut({"simulate", "-o", folder / "sim", "--seed", "2", "--rooms", "6"});
    const std::string project = folder / "p.quadcut";
    ASSERT_EQ(run_quadcut({"follow", folder / "sim/robot.log", "-o", folder / "out", "--project",
                           project, "--quiet"})
                  .exit_code,
              0);
    const Json rooms = Json::parse(run_quadcut({"rooms", project, "--json"}).out)["rooms"];
    ASSERT_GE(rooms.size(), 2U);
    const std::string first = rooms[0]["id"].dump();
    const std::string second = rooms[1]["id"].dump();
    ASSERT_EQ(run_quadcut({"edit", project, "rename", second, "Kitchen"}).exit_code, 0);
    const Outcome way = run_quadcut({"route", project, first, "Kitchen"});
    EXPECT_EQ(way.exit_code, 0) << way.err;
    EXPECT_THAT(way.out, HasSubstr("\n" + second + " Kitchen, after "));
    EXPECT_EQ(run_quadcut({"route", project, first, second}).out, way.out);
}

}  // namespace
}  // namespace quadcut::test
