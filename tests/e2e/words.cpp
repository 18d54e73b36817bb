// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

/// The one line on standard error of a run that is refused.
std::string refusal(const std::vector<std::string>& arguments) {
    const Outcome outcome = run_quadcut(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    return outcome.err;
}

TEST(Words, AFileThatStandsBeforeTheCommand) {
    EXPECT_EQ(refusal({"map.yaml", "-o", "D"}),
              "quadcut: 'map.yaml': expected a command first: did you mean 'quadcut segment "
              "map.yaml -o D'?\n");
}

TEST(Words, OptionsThatOnlySetHas) {
    EXPECT_EQ(refusal({"segment", "map.yaml", "-o", "D", "--set", "min_room=3"}),
              "quadcut: unknown option 'min_room': did you mean '--set rooms.min_room=3'?\n");
    EXPECT_EQ(refusal({"segment", "map.yaml", "-o", "D", "--set", "preset=room"}),
              "quadcut: option preset: 'room': expected rooms or paper: did you mean 'rooms'?\n");
}

TEST(Words, LongOnesAreNotRepeated) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", office_pgm());
    std::string words = "a";
    for (int i = 0; i < 30000; ++i) words += " b\n\xFF";
    for (const std::string& text : {std::string(100000, 'a'), words}) {
        for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
                 {text},
                 {"--" + text},
                 {"segment", text, "-o", folder / "out"},
                 {"segment", map, "-o", folder / "out", "--" + text},
                 {"segment", map, "-o", folder / "out", "--set", text},
                 {"segment", map, "-o", folder / "out", "--set", text + "=1"},
                 {"segment", map, "-o", folder / "out", "--set", "seed=" + text},
                 {"segment", map, "-o", folder / "out", "--door-width=" + text},
                 {"segment", map, "-o", folder / "out", "--previous", text},
                 {"segment", map, "-o", text + "/out"},
                 {"segment", map, text, "-o", folder / "out"},
                 {"locate", folder / "", text, "1"}}) {
            EXPECT_LT(refusal(arguments).size(), 600U) << arguments[0].substr(0, 20);
        }
    }
}

TEST(Words, PlacesInAnotherOrderOrInOneWord) {
    const Folder folder;
    const std::string there = folder / "";
    EXPECT_EQ(refusal({"locate", "1", "2", there}),
              "quadcut: the folder or project comes first: did you mean 'quadcut locate " + there +
                  " 1 2'?\n");
    EXPECT_EQ(refusal({"locate", there, "1.5,-2"}),
              "quadcut: missing Y: did you mean 'quadcut locate " + there + " 1.5 -2'?\n");
    EXPECT_NE(refusal({"segment", "map.yaml", "-o", "D", "--gpu"}).find("'--device NAME'"),
              std::string::npos);
}

TEST(Words, PreviousThatIsNoResult) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", office_pgm());
    const std::vector<std::string> run{"segment", map, "-o", folder / "out", "--previous"};
    const auto error = [&run](const std::string& previous) {
        std::vector<std::string> arguments = run;
        arguments.push_back(previous);
        return refusal(arguments);
    };
    EXPECT_NE(error(map).find("expected a folder with an earlier result, found a file"),
              std::string::npos);
    EXPECT_NE(error(folder / "").find("found no rooms.yaml in it (map.pgm)"), std::string::npos);
    ASSERT_EQ(run_quadcut({"segment", map, "-o", folder / "old", "--quiet"}).exit_code, 0);
    EXPECT_NE(error(folder / "old/rooms.png").find("did you mean '" + (folder / "old") + "'?"),
              std::string::npos);
}

TEST(Words, AWorkingFolderThatIsGone) {
    const Folder folder;
    const std::string map = folder.write("map.pgm", office_pgm());
    const std::string gone = "mkdir " + (folder / "gone") + " && cd " + (folder / "gone") +
                             " && rmdir " + (folder / "gone") + " && exec " + QUADCUT_BINARY;
    for (const std::string& line : std::vector<std::string>{
             " segment " + map + " -o out", " demo -o out", " segment map.pgm -o /tmp/none/out"}) {
        const Outcome outcome = run_process("/bin/sh", {"-c", gone + line});
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find("the working folder is no longer there"), std::string::npos)
            << outcome.err;
        EXPECT_EQ(outcome.err.find("filesystem error"), std::string::npos) << outcome.err;
    }
    // What does not need it works.
    const Outcome outcome =
        run_process("/bin/sh", {"-c", gone + " segment " + map + " -o " + (folder / "out")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

}  // namespace
}  // namespace quadcut::test
