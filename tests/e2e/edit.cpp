// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "project/project.hpp"
#include "quadcut/base/random.hpp"
#include "tests/e2e/program.hpp"
#include "tests/unit/follow/followed.hpp"

namespace quadcut::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

/// A project of two rooms: 1 on the left of x = 5 m, 2 on the right.
std::string two_rooms(const Folder& folder) {
    const std::string path = folder / "p.quadcut";
    Project project = Project::create(path, {});
    project.add(hall_with_wall());
    project.save();
    return path;
}

/// `quadcut edit` with a project.
class Editor {
public:
    explicit Editor(std::string project) : project_(std::move(project)) {}
    [[nodiscard]] Outcome operator()(std::vector<std::string> words) const {
        words.insert(words.begin(), {"edit", project_});
        return run_quadcut(words);
    }
    [[nodiscard]] std::string room_at(const std::string& x, const std::string& y) const {
        return run_quadcut({"locate", project_, x, y}).out;
    }

private:
    std::string project_;
};

TEST(EditCommand, UndoesRedoesAndListsWhatWasChanged) {
    const Folder folder;
    const Editor edit(two_rooms(folder));
    EXPECT_EQ(edit({"history"}).out, "no edits\n");
    EXPECT_THAT(edit({"rename", "1", " Kitchen "}).out,
                HasSubstr("room 1 is now called Kitchen\n"));
    EXPECT_THAT(edit({"merge", "Kitchen", "room 2"}).out, HasSubstr("quadcut export"));
    EXPECT_EQ(edit.room_at("9", "3"), "1 Kitchen\n");
    EXPECT_THAT(edit({"undo"}).out, HasSubstr("undone: merge room 2 into room 1\n"));
    EXPECT_EQ(edit.room_at("9", "3"), "2 room 2\n");
    EXPECT_THAT(edit({"undo"}).out, HasSubstr("undone: rename room 1 to Kitchen\n"));
    EXPECT_EQ(edit.room_at("2", "3"), "1 room 1\n");
    EXPECT_THAT(edit({"redo"}).out, HasSubstr("made again: rename room 1 to Kitchen\n"));
    EXPECT_EQ(edit({"history"}).out,
              "1  scan 0  rename room 1 to Kitchen\n"
              "2  scan 0  merge room 2 into room 1  (undone)\n");
    const Json history = Json::parse(edit({"history", "--json"}).out);
    ASSERT_EQ(history.size(), 2U);
    EXPECT_EQ(history[0].at("name"), "Kitchen");
    EXPECT_EQ(history[1].at("kind"), "merge");
    EXPECT_EQ(history[1].at("other"), 2);
    EXPECT_EQ(history[1].at("is_undone"), true);
    EXPECT_EQ(edit({"undo"}).exit_code, 0);
    const Outcome nothing = edit({"undo"});
    EXPECT_EQ(nothing.exit_code, 2);
    EXPECT_THAT(nothing.err, HasSubstr("nothing to undo"));
}

TEST(EditCommand, LocksAndUnlocks) {
    const Folder folder;
    const Editor edit(two_rooms(folder));
    EXPECT_EQ(edit({"lock", "room 1"}).exit_code, 0);
    EXPECT_THAT(edit({"lock", "1"}).err, HasSubstr("locked already"));
    EXPECT_EQ(edit({"merge", "1", "2"}).exit_code, 2);
    EXPECT_EQ(edit({"unlock", "1"}).exit_code, 0);
    EXPECT_THAT(edit({"unlock", "1"}).err, HasSubstr("not locked"));
    EXPECT_EQ(edit({"merge", "1", "2"}).exit_code, 0);
}

TEST(EditCommand, NamesRoomsByWhatIsDisplayed) {
    const Folder folder;
    const Editor edit(two_rooms(folder));
    EXPECT_THAT(edit({"rename", "room 2", "101"}).out, HasSubstr("room 2 is now called 101"));
    EXPECT_EQ(edit({"lock", "101"}).exit_code, 0);
    EXPECT_EQ(edit({"rename", "101", "1"}).exit_code, 0);
    const Outcome ambiguous = edit({"lock", "1"});
    EXPECT_EQ(ambiguous.exit_code, 2);
    EXPECT_THAT(ambiguous.err, HasSubstr("the id of one room and the name of room 2"));
    EXPECT_EQ(edit({"lock", "room 1"}).exit_code, 0);
    EXPECT_THAT(edit({"rename", "room 2", "x"}).err, HasSubstr("there is no room 'room 2'"))
        << "it is called 1";
    EXPECT_THAT(edit({"rename", "hall 1", "x"}).err, HasSubstr("there is no room 'hall 1'"))
        << "it is no hall";
    EXPECT_THAT(edit({"rename", "2", "room 1"}).err, HasSubstr("is the name of room 1"));
    EXPECT_THAT(edit({"rename", "2", "a\x80"}).err, HasSubstr("expected UTF-8"));
    EXPECT_EQ(edit({"rename", "2", " \t"}).exit_code, 2);
}

