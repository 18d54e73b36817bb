// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/help.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

using Words = std::vector<std::string>;

std::string error_of(const Words& words) {
    try {
        static_cast<void>(command_of(words));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(CommandOf, NearestName) {
    EXPECT_EQ(error_of({"segmnet"}), "unknown command 'segmnet': did you mean 'segment'?");
    EXPECT_EQ(error_of({"segmentation", "m"}),
              "unknown command 'segmentation': did you mean 'segment'?");
    EXPECT_EQ(error_of({"Map"}), "unknown command 'Map': did you mean 'map'?");
    EXPECT_EQ(error_of({"--demo"}), "unknown command '--demo': did you mean 'demo'?");
    EXPECT_EQ(error_of({"cut"}), "unknown command 'cut': did you mean 'segment'?");
    EXPECT_EQ(error_of({"xyzzy"}), "unknown command 'xyzzy'; 'quadcut help' lists the commands");
}

TEST(CommandOf, FilesAndFlagsBeforeTheCommand) {
    EXPECT_EQ(
        error_of({"map.yaml", "-o", "D"}),
        "'map.yaml': expected a command first: did you mean 'quadcut segment map.yaml -o D'?");
    EXPECT_EQ(error_of({"robot.log"}),
              "'robot.log': expected a command first: did you mean 'quadcut segment robot.log -o "
              "rooms'?");
    EXPECT_EQ(error_of({"-o", "D", "segment", "map.yaml"}),
              "'-o': expected a command first: did you mean 'quadcut segment -o D map.yaml'?");
    EXPECT_EQ(error_of({"-o", "map", "follow", "robot.log"}),
              "'-o': expected a command first: did you mean 'quadcut follow -o map robot.log'?");
    EXPECT_EQ(error_of({"my map.yaml", "map"}),
              "'my map.yaml': expected a command first: did you mean 'quadcut map 'my map.yaml''?");
}

TEST(CommandOf, TwoCommands) {
    EXPECT_EQ(
        error_of({"segment", "follow", "robot.log", "-o", "D"}),
        "'follow': a command after the command segment: did you mean 'quadcut follow robot.log "
        "-o D'?");
    // A folder may be called as a command is.
    EXPECT_EQ(error_of({"segment", "map", "-o", "D"}), "no error");
}

TEST(CommandOf, ActionsOfEdit) {
    EXPECT_EQ(error_of({"rename", "none.quadcut", "3", "Hall"}),
              "unknown command 'rename': did you mean 'quadcut edit none.quadcut rename 3 Hall'?");
    EXPECT_EQ(error_of({"undo"}),
              "unknown command 'undo': did you mean 'quadcut edit PROJECT undo ...'?");
    EXPECT_EQ(error_of({"edit", "rename", "none.quadcut", "3", "Hall"}),
              "edit: 'rename': expected the project first: did you mean 'quadcut edit none.quadcut "
              "rename 3 Hall'?");
    EXPECT_EQ(error_of({"edit", "none.quadcut", "rename", "3", "Hall"}), "no error");
}

TEST(Commands, HaveExamplesThatBeginWithThem) {
    for (const Command& command : commands()) {
        const CommandForm& form = command.form;
        const std::string begin = "quadcut " + form.name;
        const auto num_own =
            std::count_if(form.examples.begin(), form.examples.end(), [&](const std::string& line) {
                return line == begin || line.rfind(begin + " ", 0) == 0 ||
                       line == "quadcut --" + form.name;
            });
        EXPECT_GE(num_own, 2) << form.name;
    }
}

TEST(Commands, SayWhatSetTakes) {
    for (const Command& command : commands()) {
        const bool has_set = find_flag(command.form, kSetFlag) != nullptr;
        EXPECT_EQ(has_set, !command.form.settings.empty()) << command.form.name;
    }
}

TEST(HelpText, BeginsWithTheMostCommonLine) {
    const std::string help = help_text();
    EXPECT_LT(help.find("\n  quadcut segment map.yaml -o rooms\n"), help.find("\n  map "));
}

}  // namespace
}  // namespace quadcut
