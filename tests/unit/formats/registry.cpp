// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "formats/registry.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/authorship.hpp"
#include "io/image.hpp"
#include "io/map_server.hpp"
#include "io/map_writer.hpp"
#include "tests/unit/io/floor_drawing.hpp"
#include "tests/unit/io/image_file.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::formats {
namespace {

using io::test::ScratchFolder;
using nlohmann::json;

const std::vector<std::string> kFiles = {"graph.json", "report.json", "rooms.geojson",  "rooms.png",
                                         "rooms.svg",  "rooms.yaml",  "rooms_color.png"};

io::test::DrawnFloor two_rooms() {
    io::test::DrawnFloor floor =
        io::test::drawn_floor({"#######", "#aa#bb#", "#aaabb#", "#aa#bb#", "#######"}, 8);
    floor.map.map_from_image = {-1.5, 2.25, 0.125};
    floor.segmentation.doors.push_back({RoomId{1}, RoomId{2}, {-0.3, 3.0}, {-0.3, 3.4}, 0.4, 0.5});
    floor.segmentation.rooms[1].name = "B: \"caf\u00E9\" #2";
    floor.segmentation.report.stages_ms = {{"read", 1.5}, {"eigen", 2.0}};
    floor.segmentation.report.num_leaves = 42;
    floor.segmentation.report.eigen = {{7, {0.0, 0.25}, {1e-12, 2e-11}}};
    floor.segmentation.report.warnings = {"a warning"};
    return floor;
}

std::vector<std::string> sorted_names(const ScratchFolder& folder) {
    std::vector<std::string> names = folder.names();
    std::sort(names.begin(), names.end());
    return names;
}

/// A YAML file as JSON, by Python's reader; nothing when there is none.
std::optional<json> yaml_as_json(const ScratchFolder& scratch, const std::filesystem::path& path) {
    const std::string command = std::string(QUADCUT_PYTHON) +
                                " -c 'import json, sys, yaml; "
                                "print(json.dumps(yaml.safe_load(open(sys.argv[1], \"rb\"))))' " +
                                path.string() + " > " + (scratch.path() / "out.json").string() +
                                " 2> /dev/null";
    if (std::system(command.c_str()) != 0) return std::nullopt;
    return json::parse(io::read_file(scratch.path() / "out.json"));
}

TEST(Formats, EachWritesTheFilesThatItNames) {
    io::test::DrawnFloor floor = two_rooms();
    floor.segmentation.zones.count = 2;
    floor.segmentation.zones.zone_of_room = {1, 2};
    io::RunInfo info;
    info.poses = {{-1.0, 3.0, 0.0}};
    const Result result(floor.map, floor.segmentation, info, "{\"integrate_ms\": 1}\n");
    std::set<std::string> names;
    std::set<std::string> files;
    for (const Format& format : all_formats()) {
        EXPECT_TRUE(names.insert(std::string(format.name)).second) << format.name;
        EXPECT_FALSE(format.text.empty()) << format.name;
        const ScratchFolder folder;
        io::FileBatch batch(folder.path());
        add_files(batch, {format}, result);
        EXPECT_EQ(batch.names(), format.files) << format.name;
        batch.commit();
        for (const std::string& file : format.files) {
            EXPECT_TRUE(files.insert(file).second) << file;
            EXPECT_TRUE(io::is_own_file(folder.path() / file)) << file;
        }
    }
}

TEST(Formats, AreInTheDocumentation) {
    const std::string page = io::read_file(QUADCUT_SOURCE_DIR "/docs/formats.md");
    for (const Format& format : all_formats()) {
        std::string row = "| `" + std::string(format.name) + "` | ";
        for (const std::string& file : format.files) {
            row += (&file == &format.files.front() ? "`" : ", `") + file + "`";
        }
        EXPECT_NE(page.find(row + " | "), std::string::npos) << row;
    }
}

TEST(Formats, WriteTheSameAloneAndTogether) {
    const io::test::DrawnFloor floor = two_rooms();
    const io::RunInfo info;
    const ScratchFolder folder;
    write_results(folder.path(), floor.map, floor.segmentation, info);
    for (const Format& format : formats_of({Part::rooms})) {
        const Result result(floor.map, floor.segmentation, info);
        const std::vector<std::string> contents = format.write(result);
        ASSERT_EQ(contents.size(), format.files.size());
        for (std::size_t i = 0; i < contents.size(); ++i) {
            EXPECT_EQ(contents[i], io::read_file(folder.path() / format.files[i]));
        }
    }
}

TEST(Formats, AreFoundByTheirNames) {
    EXPECT_EQ(files_of(find_formats("svg")), std::vector<std::string>{"rooms.svg"});
    EXPECT_EQ(files_of(find_formats("labels,graph")),
              (std::vector<std::string>{"rooms.png", "rooms.yaml", "graph.json"}));
    EXPECT_EQ(files_of(find_formats("graph,graph")), std::vector<std::string>{"graph.json"});
    EXPECT_EQ(io::test::error_of([] { (void)find_formats("svg,geojsn"); }),
              "'geojsn' is no format, expected picture, svg, labels, geojson, graph, report, map, "
              "updates "
              "or g2o-submaps: did you mean 'geojson'?");
    EXPECT_NE(io::test::error_of([] { (void)find_formats("svg,"); }).find("'' is no format"),
              std::string::npos);
}

TEST(Results, AreAllThereAndNothingElse) {
    const ScratchFolder folder;
    const io::test::DrawnFloor floor = two_rooms();
    write_results(folder.path(), floor.map, floor.segmentation, {});
    EXPECT_EQ(sorted_names(folder), kFiles);
    for (const std::string& name : kFiles)
        EXPECT_TRUE(io::is_own_file(folder.path() / name)) << name;
}

TEST(Results, LabelsAreTheRoomsOfTheMapImage) {
    const ScratchFolder folder;
    const io::test::DrawnFloor floor = two_rooms();
    write_results(folder.path(), floor.map, floor.segmentation, {});
    const io::Image image = io::read_image(folder.path() / "rooms.png");
    EXPECT_EQ(image.header, (io::ImageHeader{56, 40, 1, 65535}));
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
        const Cell cell{static_cast<std::int32_t>(i % 56), 39 - static_cast<std::int32_t>(i / 56)};
        ASSERT_EQ(image.samples[i], floor.segmentation.labels.at(cell));
    }
}

