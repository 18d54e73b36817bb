// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "quadcut/version.hpp"
#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

TEST(CommandLine, Version) {
    for (const std::string word : {"version", "--version"}) {
        const Outcome outcome = run_quadcut({word});
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_EQ(outcome.out, std::string("quadcut ") + kVersion + "\n");
    }
}

TEST(CommandLine, HelpListsWhatThereIs) {
    const Outcome outcome = run_quadcut({"help"});
    EXPECT_EQ(outcome.exit_code, 0);
    for (const std::string name :
         {"segment", "map", "follow", "locate", "route", "edit", "score", "rooms", "export",
          "simulate", "demo", "reproduce", "options", "version"}) {
        EXPECT_NE(outcome.out.find("\n  " + name + " "), std::string::npos) << name;
        const Outcome own = run_quadcut({name, "--help"});
        EXPECT_EQ(own.exit_code, 0);
        EXPECT_EQ(own.out.rfind("quadcut " + name, 0), 0U) << own.out;
        EXPECT_EQ(run_quadcut({"help", name}).out, own.out);
        EXPECT_EQ(run_quadcut({name, "-h"}).out, own.out);
    }
    EXPECT_EQ(outcome.out.find("\n  serve "), std::string::npos);
    EXPECT_EQ(run_quadcut({"help", "help"}).out, outcome.out);
    EXPECT_EQ(run_quadcut({"--help", "-h"}).out, outcome.out);
}

TEST(CommandLine, OptionsDocumentationIsUpToDate) {
    const Outcome outcome = run_quadcut({"options", "--markdown"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, read_bytes(std::string(QUADCUT_SOURCE_DIR) + "/docs/options.md"));
    EXPECT_NE(run_quadcut({"options"}).out.find("door_width"), std::string::npos);
}

TEST(CommandLine, OutputThatCannotBeWritten) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const Folder folder;
    const std::string script = folder.write(
        "run.sh", std::string("#!/bin/sh\nexec ") + QUADCUT_BINARY + " options >/dev/full\n");
    const Outcome outcome = run_process("/bin/sh", {script});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("standard output"), std::string::npos) << outcome.err;
}

TEST(Interrupted, AllFilesOrNone) {
    const Folder folder;
    ASSERT_EQ(run_quadcut({"simulate", "-o", folder / "sim", "--rooms", "9"}).exit_code, 0);
    const std::string map = folder / "sim/map.yaml";
    ASSERT_EQ(run_quadcut({"segment", map, "-o", folder / "whole"}).exit_code, 0);
    const std::size_t num_files = files_below(folder / "whole").size();
    for (int i = 0; i < 12; ++i) {
        const std::string out = folder / ("out" + std::to_string(i));
        const std::string seconds = std::to_string(0.02 * i);
        const Outcome outcome =
            run_process("/usr/bin/timeout", {"--signal=TERM", seconds.c_str(), QUADCUT_BINARY,
                                             "segment", map, "-o", out, "--quiet"});
        const std::size_t num_written = files_below(out).size();
        EXPECT_TRUE(num_written == 0 || num_written == num_files)
            << num_written << " files after " << seconds << " s";
        EXPECT_EQ(outcome.err, "");
    }
}

TEST(Simulate, SameSeedSameBytes) {
    const Folder folder;
    for (const std::string name : {"a", "b"}) {
        const Outcome outcome =
            run_quadcut({"simulate", "-o", folder / name, "--seed", "7", "--rooms", "6"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    const auto files = files_below(folder / "a");
    EXPECT_EQ(files, files_below(folder / "b"));
    for (const std::string name : {"map.pgm", "map.yaml"}) EXPECT_EQ(files.count(name), 1U) << name;
    ASSERT_EQ(
        run_quadcut({"simulate", "-o", folder / "c", "--seed", "8", "--rooms", "6"}).exit_code, 0);
    EXPECT_NE(files, files_below(folder / "c"));
}

TEST(Simulate, ClutterIsAsRobotsFindBuildings) {
    const Folder folder;
    const auto simulated = [&](const std::string& name, std::vector<std::string> more) {
        std::vector<std::string> words{"simulate", "-o", folder / name, "--seed", "7",
                                       "--rooms",  "6"};
        words.insert(words.end(), more.begin(), more.end());
        return run_quadcut(words);
    };
    ASSERT_EQ(simulated("plain", {}).exit_code, 0);
    ASSERT_EQ(simulated("none", {"--clutter", "0"}).exit_code, 0);
    ASSERT_EQ(simulated("full", {"--clutter", "1"}).exit_code, 0);
    ASSERT_EQ(simulated("again", {"--clutter", "1"}).exit_code, 0);
    EXPECT_EQ(files_below(folder / "plain"), files_below(folder / "none"));
    EXPECT_EQ(files_below(folder / "full"), files_below(folder / "again"));
    EXPECT_NE(files_below(folder / "full"), files_below(folder / "plain"));
    EXPECT_EQ(run_quadcut({"segment", folder / "full/robot.log", "-o", folder / "rooms"}).exit_code,
              0);
    EXPECT_EQ(simulated("more", {"--clutter", "2"}).exit_code, 2);
}

TEST(Demo, SaysInFiveLinesWhatItDid) {
    const Folder folder;
    const Outcome outcome = run_quadcut({"demo", "-o", folder / "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 5) << outcome.out;
    EXPECT_NE(outcome.out.find(folder / "out"), std::string::npos) << outcome.out;
    const auto files = files_below(folder / "out");
    for (const std::string name :
         {"map.pgm", "map.yaml", "rooms.png", "rooms_color.png", "rooms.svg", "score.json"}) {
        EXPECT_EQ(files.count(name), 1U) << name;
    }
    const auto score = nlohmann::json::parse(files.at("score.json"));
    EXPECT_GE(score.at("pq"), 0.6);
    EXPECT_GE(score.at("cover"), 0.95);
}

}  // namespace
}  // namespace quadcut::test
