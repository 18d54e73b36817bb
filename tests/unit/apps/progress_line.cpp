// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/progress_line.hpp"

#include <string>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

ProgressState sample() { return {"follow", 0.47, 11.2, 1840.3, "scans", "12 rooms"}; }

TEST(ProgressLine, SaysAllInAWideTerminal) {
    const std::string bar(18, '#');
    EXPECT_EQ(progress_line(sample(), 200), "follow  [" + bar + std::string(22, '.') +
                                                "]   47 %  12 s left    1840 scans/s  12 rooms");
}

TEST(ProgressLine, NeverIsWiderThanItMay) {
    for (std::size_t width = 0; width <= 220; ++width) {
        ProgressState state = sample();
        EXPECT_LE(progress_line(state, width).size(), width);
        state.share.reset();
        EXPECT_LE(progress_line(state, width).size(), width);
        state.stage = "a stage with a very long name that does not fit into a narrow terminal";
        state.share = 1.0;
        EXPECT_LE(progress_line(state, width).size(), width);
    }
}

TEST(ProgressLine, WhatMattersLeastGoesFirst) {
    const auto has = [](std::size_t width, const std::string& text) {
        return progress_line(sample(), width).find(text) != std::string::npos;
    };
    for (const std::string text : {"47 %", "12 s left", "1840 scans/s", "[####", "12 rooms"}) {
        EXPECT_TRUE(has(79, text)) << text;
    }
    EXPECT_FALSE(has(59, "rooms"));
    for (const std::string text : {"47 %", "12 s left", "1840 scans/s", "[####"}) {
        EXPECT_TRUE(has(59, text)) << text;
    }
    EXPECT_FALSE(has(42, "["));
    EXPECT_TRUE(has(42, "1840 scans/s"));
    EXPECT_FALSE(has(30, "scans"));
    EXPECT_TRUE(has(30, "12 s left"));
    EXPECT_EQ(progress_line(sample(), 15), "follow   47 %");
    EXPECT_EQ(progress_line(sample(), 4), "foll");
}

TEST(ProgressLine, TheBarKeepsItsLengthWhileTheNumbersChange) {
    ProgressState state = sample();
    const auto end_of_bar = [&state] { return progress_line(state, 70).find(']'); };
    const std::size_t end = end_of_bar();
    state.share = 1.0;
    state.left_s = 55 * 60.0;
    EXPECT_EQ(end_of_bar(), end);
    state.left_s.reset();
    state.rate.reset();
    EXPECT_EQ(end_of_bar(), end);
}

TEST(ProgressLine, WithoutALengthThereIsNoBar) {
    EXPECT_EQ(progress_line({"read", {}, {}, {}, {}, {}}, 80), "read ...");
}

TEST(ProgressLine, TimesInWords) {
    EXPECT_EQ(in_words(0.0), "1 s");
    EXPECT_EQ(in_words(11.2), "12 s");
    EXPECT_EQ(in_words(59.5), "1 min");
    EXPECT_EQ(in_words(121.0), "3 min");
    EXPECT_EQ(in_words(3599.0), "1 h");
    EXPECT_EQ(in_words(7300.0), "3 h");
    EXPECT_EQ(in_words(1e9), "more than a day");
}

}  // namespace
}  // namespace quadcut
