// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

/// A run that must fail on its input: exit code 2, one line on standard error with all the `words`,
/// nothing on standard output, and nothing written.
void expect_refused(const Folder& folder, std::vector<std::string> arguments,
                    const std::vector<std::string>& words) {
    const std::string command = arguments.at(0);
    if (command == "segment" || command == "map") {
        arguments.insert(arguments.end(), {"-o", folder / "out"});
    }
    const auto before = files_below(folder / "");
    const Outcome outcome = run_quadcut(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("quadcut: ", 0), 0U) << outcome.err;
    for (const std::string& word : words) {
        EXPECT_NE(outcome.err.find(word), std::string::npos)
            << "no '" << word << "' in: " << outcome.err;
    }
    EXPECT_EQ(files_below(folder / ""), before);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

std::string yaml_without(std::string_view key) {
    std::string yaml = yaml_for("map.pgm");
    const std::size_t start = yaml.find(key);
    yaml.erase(start, yaml.find('\n', start) - start + 1);
    return yaml;
}

std::string yaml_with(std::string_view key, std::string_view value) {
    return yaml_without(key) + std::string(key) + " " + std::string(value) + "\n";
}

TEST(RefusedMap, MissingFile) {
    const Folder folder;
    for (const std::string name : {"none.yaml", "none.pgm", "none.png", "none"}) {
        expect_refused(folder, {"segment", folder / name}, {name});
    }
}

TEST(RefusedMap, FolderInsteadOfFile) {
    const Folder folder;
    std::filesystem::create_directories(folder / "folder.pgm");
    std::filesystem::create_directories(folder / "folder");
    expect_refused(folder, {"segment", folder / "folder.pgm"}, {"folder.pgm"});
    expect_refused(folder, {"segment", folder / "folder"}, {"folder"});
}

TEST(RefusedMap, Empty) {
    const Folder folder;
    for (const std::string name : {"empty.yaml", "empty.pgm", "empty.png", "empty"}) {
        expect_refused(folder, {"segment", folder.write(name, "")}, {name});
    }
}

TEST(RefusedMap, TruncatedImage) {
    const Folder folder;
    const std::string pgm = office_pgm();
    expect_refused(folder, {"segment", folder.write("cut.pgm", pgm.substr(0, pgm.size() / 2))},
                   {"cut.pgm"});
    expect_refused(folder, {"segment", folder.write("head.pgm", "P5\n12")}, {"head.pgm"});
    expect_refused(folder,
                   {"segment", folder.write("cut.png", "\x89PNG\r\n\x1a\n" + pgm.substr(0, 99))},
                   {"cut.png"});
}

TEST(RefusedMap, NoImage) {
    const Folder folder;
    const std::string text = "A shopping list: milk, bread, maps.\n";
    for (const std::string name : {"list.pgm", "list.png", "list.txt", "list"}) {
        expect_refused(folder, {"segment", folder.write(name, text)}, {name});
    }
}

TEST(RefusedMap, YamlOfSomethingElse) {
    const Folder folder;
    folder.write("map.pgm", office_pgm());
    expect_refused(folder, {"segment", folder.write("a.yaml", "a: b\n")}, {"a.yaml", "image"});
    expect_refused(folder, {"segment", folder.write("b.yaml", "[1, 2")}, {"b.yaml"});
    expect_refused(folder, {"segment", folder.write("c.yaml", std::string(99, '\xFF'))},
                   {"c.yaml"});
}

TEST(RefusedMap, YamlWithoutAKey) {
    const Folder folder;
    folder.write("map.pgm", office_pgm());
    for (const std::string key :
         {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}) {
        expect_refused(folder, {"segment", folder.write("map.yaml", yaml_without(key))},
                       {"map.yaml", key});
    }
}

TEST(RefusedMap, YamlWithAWrongValue) {
    const Folder folder;
    folder.write("map.pgm", office_pgm());
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"resolution:", ".nan"},     {"resolution:", "nan"},  {"resolution:", "-0.05"},
        {"resolution:", "0"},        {"resolution:", "wide"}, {"origin:", "[0, 0]"},
        {"origin:", "[.inf, 0, 0]"}, {"origin:", "here"},     {"negate:", "perhaps"},
        {"occupied_thresh:", "7"},   {"free_thresh:", "x"},   {"image:", "none.pgm"},
    };
    for (const auto& [key, value] : wrong) {
        expect_refused(folder, {"segment", folder.write("map.yaml", yaml_with(key, value))},
                       {key == "image:" ? "none.pgm" : "map.yaml"});
    }
}

TEST(RefusedMap, HugeHeader) {
    const Folder folder;
    expect_refused(folder,
                   {"segment", folder.write("huge.pgm", "P5\n1000000000 1000000000\n255\n....")},
                   {"huge.pgm"});
    expect_refused(folder,
                   {"segment", folder.write("deep.pgm", "P2\n1000000000 1000000000\n255\n0 0")},
                   {"deep.pgm"});
    // Width and height 10^9 in an otherwise sound header.
    std::string png("\x89PNG\r\n\x1a\n\0\0\0\x0DIHDR\x3b\x9a\xca\0\x3b\x9a\xca\0\x08\0\0\0\0", 29);
    png += std::string("\x41\xf7\x59\x38", 4);
    expect_refused(folder, {"segment", folder.write("huge.png", png)}, {"huge.png"});
}

