// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What a command may write over, and that its files appear together or not at all.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

/// A run that must be refused because of one file, with all that is there as it was.
void expect_kept(const Folder& folder, const std::vector<std::string>& arguments,
                 const std::string& file, const std::string& reason) {
    const auto before = files_below(folder / "");
    const Outcome outcome = run_quadcut(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("quadcut: " + file + ": ", 0), 0U) << outcome.err;
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
    EXPECT_EQ(files_below(folder / ""), before);
}

void expect_done(const std::vector<std::string>& arguments) {
    const Outcome outcome = run_quadcut(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments[0] << ": " << outcome.err;
}

/// A building of a few rooms and a robot's log of it, in D.
std::string simulated_log(const Folder& folder) {
    expect_done({"simulate", "-o", folder / "D", "--rooms", "4"});
    return folder / "D/robot.log";
}

TEST(OutputFiles, AreNeverTheInput) {
    const Folder folder;
    const std::string image = folder.write("D/rooms.png", office_pgm());
    expect_kept(folder, {"segment", image, "-o", folder / "D"}, image, "is read by this run");
    expect_kept(folder, {"segment", image, "-o", folder / "D", "--force"}, image, "is read");
    expect_kept(
        folder,
        {"segment", folder.write("D/a.yaml", yaml_for("rooms.png")), "-o", folder / "D", "--force"},
        image, "is read");
    std::filesystem::create_hard_link(image, folder / "twin.pgm");
    expect_kept(folder, {"segment", folder / "twin.pgm", "-o", folder / "D", "--force"}, image,
                "is read");
    const std::string poses = folder.write("P/rooms.yaml", "0 0 0 0 0 0 0 1\n");
    expect_kept(folder,
                {"segment", folder.write("m.pgm", office_pgm()), "--poses", poses, "--force", "-o",
                 folder / "P"},
                poses, "is read");
}

TEST(OutputFiles, AreNoProjectThatIsYetToBeMade) {
    const Folder folder;
    const std::string log = simulated_log(folder);
    const std::string project = folder / "new/rooms.yaml";
    expect_kept(folder, {"follow", log, "-o", folder / "new", "--project", project}, project,
                "is read by this run");
    expect_kept(
        folder,
        {"follow", log, "-o", folder / "D", "--project", folder / "D/../D/rooms.png", "--force"},
        folder / "D/rooms.png", "is read by this run");
    expect_done({"follow", log, "-o", folder / "new", "--project", folder / "new/home.quadcut"});
}

TEST(OutputFiles, AreNotTheFilesOfOthers) {
    const Folder folder;
    const std::string log = simulated_log(folder);
    const std::string map = folder.write("out/map.yaml", yaml_for("map.pgm"));
    for (const std::string command : {"map", "segment", "follow"}) {
        expect_kept(folder, {command, log, "-o", folder / "out"}, map, "--force");
    }
    expect_kept(folder, {"simulate", "-o", folder / "out"}, map, "--force");
    expect_done({"map", log, "-o", folder / "out", "--force"});
    EXPECT_NE(read_bytes(map).find("format_version"), std::string::npos);
    const std::string picture = folder.write("out/rooms.svg", "<svg/>");
    expect_kept(folder, {"segment", map, "-o", folder / "out"}, picture, "--force");
}

TEST(OutputFiles, AreNotTheProjectNorInTheWayOfAFolder) {
    const Folder folder;
    const std::string log = simulated_log(folder);
    std::filesystem::create_directories(folder / "out");
    const std::string project = folder / "out/rooms.yaml";
    expect_kept(folder, {"follow", log, "-o", folder / "out", "--project", project}, project,
                "is read by this run");
    expect_kept(folder,
                {"follow", log, "-o", folder / "new", "--project", folder / "new/../new/map.yaml"},
                folder / "new/map.yaml", "is read by this run");
    const std::string file = folder.write("demo/simulation", "mine");
    expect_kept(folder, {"demo", "-o", folder / "demo"}, file, "is no folder");
}

TEST(OutputFiles, OfTheSameCommandAreWrittenAnew) {
    const Folder folder;
    const std::string log = simulated_log(folder);
    for (int run = 0; run < 2; ++run) {
        expect_done({"simulate", "-o", folder / "D", "--rooms", "4"});
        for (const std::string command : {"map", "segment", "follow"}) {
            expect_done({command, log, "-o", folder / command});
        }
        expect_done({"segment", folder / "map/map.yaml", "-o", folder / "map"});
        expect_done({"segment", folder / "map/map.yaml", "-o", folder / "map", "--previous",
                     folder / "map"});
    }
}

TEST(OutputFiles, AppearTogetherOrNotAtAll) {
    const Folder folder;
    const std::string log = simulated_log(folder);
    // A disk that is full after the map, which is written first: 512 bytes a block.
    const std::string limited = "ulimit -f \"$0\"; exec \"$@\"";
    const std::uintmax_t log_blocks = std::filesystem::file_size(log) / 512;
    for (const std::string command : {"segment", "follow"}) {
        const auto before = files_below(folder / "");
        expect_done({"map", log, "-o", folder / "map", "--quiet"});
        const std::uintmax_t blocks = std::filesystem::file_size(folder / "map/map.pgm") / 512 + 1;
        std::filesystem::remove_all(folder / "map");
        const Outcome outcome =
            run_process("/bin/sh", {"-c", limited, std::to_string(blocks), QUADCUT_BINARY, command,
                                    log, "-o", folder / "new/deeper", "--resolution", "0.05"});
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find("new/deeper/"), std::string::npos) << outcome.err;
        EXPECT_EQ(files_below(folder / ""), before);
        EXPECT_FALSE(std::filesystem::exists(folder / "new"));
    }
    const Outcome outcome =
        run_process("/bin/sh", {"-c", limited, std::to_string(log_blocks), QUADCUT_BINARY,
                                "simulate", "-o", folder / "new", "--rooms", "4"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("new/robot.log: "), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "new"));
}

}  // namespace
}  // namespace quadcut::test
