// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/misunderstanding.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

using Words = std::vector<std::string>;

CommandForm sample_form() {
    CommandForm form;
    form.name = "paint";
    form.operands = {"WALL"};
    form.flags = {
        {"--output", "-o", "DIR", "where to", true}, {"--door-width", "", "M", "how wide"},
        {"--preset", "", "NAME", "which"},           {"--poses", "", "FILE", "where"},
        {"--set", "", "NAME=VALUE", "any option"},   {"--quiet", "", "", "no word"}};
    form.settings = {"door_width", "rooms.min_room", "rooms.min_leaf", "paper.min_leaf"};
    return form;
}

std::string error_of(const Words& words, const CommandForm& form = sample_form()) {
    try {
        static_cast<void>(parse_arguments(form, words));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

/// What is suggested for these words, after the wall and its output.
std::string meant(const Words& words) {
    Words all{"north", "-o", "out"};
    all.insert(all.end(), words.begin(), words.end());
    const std::string error = error_of(all);
    const std::size_t start = error.find("did you mean ");
    return start == std::string::npos ? error : error.substr(start + 13);
}

TEST(Misunderstanding, FlagsAreSuggestedAsTheyAreWritten) {
    EXPECT_EQ(error_of({"north", "--out", "x"}), "unknown option '--out': did you mean '-o DIR'?");
    EXPECT_EQ(error_of({"north", "--out-dir=x"}),
              "unknown option '--out-dir': did you mean '-o DIR'?");
    EXPECT_EQ(meant({"--door_width", "3"}), "'--door-width M'?");
    EXPECT_EQ(meant({"-preset", "x"}), "'--preset NAME'?");
    EXPECT_EQ(meant({"--Quiet"}), "'--quiet'?");
    EXPECT_EQ(meant({"-p"}), "'--preset NAME' or '--poses FILE'?");
    EXPECT_EQ(error_of({"north", "-oout"}), "unknown option '-oout': did you mean '-o out'?");
    EXPECT_EQ(error_of({"north", "--folder", "x"}),
              "unknown option '--folder': did you mean '-o DIR'?");
    EXPECT_EQ(meant({"--bananas"}),
              "unknown option '--bananas'; 'quadcut paint --help' lists the options");
}

TEST(Misunderstanding, AnOptionWithoutAFlagIsSetBySet) {
    EXPECT_EQ(meant({"--min-room", "3"}), "'--set rooms.min_room=3'?");
    EXPECT_EQ(meant({"--min-room=3"}), "'--set rooms.min_room=3'?");
    EXPECT_EQ(meant({"--min-room"}), "'--set rooms.min_room=X'?");
    EXPECT_EQ(meant({"--min-room", "map.yaml"}), "'--set rooms.min_room=X'?");
    EXPECT_EQ(meant({"--min-leaf", "3"}), "'--set rooms.min_leaf=3' or '--set paper.min_leaf=3'?");
}

TEST(Misunderstanding, WhatFollowsSet) {
    EXPECT_EQ(meant({"--set", "min_room=3"}), "'--set rooms.min_room=3'?");
    EXPECT_EQ(meant({"--set", "rooms.min_room", "3"}), "'--set rooms.min_room=3'?");
    EXPECT_EQ(meant({"--set", "door_width", "3"}), "'--set door_width=3'?");
    EXPECT_EQ(meant({"--set", "output=x"}), "'-o DIR'?");
    EXPECT_EQ(meant({"--set", "min_room="}), "'--set rooms.min_room=X'?");
    EXPECT_EQ(meant({"--set", "bananas=3"}),
              "unknown option 'bananas'; 'quadcut options' lists them");
    EXPECT_EQ(meant({"--set", "bananas"}),
              "option --set: 'bananas': expected NAME=VALUE; 'quadcut options' lists them");
    EXPECT_EQ(meant({"--set", "door_width=3"}), "no error");
    EXPECT_EQ(meant({"--set", "follow.min_change=3"}),
              "unknown option 'follow.min_change': follow has it, not paint");
}

TEST(Misunderstanding, TheFolderThatIsMissing) {
    EXPECT_EQ(error_of({"my wall", "--quiet"}),
              "missing -o DIR (where to): for example 'quadcut paint 'my wall' --quiet -o rooms'");
    EXPECT_EQ(error_of({"north", "out", "--quiet"}),
              "unexpected 'out': did you mean 'quadcut paint north --quiet -o out'?");
}

TEST(Misunderstanding, DashesOfAWordProcessorAndDashesThatAreMissing) {
    EXPECT_EQ(meant({"\xE2\x80\x93o", "x"}), "'-o DIR'?");
    EXPECT_EQ(meant({"\xE2\x80\x94quiet"}), "'--quiet'?");
    EXPECT_EQ(meant({"min_room=3"}), "'--set rooms.min_room=3'?");
}

TEST(Misunderstanding, FlagsOfOtherCommands) {
    EXPECT_EQ(meant({"--speed", "3"}), "unknown option '--speed': follow has it, not paint");
    CommandForm form = sample_form();
    form.settings.emplace_back("every");
    EXPECT_EQ(error_of({"north", "-o", "out", "--every", "3"}, form),
              "unknown option '--every': did you mean '--set every=3'?");
}

TEST(Misunderstanding, OneAtATime) {
    const std::string file = QUADCUT_SOURCE_DIR "/README.md";
    EXPECT_NE(error_of({"north", file}).find("takes one WALL at a time"), std::string::npos);
    EXPECT_EQ(
        error_of({"north", "south", "-o", "out"}),
        "unexpected 'south': paint takes one WALL at a time; usage: quadcut paint WALL -o DIR "
        "[options]");
    EXPECT_EQ(error_of({"-o", "out"}), "missing WALL; usage: quadcut paint WALL -o DIR [options]");
}

TEST(Misunderstanding, Actions) {
    CommandForm form;
    form.name = "edit";
    form.operands = {"WALL", "ACTION"};
    form.actions = {"paint", "paper"};
    EXPECT_EQ(error_of({"north", "paint"}, form), "no error");
    EXPECT_EQ(error_of({"north", "pain"}, form),
              "edit: 'pain': expected paint or paper: did you mean 'paint'?");
    EXPECT_EQ(error_of({"north", "move"}, form), "edit: 'move': expected paint or paper");
}

}  // namespace
}  // namespace quadcut
