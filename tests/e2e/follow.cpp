// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

using Json = nlohmann::json;

TEST(FollowCommand, WritesALineAScanAndTheResultsOfSegment) {
    const Folder folder;
    ASSERT_EQ(
        run_quadcut({"simulate", "-o", folder / "sim", "--seed", "2", "--rooms", "6"}).exit_code,
        0);
    const Outcome outcome =
        run_quadcut({"follow", folder / "sim/robot.log", "-o", folder / "out", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    std::vector<std::string> names;
    for (const auto& [name, bytes] : files_below(folder / "out")) names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"graph.json", "map.pgm", "map.yaml", "report.json",
                                               "rooms.geojson", "rooms.png", "rooms.svg",
                                               "rooms.yaml", "rooms_color.png", "updates.jsonl"}));
    std::istringstream lines(read_bytes(folder / "out/updates.jsonl"));
    std::size_t num_lines = 0;
    Json last;
    for (std::string line; std::getline(lines, line); ++num_lines) {
        last = Json::parse(line);
        EXPECT_EQ(last.at("scan"), num_lines);
        for (const std::string key :
             {"integrate_ms", "segment_ms", "num_leaves", "nodes_touched", "nodes_rebuilt", "ps",
              "graph_nodes", "rooms", "relabelled_m2", "events"}) {
            EXPECT_TRUE(last.contains(key)) << key;
        }
    }
    EXPECT_GT(num_lines, 10U);
    EXPECT_EQ(last.at("rooms"), Json::parse(outcome.out).at("num_rooms"));
}

TEST(FollowCommand, WhatCannotBeFollowedIsBadInput) {
    const Folder folder;
    const Outcome missing = run_quadcut({"follow", folder / "no.log", "-o", folder / "out"});
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_NE(missing.err.find("no.log"), std::string::npos);
    const std::string log = folder.write("empty.log", "# nothing\n");
    EXPECT_EQ(run_quadcut({"follow", log, "-o", folder / "out"}).exit_code, 2);
    EXPECT_EQ(run_quadcut({"follow", log, "-o", folder / "out", "--speed", "-1"}).exit_code, 2);
}

}  // namespace
}  // namespace quadcut::test
