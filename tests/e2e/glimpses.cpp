// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/e2e/program.hpp"

// What was only glimpsed, in all that the program writes; and the small maps beside the repository.

namespace quadcut::test {
namespace {

/// Two rooms of 4 x 3 m, a door between them, and a crack of 0.1 m in the left one through which
/// the unknown was seen; squares of 0.1 m.
std::string rooms_with_fan() {
    std::vector<std::string> rows(50, std::string(93, '?'));
    for (std::size_t y = 0; y < 36; ++y) {
        for (std::size_t x = 20 - y / 4; x <= 20 + y / 4; ++x) rows[45 - y][x] = '.';
    }
    const std::string wall = "?" + std::string(91, '#') + "?";
    rows.push_back(wall);
    for (int y = 0; y < 30; ++y) {
        const char between = y > 10 && y < 20 ? '.' : '#';
        rows.push_back("?#" + std::string(44, '.') + between + std::string(44, '.') + "#?");
    }
    rows.push_back(wall);
    for (std::string& row : rows) row.resize(93, '?');
    for (std::size_t y = 46; y < 51; ++y) rows[y][20] = '.';
    return drawn_pgm(rows, 2);
}

std::size_t count_of(const std::string& text, const std::string& words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos;
         at = text.find(words, at + 1)) {
        ++count;
    }
    return count;
}

TEST(GlimpsesOfMaps, HaveALabelAndNoNumberAmongTheRooms) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", rooms_with_fan());
    const Outcome outcome = run_quadcut({"segment", map, "-o", folder / "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("2 rooms, 1 door, "), 0U) << outcome.out;
    EXPECT_NE(outcome.out.find("; 1 glimpse; "), std::string::npos) << outcome.out;
    const std::string legend = read_bytes(folder / "out/rooms.yaml");
    EXPECT_EQ(count_of(legend, "seen: whole, area_m2"), 2U) << legend;
    EXPECT_NE(legend.find("id: 3, name: \"glimpse 3\""), std::string::npos) << legend;
    EXPECT_NE(legend.find("seen: glimpse, open_border: 1"), std::string::npos) << legend;
    for (const char* const file : {"out/rooms.geojson", "out/graph.json"}) {
        const std::string json = read_bytes(folder / file);
        EXPECT_EQ(count_of(json, "\"seen\": \"whole\""), 2U) << file << json;
        EXPECT_EQ(count_of(json, "\"seen\": \"glimpse\", \"open_border\": 1"), 1U) << file;
    }
    const std::string report = read_bytes(folder / "out/report.json");
    EXPECT_NE(report.find("\"num_rooms\": 2"), std::string::npos);
    EXPECT_NE(report.find("\"num_glimpses\": 1"), std::string::npos);
    EXPECT_EQ(count_of(read_bytes(folder / "out/rooms.svg"), "glimpse 3"), 2U);
}

TEST(GlimpsesOfMaps, AreWrittenAgainAsTheyWereAndKeepTheirNames) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", rooms_with_fan());
    ASSERT_EQ(run_quadcut({"segment", map, "-o", folder / "out"}).exit_code, 0);
    const Outcome again = run_quadcut({"export", folder / "out", "-o", folder / "again"});
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(read_bytes(folder / "again/rooms.yaml"), read_bytes(folder / "out/rooms.yaml"));
    const Outcome next =
        run_quadcut({"segment", map, "--previous", folder / "out", "-o", folder / "next"});
    ASSERT_EQ(next.exit_code, 0) << next.err;
    EXPECT_EQ(read_bytes(folder / "next/rooms.yaml"), read_bytes(folder / "out/rooms.yaml"));
}

TEST(GlimpsesOfMaps, AWordThatIsNoneIsRefused) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", rooms_with_fan());
    ASSERT_EQ(run_quadcut({"segment", map, "-o", folder / "out"}).exit_code, 0);
    std::string legend = read_bytes(folder / "out/rooms.yaml");
    legend.replace(legend.find("seen: whole"), 11, "seen: halfw");
    folder.write("out/rooms.yaml", legend);
    const Outcome outcome = run_quadcut({"rooms", folder / "out"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("whole, partly or glimpse"), std::string::npos) << outcome.err;
}

/// What `segment` prints of a small map beside the repository; empty where it is not there.
std::string segment_field(const Folder& folder, const std::string& name) {
    const std::filesystem::path map = shared("data/field/" + name + ".yaml");
    if (!std::filesystem::exists(map)) return {};
    const Outcome outcome = run_quadcut({"segment", map.string(), "-o", folder / name});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out + outcome.err;
}

TEST(GlimpsesOfMaps, FieldMapsHaveTheRoomsThatTheyShouldHave) {
    const Folder folder;
    if (segment_field(folder, "window_fans").empty()) GTEST_SKIP() << "no shared folder";
    const auto begins_with = [&](const std::string& name, const std::string& words) {
        const std::string text = segment_field(folder, name);
        EXPECT_EQ(text.find(words), 0U) << name << ": " << text;
    };
    begins_with("cartographer_greys", "7 rooms, 6 doors, ");
    begins_with("nav2_saved_map", "7 rooms, 6 doors, ");
    begins_with("plan_white_outside", "4 rooms, ");
    begins_with("window_fans", "7 rooms, 6 doors, ");
    begins_with("one_small_room", "1 room, ");
    begins_with("cubicles", "2 rooms, 1 door, ");
    begins_with("dotted_walls", "4 rooms, ");
    begins_with("mullion_wall", "2 rooms, 1 door, ");
    begins_with("halls_long_corridor", "3 rooms, 2 doors, ");
    begins_with("lobby_corridor_offices", "10 rooms, 9 doors, ");
    begins_with("meeting_room_kind", "2 rooms, ");
    const std::string legend = read_bytes(folder / "meeting_room_kind/rooms.yaml");
    EXPECT_NE(legend.find("name: \"room 1\", kind: room"), std::string::npos) << legend;
}

}  // namespace
}  // namespace quadcut::test
