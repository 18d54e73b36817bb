// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/e2e/program.hpp"
#include "tests/unit/io/gzip.hpp"

// Where inputs come from, and what kind they are.

namespace quadcut::test {
namespace {

using namespace std::string_literals;

/// Runs a line of bash, in which $Q is quadcut and the folder is the working one.
Outcome run_line(const Folder& folder, const std::string& line) {
    return run_process(
        "/bin/bash", {"-c", "cd '" + (folder / "") + "' && Q='" + QUADCUT_BINARY + "' && " + line});
}

/// A robot that turns in a room of 4 x 4 m.
std::string log_text() {
    std::string log;
    for (int i = 0; i < 8; ++i) {
        log += "FLASER 8";
        for (int beam = 0; beam < 8; ++beam) log += " 2.0";
        const std::string yaw = std::to_string(0.7 * i);
        log += " 0 0 " + yaw + " 0 0 " + yaw + " " + std::to_string(i) + " host 0\n";
    }
    return log;
}

/// The results, the times and the input's name aside.
std::map<std::string, std::string> results_in(const std::string& folder) {
    auto files = files_below(folder);
    files.erase("report.json");
    files.erase("updates.jsonl");
    return files;
}

TEST(Inputs, MapsComeThroughPipes) {
    const Folder folder;
    folder.write("map.pgm", office_pgm());
    folder.write("map.yaml", yaml_for("map.pgm"));
    // One that no YAML names: beside a pipe there is none.
    folder.write("bare.pgm", office_pgm());
    for (const std::string name : {"bare.pgm", "map.yaml"}) {
        ASSERT_EQ(run_line(folder, "\"$Q\" segment " + name + " -o plain").exit_code, 0);
        const auto expected = results_in(folder / "plain");
        ASSERT_EQ(expected.size(), 6U);
        const std::vector<std::string> lines = {
            "cat " + name + " | \"$Q\" segment - -o out",
            "\"$Q\" segment - -o out < " + name,
            "\"$Q\" segment /dev/stdin -o out < " + name,
            "\"$Q\" segment <(cat " + name + ") -o out",
            "rm -f pipe; mkfifo pipe; (cat " + name + " > pipe &); \"$Q\" segment pipe -o out",
        };
        for (const std::string& line : lines) {
            std::filesystem::remove_all(folder / "out");
            const Outcome outcome = run_line(folder, line);
            EXPECT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.err;
            EXPECT_EQ(results_in(folder / "out"), expected) << line;
        }
    }
}

TEST(Inputs, LogsComeThroughPipes) {
    const Folder folder;
    folder.write("robot.log", log_text());
    folder.write("robot.log.gz", io::test::gzip(log_text()));
    for (const std::string command : {"map", "segment", "follow"}) {
        ASSERT_EQ(run_line(folder, "\"$Q\" " + command + " robot.log -o plain").exit_code, 0);
        const auto expected = results_in(folder / "plain");
        ASSERT_FALSE(expected.empty());
        for (const std::string operand :
             {"- < robot.log", "- < robot.log.gz", "<(cat robot.log)"}) {
            std::filesystem::remove_all(folder / "out");
            const std::string line = "\"$Q\" " + command + " -o out " + operand;
            const Outcome outcome = run_line(folder, line);
            EXPECT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.err;
            EXPECT_EQ(results_in(folder / "out"), expected) << line;
        }
        std::filesystem::remove_all(folder / "plain");
    }
}

TEST(Inputs, ImagesToScoreAndPosesComeThroughPipes) {
    const Folder folder;
    folder.write("a.pgm", office_pgm());
    folder.write("robot.log", log_text());
    std::string poses;
    for (int i = 0; i < 8; ++i) poses += std::to_string(i) + " 1 1 0 0 0 0 1\n";
    folder.write("robot.tum", poses);
    EXPECT_EQ(run_line(folder, "\"$Q\" score - <(cat a.pgm) < a.pgm").exit_code, 0);
    const Outcome outcome = run_line(folder, "\"$Q\" map robot.log --poses - -o out < robot.tum");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const Outcome twice = run_line(folder, "\"$Q\" map - --poses - -o out < robot.log");
    EXPECT_EQ(twice.exit_code, 2);
    EXPECT_NE(twice.err.find("standard input: given twice"), std::string::npos) << twice.err;
}

TEST(Inputs, StandardInputIsNamedInMessages) {
    const Folder folder;
    for (const auto& [bytes, words] : std::vector<std::pair<std::string, std::string>>{
             {"", "standard input: the file is empty"},
             {"#ROSBAG V2.0\n", "standard input: is a ROS 1 bag"},
             {"P5 4 4 255\n123", "standard input: byte 11: expected 16 bytes"},
             {"nothing of interest", "standard input: is of no kind that is known"}}) {
        folder.write("bytes", bytes);
        const Outcome outcome = run_line(folder, "\"$Q\" segment - -o out < bytes");
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    }
    // An endless pipe is no reason to read for long.
    for (const std::string command : {"segment", "map", "follow"}) {
        const Outcome endless = run_line(folder, "cat /dev/zero | \"$Q\" " + command + " - -o out");
        EXPECT_EQ(endless.exit_code, 2);
        EXPECT_NE(endless.err.find("standard input: is of no kind"), std::string::npos)
            << endless.err;
    }
}

TEST(Inputs, TextMayComeFromWindows) {
    const Folder folder;
    const auto windows = [](std::string text) {
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
            text.replace(at, 1, "\r\n");
        }
        return "\xEF\xBB\xBF" + text;
    };
    folder.write("map.pgm", office_pgm());
    folder.write("map.yaml", windows(yaml_for("map.pgm")));
    folder.write("robot.log", windows(log_text()));
    folder.write("plain.log", log_text());
    EXPECT_EQ(run_line(folder, "\"$Q\" segment map.yaml -o rooms").exit_code, 0);
    ASSERT_EQ(run_line(folder, "\"$Q\" map plain.log -o plain").exit_code, 0);
    const Outcome outcome = run_line(folder, "\"$Q\" map robot.log -o out");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(files_below(folder / "out"), files_below(folder / "plain"));
}

TEST(Inputs, AnImageMayBePacked) {
    const Folder folder;
    folder.write("map.pgm", office_pgm());
    folder.write("map.pgm.gz", io::test::gzip(office_pgm()));
    folder.write("map.yaml", yaml_for("map.pgm"));
    folder.write("packed.yaml", yaml_for("map.pgm.gz"));
    ASSERT_EQ(run_line(folder, "\"$Q\" segment map.yaml -o a").exit_code, 0);
    ASSERT_EQ(run_line(folder, "\"$Q\" segment packed.yaml -o b").exit_code, 0);
    EXPECT_EQ(results_in(folder / "a"), results_in(folder / "b"));
    ASSERT_EQ(run_line(folder, "\"$Q\" segment map.pgm.gz -o c").exit_code, 0);
    EXPECT_EQ(files_below(folder / "a")["rooms.png"], files_below(folder / "c")["rooms.png"]);
    folder.write("map.yaml.gz", io::test::gzip(yaml_for("map.pgm")));
    ASSERT_EQ(run_line(folder, "\"$Q\" segment map.yaml.gz -o e").exit_code, 0);
    EXPECT_EQ(results_in(folder / "a"), results_in(folder / "e"));
    const std::string cut = io::test::gzip(office_pgm()).substr(0, 60);
    folder.write("cut.pgm.gz", cut);
    const Outcome outcome = run_line(folder, "\"$Q\" segment cut.pgm.gz -o d");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("cut.pgm.gz"), std::string::npos) << outcome.err;
}

