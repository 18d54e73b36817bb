// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

/// Two rooms of 4.8 x 5.2 m with an opening between them, 0.4 m a character; the image's lower left
/// corner is at (1, -2), the opening in the middle of the wall at (6.2, 1.2).
Words two_rooms(int half_opening) {
    Words rows;
    for (int y = 0; y < 15; ++y) {
        std::string row(27, ' ');
        if (y == 0 || y == 14) row.assign(27, '#');
        row.front() = row.back() = '#';
        if (std::abs(y - 7) > half_opening) row[13] = '#';
        rows.push_back('?' + row + '?');
    }
    rows.insert(rows.begin(), std::string(29, '?'));
    rows.emplace_back(29, '?');
    return rows;
}

/// The middle of a column and row (from the bottom) of a drawing, in the map frame.
Words point(int column, int row) {
    return {std::to_string(1.0 + 0.4 * (column + 0.5)), std::to_string(-2.0 + 0.4 * (row + 0.5))};
}

void cut(const Folder& folder, const Words& drawing, const Words& more = {}) {
    folder.write("map.pgm", drawn_pgm(drawing, 8));
    Words words{"segment", folder.write("home.yaml", yaml_for("map.pgm")), "-o", folder / "rooms",
                "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run_quadcut(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
}

Outcome why(const Folder& folder, const Words& at, const Words& more = {}) {
    Words words{"why", folder / "rooms"};
    words.insert(words.end(), at.begin(), at.end());
    words.insert(words.end(), more.begin(), more.end());
    return run_quadcut(words);
}

TEST(Why, ADoorIsACut) {
    const Folder folder;
    cut(folder, two_rooms(1));
    const Outcome outcome = why(folder, point(14, 8));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, StartsWith("cut between 1 room 1 and 2 room 2: opening 1.1"));
    EXPECT_THAT(outcome.out, HasSubstr("wall in line on both sides"));
    EXPECT_THAT(outcome.out, AnyOf(HasSubstr("\nlike a door by 9"), HasSubstr("by 100 %;")));
    EXPECT_THAT(outcome.out, HasSubstr("granularity 0.5 asks for 65 %, and from 0."));
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 5);
}

TEST(Why, AWideMouthIsNone) {
    const Folder folder;
    cut(folder, two_rooms(4));
    const Outcome outcome = why(folder, point(14, 8));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, StartsWith("no cut: opening 3.5"));
    const Json json = Json::parse(why(folder, point(14, 8), {"--json"}).out);
    EXPECT_EQ(json["ground"], "room");
    EXPECT_EQ(json["border"]["verdict"], "no_door");
    EXPECT_LT(json["border"]["log_odds"], json["border"]["log_odds_needed"]);
    EXPECT_GT(json["border"]["granularity"], 0.5);
    EXPECT_EQ(json["border"]["sides"][0]["room"], json["border"]["sides"][1]["room"]);
    EXPECT_EQ(json["border"]["cues"][0].size(), 3U);
}

TEST(Why, TheGranularityThatWouldCutDoes) {
    const Folder folder;
    cut(folder, two_rooms(2));
    const Json before = Json::parse(why(folder, point(14, 8), {"--json"}).out)["border"];
    const double from = before["granularity"];
    ASSERT_GT(from, 0.02);
    ASSERT_LT(from, 0.98);
    for (const double step : {-0.01, 0.01}) {
        cut(folder, two_rooms(2), {"--force", "--granularity", std::to_string(from + step)});
        const Json border = Json::parse(why(folder, point(14, 8), {"--json"}).out)["border"];
        EXPECT_EQ(border["verdict"], step > 0.0 ? "cut" : "no_door") << from + step;
    }
}

TEST(Why, NothingProposesACutInTheMiddleOfARoom) {
    const Folder folder;
    cut(folder, two_rooms(1));
    const Outcome outcome = why(folder, point(7, 12));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, StartsWith("no cut: no place near here is narrower"));
    EXPECT_TRUE(Json::parse(why(folder, point(7, 12), {"--json"}).out)["border"].is_null());
}