TEST(EditCommand, SaysWhatIsWrongWithWhatIsThere) {
    const Folder folder;
    EXPECT_THAT(run_quadcut({"edit", folder / "", "undo"}).err,
                HasSubstr("is a folder: expected a project file"));
    static_cast<void>(folder.write("rooms.yaml", "rooms: []"));
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"edit", folder / ""}, {"edit", folder / "", "rename", "1", "x"}}) {
        const Outcome outcome = run_quadcut(words);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, HasSubstr("is a folder of results"));
    }
    EXPECT_THAT(run_quadcut({"edit", folder / "none", "undo"}).err, HasSubstr("no such project"));
    EXPECT_THAT(run_quadcut({"edit", folder / "rooms.yaml", "undo"}).err,
                HasSubstr("is no project file"));
    const Editor edit(two_rooms(folder));
    EXPECT_THAT(edit({}).err, HasSubstr("expected an action"));
    EXPECT_THAT(edit({"paint"}).err, HasSubstr("'paint': expected rename, merge"));
    EXPECT_THAT(edit({"undo", "1"}).err, HasSubstr("expected nothing more"));
}

TEST(LocateCommand, OutsideOfRoomsItSaysTheNearest) {
    const Folder folder;
    const std::string project = two_rooms(folder);
    const auto locate = [&](const std::string& where, const std::string& x, const std::string& y) {
        return run_quadcut({"locate", where, x, y});
    };
    EXPECT_EQ(locate(project, "2", "3").exit_code, 0);
    // The right room ends at x = 12.5.
    const Outcome outside = locate(project, "14", "3");
    EXPECT_EQ(outside.exit_code, 1);
    EXPECT_EQ(outside.out, "no room; the nearest is 2 room 2, 1.50 m away\n");
    const Outcome json = run_quadcut({"locate", project, "2", "6", "--json"});
    EXPECT_EQ(json.exit_code, 1);
    EXPECT_EQ(Json::parse(json.out), Json::parse(R"({"room": 0, "name": "", "nearest":
                              {"room": 1, "name": "room 1", "distance_m": 0.5}})"));
    EXPECT_EQ(locate(project, "nan", "3").exit_code, 2);

    static_cast<void>(folder.write("map.pgm", office_pgm()));
    const std::string map = folder.write("map.yaml", yaml_for("map.pgm"));
    ASSERT_EQ(run_quadcut({"segment", map, "-o", folder / "out"}).exit_code, 0);
    EXPECT_EQ(locate(folder / "out", "-50", "0").exit_code, 1);
    EXPECT_THAT(locate(folder / "out", "-50", "0").out, HasSubstr("no room; the nearest is "));

    const std::string empty = folder / "empty.quadcut";
    static_cast<void>(Project::create(empty, {}));
    EXPECT_EQ(locate(empty, "0", "0").exit_code, 1);
    EXPECT_THAT(locate(empty, "0", "0").out, HasSubstr("there is none on the map"));
}

TEST(EditCommand, TellsTheRoomsAfterwardsAsJson) {
    const Folder folder;
    const Editor edit(two_rooms(folder));
    const Json merged = Json::parse(edit({"merge", "1", "2", "--json"}).out);
    EXPECT_EQ(merged.at("kind"), "merge");
    EXPECT_EQ(merged.at("other"), 2);
    ASSERT_EQ(merged.at("rooms").size(), 1U);
    EXPECT_EQ(merged.at("rooms")[0].at("id"), 1);
    EXPECT_TRUE(merged.at("doors").empty());
    EXPECT_EQ(Json::parse(edit({"undo", "--json"}).out).at("rooms").size(), 2U);
}

}  // namespace
}  // namespace quadcut::test
