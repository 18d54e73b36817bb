// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/image.hpp"
#include "io/map_server.hpp"
#include "tests/e2e/labels.hpp"
#include "tests/e2e/program.hpp"
#include "tests/unit/io/image_file.hpp"

namespace quadcut::test {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> kSegmentFiles{"graph.json",     "report.json", "rooms.geojson",
                                             "rooms.png",      "rooms.svg",   "rooms.yaml",
                                             "rooms_color.png"};

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& [name, bytes] : files_below(folder)) names.push_back(name);
    return names;
}

/// Cuts the small office into folder/out.
Outcome segment_office(const Folder& folder, std::vector<std::string> more = {}) {
    folder.write("office.pgm", office_pgm());
    more.insert(more.begin(), {"segment", folder.write("office.yaml", yaml_for("office.pgm")), "-o",
                               folder / "out"});
    return run_quadcut(more);
}

TEST(SegmentFiles, AllOfTheContractAndNoOthers) {
    const Folder folder;
    const Outcome outcome = segment_office(folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(names_in(folder / "out"), kSegmentFiles);
    EXPECT_NE(outcome.out.find("4 rooms, 3 doors"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(folder / "out"), std::string::npos) << outcome.out;
}

TEST(SegmentFiles, LabelsPartitionTheFreeCellsIntoConnectedRooms) {
    const Folder folder;
    ASSERT_EQ(segment_office(folder).exit_code, 0);
    const io::MapFile map = io::read_map(folder / "office.yaml");
    const Labels labels = read_labels(folder / "out/rooms.png");
    ASSERT_EQ(labels.width, map.map.states.width);
    ASSERT_EQ(labels.height, map.map.states.height);
    // The office is one component: every free cell is kept.
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        ASSERT_EQ(labels.values[i] != 0, map.map.states.values[i] == CellState::free) << i;
    }
    EXPECT_EQ(num_parts_by_label(labels),
              (std::map<std::uint16_t, int>{{1, 1}, {2, 1}, {3, 1}, {4, 1}}));
}

TEST(SegmentFiles, FilesAgreeWithEachOther) {
    const Folder folder;
    ASSERT_EQ(segment_office(folder).exit_code, 0);
    const Json plan = Json::parse(read_bytes(folder / "out/rooms.geojson"));
    EXPECT_EQ(plan.at("type"), "FeatureCollection");
    EXPECT_EQ(plan.at("frame"), "map");
    EXPECT_TRUE(plan.contains("format_version"));
    int num_rooms = 0;
    int num_doors = 0;
    for (const Json& feature : plan.at("features")) {
        const std::string kind = feature.at("geometry").at("type");
        (kind == "LineString" ? num_doors : num_rooms) += 1;
        EXPECT_TRUE(feature.at("properties").contains("id"));
    }
    EXPECT_EQ(num_rooms, 4);
    EXPECT_EQ(num_doors, 3);

    const Json graph = Json::parse(read_bytes(folder / "out/graph.json"));
    EXPECT_TRUE(graph.contains("format_version"));
    EXPECT_EQ(graph.at("nodes").size(), 4U);
    EXPECT_EQ(graph.at("edges").size(), 3U);

    const std::string yaml = read_bytes(folder / "out/rooms.yaml");
    for (const std::string key :
         {"format_version:", "image: rooms.png", "resolution:", "origin:", "labels:"}) {
        EXPECT_NE(yaml.find(key), std::string::npos) << key;
    }
    const std::string svg = read_bytes(folder / "out/rooms.svg");
    EXPECT_NE(svg.find("<svg"), std::string::npos);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_GT(io::read_image(folder / "out/rooms_color.png").header.width, 0);
}

TEST(SegmentFiles, ReportSaysWhatWasDone) {
    const Folder folder;
    const Outcome outcome =
        segment_office(folder, {"--json", "--door-width", "3.5", "--set", "rooms.min_room=1.25"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json report = Json::parse(read_bytes(folder / "out/report.json"));
    EXPECT_TRUE(report.contains("format_version"));
    double sum_ms = 0.0;
    for (const std::string stage : {"read", "map", "graph", "eigen", "fuse", "doors", "write"}) {
        EXPECT_TRUE(report.at("stages_ms").contains(stage)) << stage;
    }
    for (const auto& [stage, ms] : report.at("stages_ms").items()) sum_ms += ms.get<double>();
    EXPECT_GT(sum_ms, 0.0);
    EXPECT_GT(report.at("stages_ms").at("fuse").get<double>(), 0.0);
    EXPECT_GT(report.at("stages_ms").at("eigen").get<double>(), 0.0);
    EXPECT_GT(report.at("num_leaves"), 0);
    EXPECT_GT(report.at("num_edges"), 0);
    EXPECT_EQ(report.at("options").at("door_width"), 3.5);
    EXPECT_EQ(report.at("options").at("rooms.min_room"), 1.25);

    const Json summary = Json::parse(outcome.out);
    EXPECT_EQ(summary.at("num_rooms"), 4);
    EXPECT_EQ(summary.at("num_doors"), 3);
    EXPECT_NEAR(summary.at("area_m2"), 2 * 2.8 * 3.2 + 3.2 * 3.2 + 9.6 * 1.6 + 3 * 0.8 * 0.4, 0.01);
}

TEST(SegmentFiles, HashTellsInputsApart) {
    const Folder folder;
    ASSERT_EQ(segment_office(folder).exit_code, 0);
    const std::string first = Json::parse(read_bytes(folder / "out/report.json")).dump();
    const Json before = Json::parse(first);
    std::string pgm = office_pgm();
    pgm.back() = 0;
    folder.write("office.pgm", pgm);
    ASSERT_EQ(run_quadcut({"segment", folder / "office.yaml", "-o", folder / "out"}).exit_code, 0);
    const Json after = Json::parse(read_bytes(folder / "out/report.json"));
    EXPECT_NE(before.at("input_hash"), after.at("input_hash"));
}

TEST(SegmentFiles, SecondRunReplacesTheFirst) {
    const Folder folder;
    ASSERT_EQ(segment_office(folder, {"--granularity", "0"}).exit_code, 0);
    ASSERT_EQ(segment_office(folder).exit_code, 0);
    EXPECT_EQ(names_in(folder / "out"), kSegmentFiles);
}

TEST(SegmentFiles, ResultIsAMapServerPair) {
    const Folder folder;
    ASSERT_EQ(segment_office(folder).exit_code, 0);
    const io::MapFile read_back = io::read_map(folder / "out/rooms.yaml");
    EXPECT_EQ(read_back.map.resolution_m, 0.05);
    EXPECT_EQ(read_back.map.map_from_image, (Pose{1.0, -2.0, 0.0}));
}

TEST(SegmentInputs, SuffixOrContentDecides) {
    const Folder folder;
    const std::string plain = folder.write("office", office_pgm());
    const std::string named = folder.write("office.pgm", office_pgm());
    EXPECT_EQ(run_quadcut({"segment", plain, "-o", folder / "a"}).exit_code, 0);
    EXPECT_EQ(run_quadcut({"segment", named, "-o", folder / "b"}).exit_code, 0);
    EXPECT_EQ(read_bytes(folder / "a/rooms.png"), read_bytes(folder / "b/rooms.png"));
}

TEST(SegmentInputs, ResolutionOfABareImage) {
    const Folder folder;
    const std::string map = folder.write("office.pgm", office_pgm());
    ASSERT_EQ(run_quadcut({"segment", map, "-o", folder / "out", "--resolution=0.04"}).exit_code,
              0);
    EXPECT_NE(read_bytes(folder / "out/rooms.yaml").find("resolution: 0.04"), std::string::npos);
}

TEST(SegmentInputs, NoFreeCellIsAnEmptyResult) {
    const Folder folder;
    const std::string map = folder.write("solid.pgm", drawn_pgm({"????", "?##?", "????"}, 10));
    const Outcome outcome = run_quadcut({"segment", map, "-o", folder / "out"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(names_in(folder / "out"), kSegmentFiles);
    EXPECT_NE(outcome.out.find("0 rooms, 0 doors"), std::string::npos) << outcome.out;
    const Labels labels = read_labels(folder / "out/rooms.png");
    EXPECT_EQ(std::count(labels.values.begin(), labels.values.end(), 0), 40 * 30);
    EXPECT_TRUE(Json::parse(read_bytes(folder / "out/rooms.geojson")).at("features").empty());
}

TEST(SegmentInputs, PresetPaperGivesAsManySubmapsAsAsked) {
    const Folder folder;
    ASSERT_EQ(segment_office(folder, {"--preset", "paper", "--submaps", "4"}).exit_code, 0);
    EXPECT_EQ(num_parts_by_label(read_labels(folder / "out/rooms.png")).size(), 4U);
}

TEST(SegmentInputs, WhatPlaysNoPartIsWarnedOf) {
    const Folder folder;
    const std::string far = folder.write("far.tum", "0 5000 5000 0 0 0 0 1\n");
    const Outcome outcome = segment_office(folder, {"--poses", far, "--set", "scan.max_range=10"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find("options of scans play no part for a map"), std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("none of the 1 poses lies in the map"), std::string::npos)
        << outcome.err;
}

TEST(SegmentInputs, EdgesAreCountedOnceAndLoopsNotAtAll) {
    const auto num_edges = [](const std::string& loops) {
        const Folder folder;
        EXPECT_EQ(segment_office(folder, {"--preset", "paper", "--submaps", "4", "--set",
                                          "paper.self_loops=" + loops})
                      .exit_code,
                  0);
        return Json::parse(read_bytes(folder / "out/report.json"))["num_edges"].get<int>();
    };
    EXPECT_EQ(num_edges("none"), num_edges("own_weight"));
}

TEST(SegmentInputs, QuietPrintsNothing) {
    const Folder folder;
    const Outcome outcome = segment_office(folder, {"--quiet"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
}

/// All files of a run, the numbers of fields that end in _ms aside.
std::map<std::string, std::string> files_without_times(const std::string& folder) {
    std::map<std::string, std::string> files = files_below(folder);
    Json report = Json::parse(files.at("report.json"));
    for (auto it = report.begin(); it != report.end();) {
        const std::string key = it.key();
        it = key.size() > 3 && key.substr(key.size() - 3) == "_ms" ? report.erase(it) : ++it;
    }
    files["report.json"] = report.dump();
    return files;
}

TEST(SegmentThreads, SameBytesOnOneAndThree) {
    const Folder folder;
    ASSERT_EQ(run_quadcut({"simulate", "-o", folder / "sim", "--rooms", "9"}).exit_code, 0);
    for (const std::string preset : {"rooms", "paper"}) {
        for (const std::string threads : {"1", "3"}) {
            std::filesystem::remove_all(folder / ("out" + threads));
            const Outcome outcome =
                run_quadcut({"segment", folder / "sim/map.yaml", "-o", folder / ("out" + threads),
                             "--preset", preset, "--threads", threads});
            ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        }
        EXPECT_EQ(files_without_times(folder / "out1"), files_without_times(folder / "out3"))
            << preset;
    }
}

}  // namespace
}  // namespace quadcut::test