TEST(RefusedMap, BadPoses) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", office_pgm());
    expect_refused(folder, {"segment", map, "--poses", folder / "none.tum"}, {"none.tum"});
    expect_refused(folder,
                   {"segment", map, "--poses", folder.write("bad.tum", "0 1 2 x 0 0 0 1\n")},
                   {"bad.tum"});
}

TEST(RefusedLog, NoLaserLine) {
    const Folder folder;
    for (const std::string text : {"", "# a comment\n", "ODOM 0 0 0 0 0 0 1 host 1\n"}) {
        expect_refused(folder, {"map", folder.write("still.log", text)}, {"still.log"});
        expect_refused(folder, {"segment", folder / "still.log"}, {"still.log"});
    }
}

TEST(RefusedLog, OnlyGarbage) {
    const Folder folder;
    std::string garbage;
    for (int i = 0; i < 2000; ++i) garbage += static_cast<char>((i * 7919) % 251);
    expect_refused(folder, {"map", folder.write("noise.log", garbage)}, {"noise.log"});
    expect_refused(folder, {"map", folder.write("noise.gz", "\x1F\x8B" + garbage)}, {"noise.gz"});
}

TEST(RefusedLog, OnlyNanAndNegativeRanges) {
    const Folder folder;
    expect_refused(folder,
                   {"map", folder.write("nan.log", "FLASER 3 nan -1 nan 0 0 0 0 0 0 1 host 1\n")},
                   {"nan.log"});
}

TEST(RefusedLog, MissingFile) {
    const Folder folder;
    expect_refused(folder, {"map", folder / "none.log"}, {"none.log"});
}

TEST(RefusedCommandLine, UnknownOptionNamesTheNearest) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", office_pgm());
    expect_refused(folder, {"segment", map, "--resolutoin", "0.05"},
                   {"--resolutoin", "--resolution"});
    expect_refused(folder, {"segment", map, "--set", "rooms.min_rom=2"},
                   {"rooms.min_rom", "rooms.min_room"});
    expect_refused(folder, {"segment", map, "--zzzzzzzz"}, {"--zzzzzzzz", "--help"});
}

TEST(RefusedCommandLine, BadValues) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", office_pgm());
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"--resolution", "nan"},  {"--resolution", "-1"}, {"--granularity", "1.5"},
        {"--door-width", "wide"}, {"--preset", "roms"},   {"--threads", "0"},
        {"--submaps", "-3"},      {"--set", "preset"},
    };
    for (const auto& [flag, value] : wrong) {
        expect_refused(folder, {"segment", map, flag, value}, {value});
    }
    expect_refused(folder, {"segment", map, "--threads"}, {"--threads"});
    expect_refused(folder, {"segment", map, "--threads", "--json"}, {"--threads"});
    expect_refused(folder, {"segment", map, "--json=yes"}, {"--json"});
    expect_refused(folder, {"segment", map, "--threads", "1", "--threads", "2"}, {"twice"});
}

TEST(RefusedCommandLine, Operands) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", office_pgm());
    expect_refused(folder, {"segment"}, {"MAP"});
    expect_refused(folder, {"segment", map, map}, {"usage"});
    expect_refused(folder, {"score", map}, {"TRUTH"});
}

TEST(RefusedCommandLine, MissingOutput) {
    const Folder folder;
    const Outcome outcome = run_quadcut({"segment", folder.write("map.pgm", office_pgm())});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("-o DIR"), std::string::npos) << outcome.err;
}

TEST(RefusedCommandLine, WhatIsNotBuiltYet) {
    const Folder folder;
    for (const std::string command : {"serve", "batch", "ros2"}) {
        expect_refused(folder, {command, "x"}, {command, "this version"});
    }
}

TEST(RefusedCommandLine, UnknownCommand) {
    const Folder folder;
    expect_refused(folder, {"segmnet"}, {"segmnet", "segment"});
    expect_refused(folder, {"xyzzy"}, {"xyzzy", "quadcut help"});
    const Outcome outcome = run_quadcut({});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("quadcut help"), std::string::npos);
}

TEST(RefusedOutput, FolderUnderAFile) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", office_pgm());
    const std::string log = folder.write("one.log", "FLASER 1 1.0 0 0 0 0 0 0 1 host 1\n");
    const std::vector<std::vector<std::string>> runs = {
        {"segment", map}, {"map", log}, {"simulate"}, {"demo"}};
    const auto before = files_below(folder / "");
    for (std::vector<std::string> run : runs) {
        run.insert(run.end(), {"-o", map + "/out"});
        const Outcome outcome = run_quadcut(run);
        EXPECT_EQ(outcome.exit_code, 2) << run[0];
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find("map.pgm"), std::string::npos) << outcome.err;
        EXPECT_EQ(files_below(folder / ""), before);
    }
}

TEST(RefusedOutput, ResultNameTakenByAFolder) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", office_pgm());
    std::filesystem::create_directories(folder / "out/rooms.png");
    const Outcome outcome = run_quadcut({"segment", map, "-o", folder / "out"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("rooms.png"), std::string::npos) << outcome.err;
    EXPECT_TRUE(files_below(folder / "out").empty());
}

TEST(RefusedScore, Images) {
    const Folder folder;
    const std::string small = folder.write("small.pgm", drawn_pgm({"##", "##"}, 20));
    const std::string large = folder.write("large.pgm", office_pgm());
    expect_refused(folder, {"score", small, large}, {"40", "224"});
    expect_refused(folder, {"score", small, folder / "none.png"}, {"none.png"});
}

}  // namespace
}  // namespace quadcut::test
