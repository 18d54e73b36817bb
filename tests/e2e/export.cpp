// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/image.hpp"
#include "quadcut/base/geometry.hpp"
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

TEST(Export, WritesOnlyTheFormatsThatAreNamed) {
    const Folder folder;
    const std::string map = folder.write("a.pgm", office_pgm());
    expect_done({"segment", map, "-o", folder / "rooms"});
    auto before = files_below(folder / "rooms");
    const Outcome outcome =
        expect_done({"export", folder / "rooms", "-o", folder / "some", "--as", "geojson,labels"});
    EXPECT_NE(outcome.out.find("some: rooms.geojson rooms.png rooms.yaml\n"), std::string::npos)
        << outcome.out;
    auto after = files_below(folder / "some");
    ASSERT_EQ(after.size(), 3U);
    for (const auto& [name, bytes] : after) EXPECT_EQ(bytes, before[name]) << name;
    expect_done({"export", folder / "rooms", "-o", folder / "one", "--as", "report"});
    EXPECT_EQ(files_below(folder / "one"),
              (std::map<std::string, std::string>{{"report.json", before["report.json"]}}));
}

TEST(Export, RefusesFormatsThatAreNotThere) {
    const Folder folder;
    const std::string map = folder.write("a.pgm", office_pgm());
    expect_done({"segment", map, "-o", folder / "rooms"});
    const Outcome unknown =
        run_quadcut({"export", folder / "rooms", "-o", folder / "out", "--as", "svg,geojsn"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_NE(unknown.err.find("--as: 'geojsn' is no format, expected picture, svg, "),
              std::string::npos)
        << unknown.err;
    EXPECT_NE(unknown.err.find("did you mean 'geojson'?"), std::string::npos) << unknown.err;
    const Outcome missing =
        run_quadcut({"export", folder / "rooms", "-o", folder / "out", "--as", "updates"});
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_NE(missing.err.find("updates.jsonl: is not there to be exported"), std::string::npos)
        << missing.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    const std::string help = run_quadcut({"export", "--help"}).out;
    EXPECT_NE(help.find("labels (rooms.png,"), std::string::npos) << help;
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

/// A room of 5 x 4 m: its walls are drawn, and all else is transparent.
std::string walls_on_transparent_ground() {
    constexpr std::int32_t kWidth = 120;
    constexpr std::int32_t kHeight = 100;
    const auto fill_row = [](std::int32_t y, std::span<std::uint16_t> samples) {
        for (std::int32_t x = 0; x < kWidth; ++x) {
            const bool is_within = x >= 8 && x < 112 && y >= 8 && y < 92;
            const bool is_floor = x >= 10 && x < 110 && y >= 10 && y < 90;
            samples[static_cast<std::size_t>(2 * x)] = 0;
            samples[static_cast<std::size_t>(2 * x) + 1] = is_within && !is_floor ? 255 : 0;
        }
    };
    return io::encode_png({kWidth, kHeight, 2, 255}, fill_row);
}

TEST(Export, ReadsTheMapAsItWasReadWhenItWasCut) {
    const Folder folder;
    const std::string drawn = folder.write("drawn.png", walls_on_transparent_ground());
    const std::string image = folder.write("office.pgm", office_pgm());
    const std::vector<std::vector<std::string>> runs{
        {drawn}, {image, "--free-thresh", "0.3", "--occupied-thresh", "0.3"}, {image, "--negate"}};
    for (const std::vector<std::string>& run : runs) {
        std::vector<std::string> segment{"segment", "-o", folder / "rooms"};
        segment.insert(segment.end(), run.begin(), run.end());
        expect_done(segment);
        const Outcome outcome = expect_done({"export", folder / "rooms", "-o", folder / "again"});
        EXPECT_EQ(outcome.err, "");
        const std::string picture = read_bytes(folder / "rooms/rooms.svg");
        EXPECT_EQ(picture.substr(0, picture.find("<text")),
                  read_bytes(folder / "again/rooms.svg").substr(0, picture.find("<text")))
            << run.back();
    }
}

TEST(Export, WarnsWhenTheMapHasChanged) {
    const Folder folder;
    const std::string map = folder.write("a.pgm", office_pgm());
    expect_done({"segment", map, "-o", folder / "rooms"});
    // An older map of a log in the folder is not what was cut.
    folder.write("rooms/map.pgm", "P5\n2 1\n255\n\xFE\xFE");
    folder.write("rooms/map.yaml", yaml_for("map.pgm"));
    EXPECT_EQ(expect_done({"export", folder / "rooms", "-o", folder / "again"}).err, "");
    std::string bytes = office_pgm();
    bytes.back() = '\x01';
    folder.write("a.pgm", bytes);
    const Outcome changed = expect_done({"export", folder / "rooms", "-o", folder / "again"});
    EXPECT_NE(changed.err.find(map + ": has changed since"), std::string::npos) << changed.err;
}

TEST(Export, TakesTheMapOfALogAlong) {
    const Folder folder;
    expect_done({"simulate", "-o", folder / "sim", "--rooms", "4"});
    expect_done({"segment", folder / "sim/robot.log", "-o", folder / "rooms", "--hierarchy"});
    expect_done({"export", folder / "rooms", "-o", folder / "again"});
    expect_done({"export", folder / "again", "-o", folder / "again"});
    const auto before = files_below(folder / "rooms");
    auto after = files_below(folder / "again");
    EXPECT_EQ(before.size(), after.size());
    EXPECT_NE(before.at("rooms.geojson").find("region-"), std::string::npos);
    for (const std::string name : {"map.pgm", "map.yaml", "rooms.geojson", "report.json"}) {
        EXPECT_EQ(before.at(name), after[name]) << name;
    }
}

TEST(Export, SaysThatAMapCameThroughStandardInput) {
    const Folder folder;
    const std::string map = folder.write("a.pgm", office_pgm());
    const std::string line = "exec '" QUADCUT_BINARY "' segment - -o \"$0\" < \"$1\"";
    ASSERT_EQ(run_process("/bin/sh", {"-c", line, folder / "rooms", map}).exit_code, 0);
    const Outcome outcome = run_quadcut({"export", folder / "rooms", "-o", folder / "again"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("its map came through standard input: say where it is with --map"),
              std::string::npos)
        << outcome.err;
    expect_done({"export", folder / "rooms", "-o", folder / "again", "--map", map});
}

TEST(Export, SaysWhatIsThereInsteadOfAResult) {
    const Folder folder;
    expect_done({"segment", folder.write("a.pgm", office_pgm()), "-o", folder / "rooms"});
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"rooms"}, {"locate", "1", "1"}, {"export"}}) {
        const auto refusal_of = [&](const std::string& place) {
            std::vector<std::string> command = words;
            command.insert(command.begin() + 1, place);
            if (words[0] == "export") command.insert(command.end(), {"-o", folder / "again"});
            const Outcome outcome = run_quadcut(command);
            EXPECT_EQ(outcome.exit_code, 2);
            return outcome.err;
        };
        EXPECT_NE(refusal_of(folder / "none").find("of results or a project, found nothing"),
                  std::string::npos);
        EXPECT_NE(refusal_of(folder / "rooms/rooms.yaml")
                      .find("did you mean '" + (folder / "rooms") + "'"),
                  std::string::npos)
            << words[0];
    }
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

/// The poses of a g2o file, by number, and how many edges join one to the next.
struct PoseGraph {
    std::map<std::size_t, Pose> poses;
    std::size_t num_edges = 0;
};

PoseGraph read_pose_graph(const std::string& path) {
    PoseGraph graph;
    std::istringstream text(read_bytes(path));
    std::string tag;
    while (text >> tag) {
        std::size_t from = 0;
        std::size_t to = 0;
        Pose pose;
        if (tag == "VERTEX_SE2") {
            text >> from >> pose.x >> pose.y >> pose.yaw_rad;
            graph.poses[from] = pose;
            continue;
        }
        EXPECT_EQ(tag, "EDGE_SE2");
        text >> from >> to >> pose.x >> pose.y >> pose.yaw_rad;
        std::vector<double> information(6);
        for (double& value : information) text >> value;
        EXPECT_EQ(information, (std::vector<double>{1, 0, 0, 1, 0, 1}));
        EXPECT_EQ(to, from + 1);
        const Pose there = compose(graph.poses.at(from), pose);
        EXPECT_NEAR(there.x, graph.poses.at(to).x, 1e-9);
        EXPECT_NEAR(there.y, graph.poses.at(to).y, 1e-9);
        EXPECT_NEAR(std::remainder(there.yaw_rad - graph.poses.at(to).yaw_rad, 6.283185307179586),
                    0.0, 1e-9);
        ++graph.num_edges;
    }
    EXPECT_TRUE(text.eof());
    return graph;
}

std::map<std::size_t, std::uint32_t> read_zones(const std::string& path) {
    std::istringstream text(read_bytes(path));
    std::string comment;
    std::getline(text, comment);
    EXPECT_EQ(comment[0], '#');
    std::map<std::size_t, std::uint32_t> zones;
    std::size_t vertex = 0;
    std::uint32_t zone = 0;
    while (text >> vertex >> zone) zones[vertex] = zone;
    return zones;
}

void expect_pose_graph(const std::string& folder, std::uint32_t num_zones) {
    const PoseGraph graph = read_pose_graph(folder + "/submaps.g2o");
    ASSERT_GT(graph.poses.size(), 20U);
    EXPECT_EQ(graph.num_edges, graph.poses.size() - 1);
    std::set<std::uint32_t> used;
    const auto zones = read_zones(folder + "/submaps.zones");
    EXPECT_EQ(zones.size(), graph.poses.size());
    for (const auto& [vertex, zone] : zones) {
        EXPECT_TRUE(graph.poses.contains(vertex));
        EXPECT_GE(zone, 1U);
        EXPECT_LE(zone, num_zones);
        used.insert(zone);
    }
    EXPECT_GT(used.size(), 1U);
}

TEST(Export, PosesWithTheirZonesOfALogForASlamBackEnd) {
    const Folder folder;
    expect_done({"simulate", "-o", folder / "sim", "--seed", "2", "--rooms", "6"});
    const std::string log = folder / "sim/robot.log";
    expect_done({"segment", log, "-o", folder / "rooms", "--set", "zones=3", "--quiet"});
    expect_done({"export", folder / "rooms", "-o", folder / "rooms", "--as", "g2o-submaps"});
    expect_pose_graph(folder / "rooms", 3);
    // The poses as they are read again, and by way of a file beside the log.
    const PoseGraph graph = read_pose_graph(folder / "rooms/submaps.g2o");
    expect_done({"export", folder / "rooms", "-o", folder / "again", "--as", "g2o-submaps",
                 "--poses", folder / "rooms/submaps.g2o"});
    const PoseGraph again = read_pose_graph(folder / "again/submaps.g2o");
    ASSERT_EQ(again.poses.size(), graph.poses.size());
    for (const auto& [vertex, pose] : graph.poses) {
        EXPECT_NEAR(again.poses.at(vertex).x, pose.x, 1e-9);
        EXPECT_NEAR(again.poses.at(vertex).yaw_rad, pose.yaw_rad, 1e-9);
    }
    expect_done({"export", folder / "rooms", "-o", folder / "rooms", "--as", "g2o-submaps"});

    const auto report = nlohmann::json::parse(read_bytes(folder / "rooms/report.json"));
    const auto& zones = report.at("independence").at("zones");
    EXPECT_EQ(zones.at("num_parts"), 3);
    EXPECT_EQ(zones.at("num_pairs"), 3);
    EXPECT_GT(zones.at("seen_outside"), 0.0);
    EXPECT_LT(zones.at("seen_outside"), report.at("independence").at("rooms").at("seen_outside"));
    EXPECT_GE(zones.at("num_independent_given_doors"), zones.at("num_independent"));
    ASSERT_FALSE(zones.at("pairs").empty());
    for (const auto& pair : zones.at("pairs")) {
        EXPECT_LE(pair.at("given_doors").at("both"), pair.at("all").at("both"));
    }
}

TEST(Export, PosesOfAProjectAreItsOwn) {
    const Folder folder;
    expect_done({"simulate", "-o", folder / "sim", "--seed", "2", "--rooms", "6"});
    const std::string project = folder / "p.quadcut";
    expect_done({"follow", folder / "sim/robot.log", "-o", folder / "out", "--project", project,
                 "--set", "zones=3", "--set", "zones.weights=covisibility", "--quiet"});
    const auto report = nlohmann::json::parse(read_bytes(folder / "out/report.json"));
    EXPECT_EQ(report.at("independence").at("zones").at("num_parts"), 3);
    std::filesystem::remove(folder / "sim/robot.log");
    expect_done({"export", project, "-o", folder / "graph", "--as", "g2o-submaps"});
    expect_pose_graph(folder / "graph", 3);
}

TEST(Export, PosesWithoutZonesOrPosesSayTheWayOut) {
    const Folder folder;
    const std::string map = folder.write("a.pgm", office_pgm());
    const auto export_poses = [&](const std::string& from) {
        return run_quadcut({"export", folder / from, "-o", folder / "out", "--as", "g2o-submaps"});
    };
    expect_done({"segment", map, "-o", folder / "plain"});
    Outcome outcome = export_poses("plain");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("plain: its rooms are in no zones"), std::string::npos);
    EXPECT_NE(outcome.err.find("--zones auto"), std::string::npos);
    expect_done({"segment", map, "-o", folder / "zoned", "--set", "zones=2"});
    outcome = export_poses("zoned");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("give the poses of its scans with --poses FILE"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    const std::string poses = folder.write("poses.txt", "0 1 1 0 0 0 0 1\n1 3 1 0 0 0 0 1\n");
    expect_done({"export", folder / "zoned", "-o", folder / "out", "--as", "g2o-submaps", "--poses",
                 poses});
    EXPECT_EQ(read_pose_graph(folder / "out/submaps.g2o").poses.size(), 2U);
}

}  // namespace
}  // namespace quadcut::test