TEST(Inputs, SurplusBytesAreAWarningWithTheName) {
    const Folder folder;
    folder.write("long.pgm", office_pgm() + "xyz");
    folder.write("map.yaml", yaml_for("long.pgm"));
    for (const std::string line : {"segment long.pgm", "segment map.yaml"}) {
        const Outcome outcome = run_line(folder, "\"$Q\" " + line + " -o out");
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_NE(outcome.err.find("the file goes on after the image for 3 bytes"),
                  std::string::npos)
            << outcome.err;
    }
    const Outcome score = run_line(folder, "\"$Q\" score long.pgm long.pgm");
    EXPECT_EQ(score.exit_code, 0);
    EXPECT_NE(score.err.find("long.pgm: the file goes on"), std::string::npos) << score.err;
}

void expect_refused(const Folder& folder, const std::string& line,
                    const std::vector<std::string>& words) {
    const Outcome outcome = run_line(folder, "\"$Q\" " + line);
    EXPECT_EQ(outcome.exit_code, 2) << line << "\n" << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    for (const std::string& word : words) {
        EXPECT_NE(outcome.err.find(word), std::string::npos)
            << line << ": no '" << word << "' in: " << outcome.err;
    }
}

TEST(Inputs, DevicesAreRefused) {
    const Folder folder;
    folder.write("map.yaml", yaml_for("/dev/zero"));
    expect_refused(folder, "segment map.yaml -o out", {"map.yaml", "/dev/zero: is a device"});
    expect_refused(folder, "segment /dev/urandom -o out", {"/dev/urandom: is a device"});
    expect_refused(folder, "map /dev/zero -o out", {"/dev/zero: is a device"});
    expect_refused(folder, "score /dev/zero /dev/zero", {"/dev/zero: is a device"});
    expect_refused(folder, "segment - -o out < /dev/null", {"standard input: is a device"});
}