TEST(Results, LegendIsYamlWithTheKeysOfTheMap) {
    const ScratchFolder folder;
    const io::test::DrawnFloor floor = two_rooms();
    io::RunInfo info;
    info.map_keys.negate = true;
    info.map_keys.occupied_thresh = 0.7;
    write_results(folder.path() / "out", floor.map, floor.segmentation, info);
    const auto keys =
        io::parse_map_yaml(io::read_file(folder.path() / "out" / "rooms.yaml"), "rooms.yaml");
    EXPECT_EQ(keys.image, "rooms.png");
    EXPECT_EQ(keys.resolution_m, 0.05);
    EXPECT_EQ(keys.map_from_image, floor.map.map_from_image);
    EXPECT_TRUE(keys.negate);
    EXPECT_EQ(keys.occupied_thresh, 0.7);
    const auto yaml = yaml_as_json(folder, folder.path() / "out" / "rooms.yaml");
    if (!yaml) GTEST_SKIP() << "no yaml module in " << QUADCUT_PYTHON;
    EXPECT_EQ((*yaml)["format_version"], 1);
    EXPECT_EQ((*yaml)["next_id"], 3);
    ASSERT_EQ((*yaml)["labels"].size(), 2U);
    const json& room = (*yaml)["labels"][1];
    EXPECT_EQ(room["value"], 2);
    EXPECT_EQ(room["id"], 2);
    EXPECT_EQ(room["name"], "B: \"caf\u00E9\" #2");
    EXPECT_EQ(room["kind"], "room");
    EXPECT_NEAR(room["area_m2"].get<double>(), floor.segmentation.rooms[1].area_m2, 1e-3);
    EXPECT_EQ(room["centroid"].size(), 2U);
    EXPECT_EQ(room["label_point"].size(), 2U);
    const std::string color = room["color"];
    EXPECT_NE(io::read_file(folder.path() / "out" / "rooms.svg").find("fill=\"" + color + "\""),
              std::string::npos);
}

