// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/project.hpp"

#include <chrono>
#include <filesystem>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "project/project_file.hpp"
#include "quadcut/base/random.hpp"
#include "tests/e2e/program.hpp"

namespace quadcut::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

/// A robot's log of a small building.
std::string simulated_log(const Folder& folder, const std::string& seed) {
    run_quadcut({"simulate", "-o", folder / "sim", "--seed", seed, "--rooms", "6"});
    return folder / "sim/robot.log";
}

/// Files without their times.
std::map<std::string, std::string> untimed_files(const std::string& folder) {
    static const std::regex kTimes(R"("[a-z_]*_ms": ?(\{[^}]*\}|[^,}\n]*))");
    std::map<std::string, std::string> files;
    for (const auto& [name, bytes] : files_below(folder)) {
        files[name] = std::regex_replace(bytes, kTimes, "");
    }
    return files;
}

/// Where two texts differ first, and what stands there.
std::string first_difference(const std::string& text, const std::string& expected) {
    constexpr std::size_t kAround = 120;
    std::size_t at = 0;
    while (at < text.size() && at < expected.size() && text[at] == expected[at]) ++at;
    const std::size_t begin = at > kAround ? at - kAround : 0;
    return "at byte " + std::to_string(at) + ": " + text.substr(begin, 2 * kAround) +
           "\nexpected: " + expected.substr(begin, 2 * kAround);
}

/// Runs quadcut and kills it after some time; whether it had ended by itself.
bool run_and_kill(const std::vector<std::string>& arguments, double after_s) {
    std::vector<std::string> words{"-s", "KILL", std::to_string(after_s), QUADCUT_BINARY};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_process("/usr/bin/timeout", words).exit_code == 0;
}

TEST(ProjectFile, SurvivesBeingKilledAtAnyMoment) {
    const Folder folder;
    const std::string log = simulated_log(folder, "2");
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(run_quadcut({"follow", log, "-o", folder / "whole", "--quiet"}).exit_code, 0);
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
    const std::string project = folder / "p.quadcut";
    const std::vector<std::string> follow{"follow",    log,     "-o",     folder / "out",
                                          "--project", project, "--quiet"};
    Random random(static_cast<std::uint64_t>(start.time_since_epoch().count()));
    std::size_t num_done = 0;
    for (int i = 0; i < 10; ++i) {
        if (run_and_kill(follow, random.uniform(0.001, 0.8 * whole.count()))) break;
        if (!std::filesystem::exists(project)) continue;
        EXPECT_EQ(project::ProjectFile(project, Access::read).integrity(), "ok");
        const std::size_t saved = Project::open(project, Access::read).position()->num_done;
        EXPECT_GE(saved, num_done) << "what was saved is never lost";
        num_done = saved;
    }
    const Outcome outcome = run_quadcut(follow);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto whole_files = untimed_files(folder / "whole");
    const auto files = untimed_files(folder / "out");
    EXPECT_EQ(files.size(), whole_files.size());
    for (const auto& [name, bytes] : whole_files) {
        ASSERT_EQ(files.count(name), 1U) << name;
        EXPECT_TRUE(files.at(name) == bytes)
            << name << ": " << first_difference(files.at(name), bytes);
    }
    for (const auto& [name, bytes] : files_below(folder / "")) {
        EXPECT_EQ(name.find("p.quadcut.new"), std::string::npos) << "left behind";
    }
}

