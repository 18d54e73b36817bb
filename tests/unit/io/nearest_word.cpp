// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/nearest_word.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

using Words = std::vector<std::string_view>;

const Words kOptions{"--output",     "-o",         "--resolution",   "--preset",
                     "--door-width", "door_width", "rooms.min_room", "seed"};

TEST(NearestWord, FewestEditsWin) {
    EXPECT_EQ(nearest_words("granularty", {"resolution", "granularity", "preset"}),
              Words{"granularity"});
    EXPECT_EQ(nearest_words("sub-maps", {"submap", "submaps"}), Words{"submaps"});
    EXPECT_EQ(nearest_words("", {"abcdef"}), Words{});
    EXPECT_EQ(nearest_words("--", {"abcdef"}), Words{});
    EXPECT_EQ(nearest_words("abc", {}), Words{});
}

TEST(NearestWord, LettersThatChangedPlacesAreOneEdit) {
    EXPECT_EQ(nearest_words("mpa", {"map", "edit"}), Words{"map"});
    EXPECT_EQ(nearest_words("sgement", {"segment", "seldom"}), Words{"segment"});
}

TEST(NearestWord, OfAWordWithNothingInCommonNoneIsMeant) {
    EXPECT_EQ(nearest_words("-x", {"-o", "-q"}), Words{});
    EXPECT_EQ(nearest_words("foo", {"map", "demo"}), Words{});
    EXPECT_EQ(nearest_words("xylophone", {"segment", "simulate"}), Words{});
}

TEST(NearestWord, CaseDashesAndUnderscoresPlayNoPart) {
    EXPECT_EQ(nearest_words("--Preset", kOptions), Words{"--preset"});
    EXPECT_EQ(nearest_words("-output", kOptions), Words{"--output"});
    EXPECT_EQ(nearest_words("--door_width", kOptions), (Words{"--door-width", "door_width"}));
}

TEST(NearestWord, BeginningsAndParts) {
    EXPECT_EQ(nearest_words("--out", kOptions), Words{"--output"});
    EXPECT_EQ(nearest_words("--res", kOptions), Words{"--resolution"});
    EXPECT_EQ(nearest_words("--outputs", kOptions), Words{"--output"});
    EXPECT_EQ(nearest_words("segmentation", {"segment", "score"}), Words{"segment"});
    EXPECT_EQ(nearest_words("--width", {"--depth", "--door-width"}), Words{"--door-width"});
}

TEST(NearestWord, TheLastPartNamesAnOption) {
    EXPECT_EQ(nearest_words("min-room", {"rooms.min_passable", "rooms.min_room"}),
              Words{"rooms.min_room"});
    EXPECT_EQ(nearest_words("paper.min_room", {"rooms.min_room", "paper.min_leaf"}),
              Words{"rooms.min_room"});
    EXPECT_EQ(nearest_words("min_leaf", {"rooms.min_leaf", "paper.min_leaf"}),
              (Words{"rooms.min_leaf", "paper.min_leaf"}));
}

TEST(NearestWord, AtMostThree) {
    EXPECT_EQ(nearest_words("a", {"ab", "ac", "ad", "ae"}), (Words{"ab", "ac", "ad"}));
}

TEST(NearestWord, AsText) {
    EXPECT_EQ(suggestion("mpa", {"map", "edit"}), ": did you mean 'map'?");
    EXPECT_EQ(suggestion("a", {"ab", "ac"}), ": did you mean 'ab' or 'ac'?");
    EXPECT_EQ(suggestion("foo", {"map"}, "; none"), "; none");
    EXPECT_EQ(did_you_mean({}), "");
}

TEST(EitherOf, ListsWords) {
    EXPECT_EQ(either_of({}), "");
    EXPECT_EQ(either_of({"a"}), "a");
    EXPECT_EQ(either_of({"a", "b"}), "a or b");
    EXPECT_EQ(either_of({"a", "b", "c"}), "a, b or c");
}

}  // namespace
}  // namespace quadcut::io