TEST(Results, ReportTellsOfTheRun) {
    const ScratchFolder folder;
    const io::test::DrawnFloor floor = two_rooms();
    double door_width_m = 1.25;
    std::size_t num_threads = 3;
    std::uint8_t preset = 1;
    io::RunInfo info;
    info.version = "1.2.3";
    info.input = "maps/floor.yaml";
    info.input_hash = 0x0123456789abcdef;
    info.options = {{"door-width", "m", 0.0, 9.0, "", "", &door_width_m},
                    {"threads", "", 1.0, 99.0, "", "", &num_threads},
                    {"preset", "", 0.0, 0.0, "", "", Choice{&preset, {"rooms", "paper"}}}};
    write_results(folder.path(), floor.map, floor.segmentation, info);
    const json report = json::parse(io::read_file(folder.path() / "report.json"));
    EXPECT_EQ(report["format_version"], 2);
    EXPECT_EQ(report["version"], "1.2.3");
    EXPECT_EQ(report["input"], "maps/floor.yaml");
    EXPECT_EQ(report["input_hash"], "fnv1a64:0123456789abcdef");
    EXPECT_EQ(report["options"], (json{{"door-width", 1.25}, {"threads", 3}, {"preset", "paper"}}));
    EXPECT_EQ(report["num_rooms"], 2);
    EXPECT_EQ(report["num_doors"], 1);
    EXPECT_EQ(report["num_leaves"], 42);
    EXPECT_EQ(report["eigen"][0]["eigenvalues"], (json{0.0, 0.25}));
    EXPECT_EQ(report["eigen"][0]["residuals"], (json{1e-12, 2e-11}));
    EXPECT_EQ(report["warnings"], json{"a warning"});
    EXPECT_EQ(report["stages_ms"]["read"], 1.5);
    EXPECT_GT(report["stages_ms"]["write"], 0.0);
}

TEST(Results, GraphHasRoomsAndDoors) {
    const ScratchFolder folder;
    const io::test::DrawnFloor floor = two_rooms();
    write_results(folder.path(), floor.map, floor.segmentation, {});
    const json graph = json::parse(io::read_file(folder.path() / "graph.json"));
    EXPECT_EQ(graph["format_version"], 1);
    ASSERT_EQ(graph["nodes"].size(), 2U);
    EXPECT_EQ(graph["nodes"][0]["id"], 1);
    EXPECT_EQ(graph["nodes"][0]["name"], "Room 1");
    ASSERT_EQ(graph["edges"].size(), 1U);
    EXPECT_EQ(graph["edges"][0]["source"], 1);
    EXPECT_EQ(graph["edges"][0]["target"], 2);
    EXPECT_EQ(graph["edges"][0]["width_m"], 0.4);
    EXPECT_EQ(graph["edges"][0]["y"], 3.2);
}