TEST(ProjectFile, EditsAndLocate) {
    const Folder folder;
    const std::string log = simulated_log(folder, "2");
    const std::string project = folder / "p.quadcut";
    const std::vector<std::string> follow{"follow",    log,     "-o",     folder / "out",
                                          "--project", project, "--quiet"};
    ASSERT_EQ(run_quadcut(follow).exit_code, 0);
    // Every label point lies in its room, told from the result and from the project.
    const Json rooms = Json::parse(read_bytes(folder / "out/rooms.geojson")).at("features");
    std::string id;
    std::string other;
    std::vector<std::string> at;
    for (const Json& feature : rooms) {
        const Json& properties = feature.at("properties");
        if (properties.at("type") != "room") continue;
        const Json& point = properties.at("label_point");
        at = {std::to_string(point[0].get<double>()), std::to_string(point[1].get<double>())};
        id = std::to_string(properties.at("id").get<int>());
        const std::string expected = id + " " + properties.at("name").get<std::string>() + "\n";
        EXPECT_EQ(run_quadcut({"locate", folder / "out", at[0], at[1]}).out, expected);
        EXPECT_EQ(run_quadcut({"locate", project, at[0], at[1]}).out, expected);
    }
    ASSERT_FALSE(id.empty());
    EXPECT_EQ(run_quadcut({"edit", project, "rename", id, "Kitchen"}).exit_code, 0);
    EXPECT_EQ(run_quadcut({"locate", project, at[0], at[1]}).out, id + " Kitchen\n");
    EXPECT_EQ(run_quadcut({"edit", project, "lock", "Kitchen"}).exit_code, 0);
    ASSERT_EQ(run_quadcut(follow).exit_code, 0);
    EXPECT_THAT(read_bytes(folder / "out/rooms.yaml"), HasSubstr("Kitchen"));
    EXPECT_EQ(run_quadcut({"locate", folder / "out", "-1000", "1000"}).out,
              run_quadcut({"locate", project, "-1000", "1000"}).out);

    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"rename", "4000", "x"},
                                               {"rename", id},
                                               {"merge", id, id},
                                               {"split", "0", "0", "0", "zero"},
                                               {"split", "1", "1"},
                                               {"lock", "Cellar"},
                                               {"paint", id}}) {
        std::vector<std::string> command{"edit", project};
        command.insert(command.end(), words.begin(), words.end());
        EXPECT_EQ(run_quadcut(command).exit_code, 2) << words.front();
    }
    EXPECT_EQ(run_quadcut({"locate", project, "nan", "0"}).exit_code, 2);
    EXPECT_EQ(run_quadcut({"locate", folder / "none", "0", "0"}).exit_code, 2);
}

TEST(ProjectFile, BelongsToOneLogAndOneSetOfOptions) {
    const Folder folder;
    const std::string log = simulated_log(folder, "2");
    const std::string project = folder / "p.quadcut";
    std::vector<std::string> follow{"follow",    log,     "-o",     folder / "out",
                                    "--project", project, "--quiet"};
    ASSERT_EQ(run_quadcut(follow).exit_code, 0);
    const std::string before = read_bytes(project);
    std::vector<std::string> other = follow;
    other[1] = folder.write("other.log", read_bytes(log) + "# more\n");
    EXPECT_THAT(run_quadcut(other).err, HasSubstr("follows another log"));
    std::vector<std::string> wider = follow;
    wider.insert(wider.end(), {"--door-width", "2"});
    EXPECT_THAT(run_quadcut(wider).err, HasSubstr("was begun with door_width = 4"));
    std::vector<std::string> finer = follow;
    finer.insert(finer.end(), {"--resolution", "0.1"});
    EXPECT_THAT(run_quadcut(finer).err, HasSubstr("was begun with resolution = 0.05"));
    for (const std::string set : {"scan.max_range=10", "follow.min_change=3"}) {
        std::vector<std::string> changed = follow;
        changed.insert(changed.end(), {"--set", set});
        EXPECT_THAT(run_quadcut(changed).err,
                    HasSubstr("was begun with " + set.substr(0, set.find('=')) + " = "));
    }
    EXPECT_EQ(read_bytes(project), before);
    std::vector<std::string> faster = follow;
    faster.insert(faster.end(), {"--threads", "1"});
    EXPECT_EQ(run_quadcut(faster).exit_code, 0);
    EXPECT_THAT(read_bytes(folder / "out/report.json"), Not(HasSubstr("scan.")));
    follow[5] = folder.write("text", "no project");
    EXPECT_EQ(run_quadcut(follow).exit_code, 2);
    EXPECT_EQ(read_bytes(folder / "text"), "no project");
}

