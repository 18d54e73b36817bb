// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/message.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

TEST(ShownMessage, IsOneLineOfText) {
    EXPECT_EQ(shown_message("a\nb\tc\x7F"), "a?b?c?");
    EXPECT_EQ(shown_message("K\xC3\xBC"
                            "che m\xC2\xB2"),
              "K\xC3\xBC"
              "che m\xC2\xB2");
    EXPECT_EQ(shown_message("\xFF\xC3 x"), "?? x");
    // C1's escape, and a direction that would turn the rest.
    EXPECT_EQ(shown_message("\xC2\x9B"
                            "2J \xE2\x80\xAE"
                            "gpm"),
              "?2J ?gpm");
    EXPECT_EQ(shown_message("two  spaces "), "two  spaces ");
}

TEST(ShownMessage, LongWordsKeepTheirEnds) {
    const std::string folder(300, 'a');
    const std::string shown = shown_message("/" + folder + "/map.yaml: no");
    EXPECT_EQ(shown.size(), 90U + 3U);
    EXPECT_EQ(shown.substr(0, 4), "/aaa");
    EXPECT_NE(shown.find("...a"), std::string::npos);
    EXPECT_EQ(shown.substr(shown.size() - 13), "/map.yaml: no");
    const std::string usual(90, 'b');
    EXPECT_EQ(shown_message(usual + " " + usual), usual + " " + usual);
}

TEST(ShownMessage, CharactersStayWhole) {
    std::string word;
    for (int i = 0; i < 200; ++i) word += "\xE2\x82\xAC";
    const std::string shown = shown_message(word);
    EXPECT_EQ(shown.size(), 3U * 87U + 3U);
    EXPECT_EQ(shown.find('?'), std::string::npos);
}

TEST(ShownMessage, ManyWordsAreCutToo) {
    std::string message;
    for (int i = 0; i < 50000; ++i) message += "a ";
    EXPECT_EQ(shown_message(message).size(), 1000U);
}

TEST(WithoutLongWords, OfWhatWasTypedTheMiddleIsLeftOut) {
    std::string words = "x";
    for (int i = 0; i < 50000; ++i) words += " y";
    const std::vector<std::string> typed{"--set", "short", words, "--set=name=" + words};
    for (const std::string& word : {words, "name=" + words}) {
        const std::string message =
            without_long_words("'" + word + "': not short: did you mean 'z'?", typed);
        EXPECT_LT(message.size(), 140U) << message;
        EXPECT_NE(message.find("': not short: did you mean 'z'?"), std::string::npos);
    }
}

}  // namespace
}  // namespace quadcut