TEST(Results, NameRoomsByTheirIds) {
    const ScratchFolder folder;
    io::test::DrawnFloor floor = two_rooms();
    floor.segmentation.rooms[1].id = RoomId{1000};
    floor.segmentation.doors[0].b = RoomId{1000};
    floor.segmentation.next_id = 2000;
    io::RunInfo info;
    info.previous_colors = {{RoomId{1000}, {1, 2, 3}}};
    info.events = {{RoomChange::kept, RoomId{1}, {}, "Room 1", ""},
                   {RoomChange::split, RoomId{1000}, RoomId{1}, "B", "a door"},
                   {RoomChange::merged, RoomId{7}, RoomId{1}, "G", "no door"}};
    write_results(folder.path(), floor.map, floor.segmentation, info);
    EXPECT_EQ(io::read_image(folder.path() / "rooms.png").row(20)[36], 1000);
    const std::string yaml = io::read_file(folder.path() / "rooms.yaml");
    EXPECT_NE(yaml.find("\nnext_id: 2000\n"), std::string::npos);
    EXPECT_NE(yaml.find("{value: 1000, id: 1000, "), std::string::npos);
    EXPECT_NE(yaml.find("color: \"#010203\""), std::string::npos);
    const json plan = json::parse(io::read_file(folder.path() / "rooms.geojson"));
    EXPECT_EQ(plan["features"][0]["properties"]["neighbours"], json{1000});
    EXPECT_EQ(plan["features"][1]["properties"]["neighbours"], json{1});
    EXPECT_EQ(plan["features"][1]["id"], "room-1000");
    EXPECT_EQ(plan["features"][2]["properties"]["b"], 1000);
    const json graph = json::parse(io::read_file(folder.path() / "graph.json"));
    EXPECT_EQ(graph["nodes"][1]["id"], 1000);
    EXPECT_EQ(graph["edges"][0]["target"], 1000);
    const std::string svg = io::read_file(folder.path() / "rooms.svg");
    EXPECT_NE(svg.find("id=\"room-1000\" fill=\"#010203\""), std::string::npos);
    EXPECT_NE(svg.find("Door between Room 1 and B: "), std::string::npos);
    const json previous = json::parse(io::read_file(folder.path() / "report.json"))["previous"];
    EXPECT_EQ(previous["kept"], 1);
    EXPECT_EQ(previous["events"],
              json::parse(R"([{"event": "split", "room": 1000, "name": "B", "from": 1,
                               "reason": "a door"},
                              {"event": "merged", "room": 7, "name": "G", "into": 1,
                               "reason": "no door"}])"));
}

TEST(Results, AreTheSameBytesForAnyNumberOfThreads) {
    const ScratchFolder folder;
    const io::test::DrawnFloor floor = two_rooms();
    io::RunInfo info;
    write_results(folder.path() / "one", floor.map, floor.segmentation, info);
    info.num_threads = 4;
    write_results(folder.path() / "four", floor.map, floor.segmentation, info);
    for (const std::string& name : kFiles) {
        std::string one = io::read_file(folder.path() / "one" / name);
        std::string four = io::read_file(folder.path() / "four" / name);
        if (name == "report.json") {
            one.resize(one.find("stages_ms"));
            four.resize(four.find("stages_ms"));
        }
        EXPECT_EQ(one, four) << name;
    }
}

TEST(Results, OfNoRoomsAreValid) {
    for (const std::vector<std::string>& rows :
         std::vector<std::vector<std::string>>{{"##", "##"}, {"  "}, {"."}}) {
        const ScratchFolder folder;
        const io::test::DrawnFloor floor = io::test::drawn_floor(rows);
        write_results(folder.path(), floor.map, floor.segmentation, {});
        EXPECT_EQ(sorted_names(folder), kFiles);
        for (const std::string& name : kFiles)
            EXPECT_TRUE(io::is_own_file(folder.path() / name)) << name;
        EXPECT_EQ(json::parse(io::read_file(folder.path() / "rooms.geojson"))["features"].size(),
                  0U);
        EXPECT_EQ(json::parse(io::read_file(folder.path() / "graph.json"))["nodes"].size(), 0U);
        EXPECT_NE(io::read_file(folder.path() / "rooms.yaml").find("labels: []"),
                  std::string::npos);
        EXPECT_EQ(io::read_image(folder.path() / "rooms.png").header.width, floor.map.states.width);
        EXPECT_GT(io::read_image(folder.path() / "rooms_color.png").header.width, 0);
    }
}

TEST(Results, TakeLabelsOfAnotherRectangle) {
    // The map begins at (-2, 5), its labels cover one column of it and more.
    const ScratchFolder folder;
    GridMap map;
    map.resolution_m = 1.0;
    map.states = Raster<CellState>({-2, 5}, 3, 2, CellState::free);
    Segmentation segmentation;
    segmentation.labels = Raster<std::uint16_t>({0, 4}, 2, 3, 1);
    segmentation.rooms = {{RoomId{1}, "x", RoomKind::hall, 2.0, {0.5, 6.0}, {0.5, 6.0}}};
    write_results(folder.path(), map, segmentation, {});
    EXPECT_EQ(io::read_image(folder.path() / "rooms.png").samples,
              (std::vector<std::uint16_t>{0, 0, 1, 0, 0, 1}));
    const auto keys = io::parse_map_yaml(io::read_file(folder.path() / "rooms.yaml"), "rooms.yaml");
    EXPECT_EQ(keys.map_from_image, (Pose{-2.0, 5.0, 0.0}));
    const json file = json::parse(io::read_file(folder.path() / "rooms.geojson"));
    EXPECT_EQ(file["features"][0]["geometry"]["coordinates"][0][0], (json{1, 5}));
}