TEST(ProjectFile, AFullDiskIsAnErrorAndWhatWasSavedStays) {
    const Folder folder;
    const std::string log = simulated_log(folder, "2");
    const std::string project = folder / "p.quadcut";
    const auto follow_within = [&](const std::string& blocks) {
        const std::string command = "ulimit -f " + blocks + "; exec \"$0\" \"$@\"";
        return run_process("/bin/sh", {"-c", command, QUADCUT_BINARY, "follow", log, "-o",
                                       folder / "out", "--project", project});
    };
    const Outcome none = follow_within("10");
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_THAT(none.err, HasSubstr("p.quadcut: cannot be written"));
    for (const auto& [name, bytes] : files_below(folder / "")) {
        EXPECT_EQ(name.find("p.quadcut"), std::string::npos) << name << " is left";
    }
    const Outcome outcome = follow_within("200");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("p.quadcut"));
    EXPECT_THAT(outcome.err, HasSubstr("the file holds what was saved before"));
    EXPECT_EQ(project::ProjectFile(project, Access::read).integrity(), "ok");
    // With room again it goes on.
    EXPECT_EQ(run_quadcut({"follow", log, "-o", folder / "out", "--project", project, "--quiet"})
                  .exit_code,
              0);
}

TEST(ProjectFile, ALogThatEndsInTheMiddleOfALineIsFollowedUpToThere) {
    const Folder folder;
    const std::string bytes = read_bytes(simulated_log(folder, "2"));
    const std::string log = folder.write("cut.log", bytes.substr(0, bytes.size() / 3));
    const Outcome outcome = run_quadcut({"follow", log, "-o", folder / "out"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("cut.log"));
}

/// A ROBOTLASER1 line in words: [8] is the number of ranges, which follow.
std::vector<std::string> words_of(const std::string& line) {
    std::istringstream words(line);
    return {std::istream_iterator<std::string>(words), {}};
}

std::string line_of(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += word + " ";
    return line + "\n";
}

TEST(FollowCommand, OddLinesAreCountedAndTheRestIsFollowed) {
    const Folder folder;
    std::istringstream lines(read_bytes(simulated_log(folder, "2")));
    std::string odd;
    std::size_t i = 0;
    for (std::string line; std::getline(lines, line); ++i) {
        std::vector<std::string> words = words_of(line);
        if (words.empty() || words[0] != "ROBOTLASER1") {
            odd += line + "\n";
            continue;
        }
        const std::size_t count = std::stoul(words[8]);
        const std::size_t pose = 9 + count + 1;
        const std::string stamp = words[words.size() - 1];
        switch (i % 40) {
            case 11:  // no pose
                words[pose] = "nan";
                break;
            case 13:  // no ranges
                words.erase(words.begin() + 9, words.begin() + 9 + static_cast<long>(count));
                words[8] = "0";
                break;
            case 17: {  // every other beam
                std::vector<std::string> fewer(words.begin(), words.begin() + 9);
                for (std::size_t k = 0; k < count; k += 2) fewer.push_back(words[9 + k]);
                fewer[8] = std::to_string(fewer.size() - 9);
                fewer[4] = std::to_string(2.0 * std::stod(words[4]));
                fewer.insert(fewer.end(), words.begin() + 9 + static_cast<long>(count),
                             words.end());
                words = fewer;
                break;
            }
            case 19:  // the same again
                odd += line_of(words);
                break;
            case 23:  // back in time
                words[words.size() - 1] = words[words.size() - 3] = "0.5";
                break;
            default:
                break;
        }
        if (i == 60) {
            words[pose] = std::to_string(std::stod(words[pose]) + 100.0);
            words[pose + 3] = std::to_string(std::stod(words[pose + 3]) + 100.0);
        }
        odd += line_of(words);
    }
    ASSERT_GT(i, 100U);
    const std::string log = folder.write("odd.log", odd);
    const std::string project = folder / "p.quadcut";
    const Outcome outcome =
        run_quadcut({"follow", log, "-o", folder / "out", "--project", project, "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("odd.log")) << "a warning counts the lines";
    EXPECT_GT(Json::parse(outcome.out).at("num_rooms").get<int>(), 3);
    EXPECT_EQ(project::ProjectFile(project, Access::read).integrity(), "ok");
}

/// What lies beside each other and begins with the project's name.
std::vector<std::string> project_files(const Folder& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "")) {
        const std::string name = entry.path().filename().string();
        if (name.rfind("p.quadcut", 0) == 0) names.push_back(name);
    }
    return names;
}

TEST(ProjectFile, SlowOfProgramsThatMakeItAtOnceOneWins) {
    const Folder folder;
    const std::string log = simulated_log(folder, "2");
    const std::string project = folder / "p.quadcut";
    for (int round = 0; round < 20; ++round) {
        for (const std::string& name : project_files(folder)) {
            std::filesystem::remove(folder / name);
        }
        // What is left of an earlier file of this name harms none of them.
        if (round % 2 == 0) static_cast<void>(folder.write("p.quadcut-wal", read_bytes(log)));
        std::vector<Outcome> outcomes(3);
        std::vector<std::thread> programs;
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            // Each with an error output of its own.
            const std::string own = folder / ("own" + std::to_string(i));
            programs.emplace_back([&outcomes, &log, &project, i, own] {
                const std::string command = "exec 2>" + own + ".err; exec \"$0\" \"$@\"";
                outcomes[i] = run_process("/bin/sh", {"-c", command, QUADCUT_BINARY, "follow", log,
                                                      "-o", own, "--project", project, "--quiet"});
                outcomes[i].err = read_bytes(own + ".err");
            });
        }
        for (std::thread& program : programs) program.join();
        int num_winners = 0;
        for (const Outcome& outcome : outcomes) {
            if (outcome.exit_code == 0) ++num_winners;
            if (outcome.exit_code == 0) continue;
            EXPECT_EQ(outcome.exit_code, 2);
            EXPECT_THAT(outcome.err, HasSubstr("p.quadcut: is in use: another program"));
        }
        // Who waited until the first had ended goes on from there.
        EXPECT_GE(num_winners, 1);
        EXPECT_EQ(project_files(folder), std::vector<std::string>{"p.quadcut"});
        EXPECT_EQ(project::ProjectFile(project, Access::read).integrity(), "ok");
    }
}