TEST(Why, WhereNoRoomIsItSaysSo) {
    const Folder folder;
    cut(folder, two_rooms(1));
    EXPECT_EQ(why(folder, point(14, 2)).out, "no room: an obstacle is there\n");
    EXPECT_EQ(why(folder, point(0, 5)).out, "no room: what is there is unknown\n");
    const Outcome outside = why(folder, point(-3, 5));
    EXPECT_EQ(outside.out, "no room: the map does not reach there\n");
    EXPECT_EQ(outside.exit_code, 0);
}

TEST(Why, ToldOtherwiseByAnEarlierResultItWarns) {
    const Folder folder;
    cut(folder, two_rooms(1));
    // One room of both, as if people had merged them.
    Words one = two_rooms(6);
    cut(folder, one, {"--force"});
    folder.write("map.pgm", drawn_pgm(two_rooms(1), 8));
    const Outcome outcome = why(folder, point(14, 8));
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, StartsWith("cut between 1 "));
    EXPECT_THAT(outcome.err, HasSubstr("has changed since its rooms were cut"));
    EXPECT_THAT(outcome.err, HasSubstr("has it otherwise here"));
}

TEST(Why, OfThePresetPaperItSaysWhatToDo) {
    const Folder folder;
    cut(folder, two_rooms(1), {"--preset", "paper"});
    const Outcome outcome = why(folder, point(14, 8));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr("without --preset paper"));
}

TEST(Why, OfALogTellsTheSameInFolderAndProject) {
    const Folder folder;
    run_quadcut({"simulate", "-o", folder / "sim", "--seed", "2", "--rooms", "6"});
    ASSERT_EQ(run_quadcut({"follow", folder / "sim/robot.log", "-o", folder / "rooms", "--project",
                           folder / "p.quadcut", "--quiet"})
                  .exit_code,
              0);
    const Json features = Json::parse(read_bytes(folder / "rooms/rooms.geojson")).at("features");
    std::size_t num_doors = 0;
    for (const Json& feature : features) {
        if (feature.at("properties").at("type") != "door") continue;
        const Json& ends = feature.at("geometry").at("coordinates");
        Words at;
        for (const int axis : {0, 1}) {
            at.push_back(
                std::to_string((ends[0][axis].get<double>() + ends[1][axis].get<double>()) / 2.0));
        }
        const Outcome told = why(folder, at);
        EXPECT_THAT(told.out, StartsWith("cut between ")) << told.err;
        EXPECT_EQ(run_quadcut({"why", folder / "p.quadcut", at[0], at[1]}).out, told.out);
        ++num_doors;
    }
    EXPECT_GE(num_doors, 3U);
}

TEST(Why, AReportThatCannotBeIsNamed) {
    const Folder folder;
    cut(folder, two_rooms(1));
    std::string report = read_bytes(folder / "rooms/report.json");
    const std::string option = "\"granularity\": 0.5";
    ASSERT_NE(report.find(option), std::string::npos);
    report.replace(report.find(option), option.size(), "\"granularity\": 7");
    folder.write("rooms/report.json", report);
    const Outcome outcome = why(folder, point(14, 8));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("report.json: option granularity: '7': expected"));
}

TEST(Why, NeedsAResultAndAPoint) {
    const Folder folder;
    EXPECT_EQ(run_quadcut({"why", folder / "nothing", "1", "2"}).exit_code, 2);
    cut(folder, two_rooms(1));
    EXPECT_EQ(run_quadcut({"why", folder / "rooms", "1", "north"}).exit_code, 2);
    EXPECT_EQ(run_quadcut({"why", folder / "rooms", "1"}).exit_code, 2);
}

}  // namespace
}  // namespace quadcut::test