TEST(Results, RefuseRoomsThatAreNotThere) {
    const ScratchFolder folder;
    io::test::DrawnFloor floor = two_rooms();
    floor.segmentation.doors[0].b = RoomId{3};
    EXPECT_THROW(write_results(folder.path(), floor.map, floor.segmentation, {}), std::logic_error);
    floor = two_rooms();
    floor.segmentation.rooms.pop_back();
    floor.segmentation.doors.clear();
    EXPECT_THROW(write_results(folder.path(), floor.map, floor.segmentation, {}), std::logic_error);
    floor = two_rooms();
    floor.segmentation.doors.clear();
    for (const std::uint32_t id : {0U, 1U, kMaxRoomId + 1}) {
        floor.segmentation.rooms[1].id = RoomId{id};
        EXPECT_THROW(write_results(folder.path(), floor.map, floor.segmentation, {}),
                     std::logic_error);
    }
    EXPECT_THROW(write_results(folder.path(), {}, {}, {}), std::logic_error);
    EXPECT_TRUE(folder.names().empty());
}

TEST(Results, KeepTheOldOnesWhenTheFolderIsAFile) {
    const ScratchFolder folder;
    const auto file = folder.write("out", "mine");
    const io::test::DrawnFloor floor = two_rooms();
    const std::string message =
        io::test::error_of([&] { write_results(file, floor.map, floor.segmentation, {}); });
    EXPECT_NE(message.find(file.string()), std::string::npos) << message;
    EXPECT_EQ(io::read_file(file), "mine");
}

TEST(Results, NameAFolderThatCannotBeMade) {
    if (!std::filesystem::exists("/proc/self")) GTEST_SKIP() << "no folder that nobody can write";
    const io::test::DrawnFloor floor = two_rooms();
    const std::string message = io::test::error_of(
        [&] { write_results("/proc/quadcut/out", floor.map, floor.segmentation, {}); });
    EXPECT_EQ(message.find("/proc/quadcut: "), 0U) << message;
}

TEST(Results, KeepTheOldOnesWhenOneCannotBeWritten) {
    const ScratchFolder folder;
    folder.write("rooms.png", io::kAuthorComment);
    folder.write("report.json/in the way", "x");
    const io::test::DrawnFloor floor = two_rooms();
    const std::string message = io::test::error_of(
        [&] { write_results(folder.path(), floor.map, floor.segmentation, {}); });
    EXPECT_NE(message.find("report.json"), std::string::npos) << message;
    EXPECT_EQ(sorted_names(folder), (std::vector<std::string>{"report.json", "rooms.png"}));
    EXPECT_EQ(io::read_file(folder.path() / "rooms.png"), io::kAuthorComment);
}

TEST(MapFiles, ReadBackAsTheSameMap) {
    const ScratchFolder folder;
    GridMap map = io::test::drawn_floor({"#. a", " ..#"}, 2, 0.07).map;
    map.map_from_image = {-12.3, 0.1, -0.7};
    io::FileBatch batch(folder.path());
    io::add_map(batch, map);
    batch.commit();
    EXPECT_EQ(sorted_names(folder), io::map_files());
    for (const std::string& name : io::map_files())
        EXPECT_TRUE(io::is_own_file(folder.path() / name));
    const io::MapFile read = io::read_map(folder.path() / "map.yaml");
    EXPECT_EQ(read.map.states.values, map.states.values);
    EXPECT_EQ(read.map.resolution_m, map.resolution_m);
    EXPECT_EQ(read.map.map_from_image, map.map_from_image);
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_EQ(read.keys.free_thresh, 0.196);
}

}  // namespace
}  // namespace quadcut::formats