TEST(ProjectFile, SlowAKillWhileItIsMadeLeavesNothing) {
    const Folder folder;
    const std::string log = simulated_log(folder, "2");
    const std::string project = folder / "p.quadcut";
    const std::vector<std::string> follow{"follow",    log,     "-o",     folder / "out",
                                          "--project", project, "--quiet"};
    Random random(5);
    for (int round = 0; round < 25; ++round) {
        for (const std::string& name : project_files(folder)) {
            std::filesystem::remove(folder / name);
        }
        run_and_kill(follow, random.uniform(0.001, 0.15));
        for (const std::string& name : project_files(folder)) {
            EXPECT_TRUE(name == "p.quadcut" || name == "p.quadcut-wal" || name == "p.quadcut-shm")
                << name;
        }
        if (std::filesystem::exists(project)) {
            EXPECT_EQ(project::ProjectFile(project, Access::read).integrity(), "ok");
        }
    }
    EXPECT_EQ(run_quadcut(follow).exit_code, 0);
    EXPECT_EQ(project_files(folder), std::vector<std::string>{"p.quadcut"});
}

TEST(ProjectFile, TwoProgramsDoNotWriteAtOnce) {
    const Folder folder;
    const std::string log = simulated_log(folder, "2");
    const std::string project = folder / "p.quadcut";
    const std::vector<std::string> follow{"follow",    log,     "-o",     folder / "out",
                                          "--project", project, "--quiet"};
    ASSERT_EQ(run_quadcut(follow).exit_code, 0);
    const Project writer = Project::open(project, Access::write);
    const Outcome second = run_quadcut(follow);
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_THAT(second.err, HasSubstr("another program is writing to it"));
    EXPECT_EQ(run_quadcut({"edit", project, "lock", "1"}).exit_code, 2);
    EXPECT_EQ(run_quadcut({"locate", project, "0", "0"}).err, "") << "others may read";
}

}  // namespace
}  // namespace quadcut::test
