// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/image.hpp"
#include "tests/e2e/labels.hpp"
#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// The value after `key` in the entry of room `id` in a rooms.yaml.
std::string entry_of(const std::string& yaml, int id, const std::string& key) {
    const std::size_t entry = yaml.find(", id: " + std::to_string(id) + ",");
    if (entry == std::string::npos) return "no room " + std::to_string(id);
    const std::size_t first = yaml.find(key + ": ", entry) + key.size() + 2;
    return yaml.substr(first, yaml.find_first_of(",}", first) - first);
}

void replace(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

Outcome segment(const Folder& folder, const Words& drawing, const std::string& out,
                const Words& more = {}, const std::string& origin = "[1.0, -2.0, 0.0]") {
    folder.write("office.pgm", drawn_pgm(drawing, 8));
    std::string yaml = yaml_for("office.pgm");
    replace(yaml, "[1.0, -2.0, 0.0]", origin);
    Words words{"segment", folder.write("office.yaml", yaml), "-o", folder / out};
    words.insert(words.end(), more.begin(), more.end());
    return run_quadcut(words);
}

/// Room 2 of the result in `name` gets a name and a colour by its user.
void edit(const Folder& folder, const std::string& name) {
    std::string yaml = read_bytes(folder / (name + "/rooms.yaml"));
    replace(yaml, "\"room 2\"", "\"Anna's office\"");
    replace(yaml, "color: \"" + entry_of(yaml, 2, "color").substr(1), "color: \"#123456\"");
    folder.write(name + "/rooms.yaml", yaml);
}

TEST(Previous, TheSameMapIsTheSameResult) {
    const Folder folder;
    ASSERT_EQ(segment(folder, office_drawing(), "a").exit_code, 0);
    const Outcome outcome = segment(folder, office_drawing(), "b", {"--previous", folder / "a"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("\n4 rooms kept\n"), std::string::npos) << outcome.out;
    auto before = files_below(folder / "a");
    auto after = files_below(folder / "b");
    before.erase("report.json");
    after.erase("report.json");
    EXPECT_EQ(before, after);
}

/// Reasons without how large rooms are.
Json without_areas(Json events) {
    for (Json& event : events.at("events")) {
        const std::string reason = event.at("reason");
        const std::size_t end = reason.find("m^2 ");
        if (end != std::string::npos) event["reason"] = reason.substr(end + 4);
    }
    return events;
}

TEST(Previous, NamesColoursAndIdsAreKeptInTheSameFolder) {
    const Folder folder;
    // Offices of 5.2 m.
    Words drawing = office_drawing();
    const std::string row = drawing[2];
    drawing.insert(drawing.begin() + 2, 5, row);
    ASSERT_EQ(segment(folder, drawing, "out").exit_code, 0);
    edit(folder, "out");
    // The map has grown to the left and downwards, and a wall with a door divides room 1.
    for (std::string& line : drawing) line.insert(0, "??");
    drawing.push_back(drawing[0]);
    drawing[8] = "???##  #####        #       #?";
    const Outcome outcome =
        segment(folder, drawing, "out", {"--previous", folder / "out"}, "[0.2, -2.4, 0.0]");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("\n4 rooms kept, 1 split (5 from 1)\n"), std::string::npos)
        << outcome.out;
    const std::string yaml = read_bytes(folder / "out/rooms.yaml");
    EXPECT_EQ(entry_of(yaml, 2, "name"), "\"Anna's office\"");
    EXPECT_EQ(entry_of(yaml, 2, "color"), "\"#123456\"");
    EXPECT_EQ(entry_of(yaml, 3, "name"), "\"room 3\"");
    EXPECT_EQ(entry_of(yaml, 5, "name"), "\"room 5\"");
    EXPECT_NE(yaml.find("\nnext_id: 6\n"), std::string::npos);
    const Labels labels = read_labels(folder / "out/rooms.png");
    const std::set<std::uint16_t> values(labels.values.begin(), labels.values.end());
    EXPECT_EQ(values, (std::set<std::uint16_t>{0, 1, 2, 3, 4, 5}));
    const Json events = Json::parse(read_bytes(folder / "out/report.json")).at("previous");
    EXPECT_EQ(without_areas(events), Json::parse(R"({"kept": 4, "events":
        [{"event": "split", "room": 5, "name": "room 5", "from": 1,
          "reason": "behind a door"}]})"));
}

TEST(Previous, AnImageThatHasGrownToTheLeftAndSaysNothingIsFoundAgain) {
    const Folder folder;
    ASSERT_EQ(segment(folder, office_drawing(), "a").exit_code, 0);
    Words drawing = office_drawing();
    for (std::string& row : drawing) row.insert(0, "????????");
    const Outcome outcome = segment(folder, drawing, "b", {"--previous", folder / "a"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("moved by 3.20, 0.00 m"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.out.find("\n4 rooms kept\n"), std::string::npos) << outcome.out;
}

TEST(Previous, MergedAndRetiredRoomsAreToldAndTheirIdsStayTaken) {
    const Folder folder;
    ASSERT_EQ(segment(folder, office_drawing(), "a").exit_code, 0);
    edit(folder, "a");
    // No wall between rooms 1 and 2, and room 3 is no more.
    Words drawing = office_drawing();
    for (std::size_t y = 2; y < 10; ++y) drawing[y] = "?#                ##########";
    drawing[10] = "?###  #######  #############";
    const Outcome merged = segment(folder, drawing, "b", {"--previous", folder / "a", "--json"});
    ASSERT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_EQ(Json::parse(merged.out).at("previous"), Json::parse(R"({"kept": 2, "events":
        [{"event": "merged", "room": 1, "name": "room 1", "into": 2,
          "reason": "nothing like a door is between them"},
         {"event": "retired", "room": 3, "name": "room 3",
          "reason": "its floor is no longer free"}]})"))
        << merged.out;
    const Outcome back = segment(folder, office_drawing(), "c", {"--previous", folder / "b"});
    EXPECT_NE(back.out.find("\n2 rooms kept, 1 born (6), 1 split (5 from 2)\n"), std::string::npos)
        << back.out;
}

TEST(Previous, QuietSaysNothing) {
    const Folder folder;
    ASSERT_EQ(segment(folder, office_drawing(), "a").exit_code, 0);
    const Outcome outcome =
        segment(folder, office_drawing(), "b", {"--previous", folder / "a", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST(Previous, AMapInAnotherFrameIsWarnedOf) {
    const Folder folder;
    ASSERT_EQ(segment(folder, office_drawing(), "a").exit_code, 0);
    const Outcome outcome =
        segment(folder, office_drawing(), "b", {"--previous", folder / "a"}, "[500.0, 0.0, 0.0]");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find("same map frame?"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.out.find("0 rooms kept, 4 born (5, 6, 7, 8), 4 retired (1, 2, 3, 4)"),
              std::string::npos)
        << outcome.out;
}

TEST(Previous, RoomsOfABuildingThatIsMappedAgain) {
    const Folder folder;
    ASSERT_EQ(run_quadcut({"simulate", "-o", folder / "sim", "--seed", "5"}).exit_code, 0);
    ASSERT_EQ(run_quadcut({"segment", folder / "sim/map.yaml", "-o", folder / "a"}).exit_code, 0);
    // The second time it is the map of the robot's log, which has another size and origin.
    const Outcome outcome = run_quadcut({"segment", folder / "sim/robot.log", "-o", folder / "b",
                                         "--previous", folder / "a", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json told = Json::parse(outcome.out);
    const int num_rooms = told.at("num_rooms");
    const int num_kept = told.at("previous").at("kept");
    EXPECT_GE(num_kept, num_rooms * 8 / 10);
    // A room that is kept is where it was.
    const auto points_of = [&](const std::string& name) {
        std::map<int, std::pair<double, double>> points;
        const Json graph = Json::parse(read_bytes(folder / (name + "/graph.json")));
        for (const Json& node : graph.at("nodes")) {
            points[node.at("id")] = {node.at("x"), node.at("y")};
        }
        return points;
    };
    const auto before = points_of("a");
    int num_near = 0;
    for (const auto& [id, point] : points_of("b")) {
        const auto old = before.find(id);
        if (old == before.end()) continue;
        const double away =
            std::hypot(point.first - old->second.first, point.second - old->second.second);
        if (away < 3.0) ++num_near;
    }
    EXPECT_GE(num_near, num_kept * 8 / 10);
}

TEST(Previous, DefectsAreRefused) {
    const Folder folder;
    ASSERT_EQ(segment(folder, office_drawing(), "good").exit_code, 0);
    const std::string yaml = read_bytes(folder / "good/rooms.yaml");
    const std::string png = read_bytes(folder / "good/rooms.png");
    const auto expect_refused = [&](const Words& words) {
        const Outcome outcome =
            segment(folder, office_drawing(), "out", {"--previous", folder / "bad"});
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        for (const std::string& word : words) {
            EXPECT_NE(outcome.err.find(word), std::string::npos) << word << ": " << outcome.err;
        }
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    };
    const auto expect_refused_with = [&](const std::string& from, const std::string& to,
                                         const Words& words) {
        std::string text = yaml;
        replace(text, from, to);
        folder.write("bad/rooms.yaml", text);
        expect_refused(words);
    };
    expect_refused({"bad", "no such folder"});
    folder.write("bad/rooms.yaml", yaml);
    expect_refused({"bad/rooms.png"});
    folder.write("bad/rooms.png", png.substr(0, png.size() / 2));
    expect_refused({"bad/rooms.png", "byte"});
    folder.write("bad/rooms.png", office_pgm());
    expect_refused({"bad/rooms.png"});
    folder.write("bad/rooms.png", png);
    expect_refused_with("value: 3,", "value: 7,", {"bad/rooms.png: row ", "column ", "found 3"});
    expect_refused_with("id: 3,", "id: 2,", {"bad/rooms.yaml: line ", "id: "});
    expect_refused_with("format_version: 1", "format_version: 9",
                        {"rooms.yaml: line ", "at most 1"});
    expect_refused_with("origin: [1.0,", "origin: [nan,", {"rooms.yaml: line ", "origin", "nan"});
    expect_refused_with("next_id: 5", "next_id: 2", {"rooms.yaml: line ", "next_id"});
    expect_refused_with("labels:", "labels: 3 #", {"rooms.yaml: line "});
    std::filesystem::remove(folder / "bad/rooms.yaml");
    expect_refused({"bad", "no rooms.yaml"});
}

}  // namespace
}  // namespace quadcut::test
