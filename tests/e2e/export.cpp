// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

Outcome expect_done(const std::vector<std::string>& arguments) {
    Outcome outcome = run_quadcut(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments[0] << ": " << outcome.err;
    return outcome;
}

void rename_room(const std::string& yaml, const std::string& from, const std::string& to) {
    std::string text = read_bytes(yaml);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << text;
    std::ofstream(yaml, std::ios::binary) << text.replace(at, from.size(), to);
}

TEST(Export, OfAFolderWritesItAgainWithTheNamesThatItHasNow) {
    const Folder folder;
    folder.write("maps/map.pgm", office_pgm());
    const std::string map = folder.write("maps/home.yaml", yaml_for("map.pgm"));
    expect_done({"segment", map, "-o", folder / "rooms"});
    expect_done({"export", folder / "rooms", "-o", folder / "again"});
    auto before = files_below(folder / "rooms");
    auto after = files_below(folder / "again");
    ASSERT_EQ(before.size(), after.size());
    for (const std::string name : {"rooms.png", "rooms.yaml", "rooms.geojson", "graph.json"}) {
        EXPECT_EQ(before[name], after[name]) << name;
    }
    EXPECT_EQ(before["report.json"], after["report.json"]);

    rename_room(folder / "rooms/rooms.yaml", "\"room 1\"", "\"Kitchen\"");
    expect_done({"export", folder / "rooms", "-o", folder / "rooms"});
    after = files_below(folder / "rooms");
    for (const std::string name : {"rooms.yaml", "rooms.geojson", "graph.json", "rooms.svg"}) {
        EXPECT_NE(after[name].find("Kitchen"), std::string::npos) << name;
    }
    EXPECT_NE(after["rooms_color.png"], before["rooms_color.png"]);
    EXPECT_EQ(after["rooms.png"], before["rooms.png"]);
}

TEST(Export, OfAFolderSaysWhenItsMapIsGone) {
    const Folder folder;
    const std::string map = folder.write("a.pgm", office_pgm());
    expect_done({"segment", map, "-o", folder / "rooms"});
    std::filesystem::rename(map, folder / "b.pgm");
    const Outcome gone = run_quadcut({"export", folder / "rooms", "-o", folder / "again"});
    EXPECT_EQ(gone.exit_code, 2);
    EXPECT_NE(gone.err.find("--map FILE"), std::string::npos) << gone.err;
    expect_done({"export", folder / "rooms", "-o", folder / "again", "--map", folder / "b.pgm"});
    folder.write("c.pgm", "P5\n2 1\n255\n\xFE\xFE");
    const Outcome other = run_quadcut(
        {"export", folder / "rooms", "-o", folder / "again", "--map", folder / "c.pgm"});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_NE(other.err.find("2 x 1 cells"), std::string::npos) << other.err;
}

TEST(Export, OfAProjectNeedsNoLog) {
    const Folder folder;
    expect_done({"simulate", "-o", folder / "sim", "--rooms", "4"});
    expect_done({"follow", folder / "sim/robot.log", "-o", folder / "followed", "--project",
                 folder / "home.quadcut"});
    std::filesystem::remove(folder / "sim/robot.log");
    expect_done({"export", folder / "home.quadcut", "-o", folder / "again"});
    auto before = files_below(folder / "followed");
    auto after = files_below(folder / "again");
    before.erase("report.json");
    EXPECT_EQ(after.erase("report.json"), 1U);
    EXPECT_EQ(before, after);
    const auto json =
        nlohmann::json::parse(expect_done({"rooms", folder / "home.quadcut", "--json"}).out);
    EXPECT_EQ(json.at("rooms").size(), json.at("num_rooms"));
    EXPECT_EQ(expect_done({"rooms", folder / "again"}).out,
              expect_done({"rooms", folder / "home.quadcut"}).out);
    expect_done({"edit", folder / "home.quadcut", "rename",
                 std::to_string(json.at("rooms")[0].at("id").get<int>()), "Kitchen"});
    expect_done({"export", folder / "home.quadcut", "-o", folder / "again"});
    EXPECT_NE(read_bytes(folder / "again/rooms.svg").find("Kitchen"), std::string::npos);
}

}  // namespace
}  // namespace quadcut::test