TEST(Inputs, AMapForALogAndTheOtherWayRound) {
    const Folder folder;
    folder.write("map.pgm", office_pgm());
    folder.write("map.yaml", yaml_for("map.pgm"));
    folder.write("robot.log", log_text());
    folder.write("robot.tum", "0 0 0 0 0 0 0 1\n");
    expect_refused(folder, "map map.pgm -o out", {"map.pgm: is an image", "quadcut segment"});
    expect_refused(folder, "map map.yaml -o out", {"map.yaml: is a map", "quadcut segment"});
    expect_refused(folder, "follow map.yaml -o out", {"map.yaml: is a map", "quadcut segment"});
    expect_refused(folder, "score robot.log map.pgm", {"robot.log: is a laser log", "quadcut map"});
    expect_refused(folder, "score map.yaml map.pgm", {"map.yaml: is a map"});
    expect_refused(folder, "segment robot.tum -o out", {"robot.tum: is a trajectory", "--poses"});
    expect_refused(folder, "map robot.log --poses map.pgm -o out", {"map.pgm: is an image"});
    expect_refused(folder, "segment map.pgm --poses robot.log -o out",
                   {"robot.log: is a laser log"});
}

TEST(Inputs, KindsThatAreNotReadAreNamed) {
    const Folder folder;
    const std::vector<std::pair<std::string, std::vector<std::string>>> kinds = {
        {"#ROSBAG V2.0\n", {"a ROS 1 bag", "rosbag play"}},
        {"\x89MCAP0\r\n", {"an MCAP file", "ros2 bag play"}},
        {"\xDB\x01\xF5\x5B\x7B\x1F\x1D\x7B", {"pbstream", "cartographer_pbstream_to_ros_map"}},
        {"\x16\0\0\0\0\0\0\0serialization::archive"s, {"slam_toolbox", "map_saver_cli"}},
        {"SQLite format 3\0"s, {"an SQLite database"}},
        {"SQLite format 3\0"s + std::string(52, '\0') + "QCUT", {"a project of quadcut", "locate"}},
        {"# Octomap OcTree binary file\n", {"an OctoMap", "projected_map"}},
        {"%PDF-1.5", {"a PDF", "PNG"}},
        {"<?xml version='1.0'?>\n<svg>", {"an SVG drawing", "PNG"}},
        {"PK\x03\x04", {"a ZIP archive", "unpack"}},
    };
    for (const auto& [bytes, words] : kinds) {
        folder.write("input", bytes);
        for (const std::string command : {"segment input -o out", "map input -o out",
                                          "follow input -o out", "score input input"}) {
            expect_refused(folder, command, words);
        }
    }
    for (const std::string name : {"a.bag", "a.db3", "a.mcap", "a.pbstream", "a.posegraph", "a.pcd",
                                   "a.svg", "a.dae", "A.BAG"}) {
        folder.write(name, "damaged");
        expect_refused(folder, "segment " + name + " -o out", {name + ": is ", "; "});
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(Inputs, FoldersAreNamedForWhatIsInThem) {
    const Folder folder;
    folder.write("bag/metadata.yaml", "rosbag2_bagfile_information:\n");
    folder.write("bag/bag_0.mcap", "x");
    folder.write("maps/map.pgm", office_pgm());
    folder.write("maps/map.yaml", yaml_for("map.pgm"));
    folder.write("empty/notes.txt", "x");
    ASSERT_EQ(run_line(folder, "\"$Q\" segment maps/map.yaml -o rooms").exit_code, 0);
    expect_refused(folder, "segment bag -o out", {"bag", "ROS 2 bag", "ros2 bag play"});
    expect_refused(folder, "segment bag/metadata.yaml -o out", {"ROS 2 bag", "ros2 bag play"});
    expect_refused(folder, "segment maps -o out", {"is a folder", "maps/map.yaml"});
    expect_refused(folder, "map maps -o out", {"is a folder", "maps/map.yaml"});
    expect_refused(folder, "segment rooms -o out", {"result of quadcut", "rooms/rooms.yaml"});
    expect_refused(folder, "follow empty -o out", {"without a map or a log"});
}

}  // namespace
}  // namespace quadcut::test
