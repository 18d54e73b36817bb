// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/sentence.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace quadcut::reproduce {
namespace {

TEST(Sentence, NumbersAreWrittenAsTheyAreRead) {
    EXPECT_EQ(in_words(17300.0), "17,300");
    EXPECT_EQ(in_words(1234567.8), "1,234,568");
    EXPECT_EQ(in_words(999.0), "999");
    EXPECT_EQ(in_words(-1500.0), "-1,500");
    EXPECT_EQ(in_words(43.0), "43");
    EXPECT_EQ(in_words(12.34), "12.3");
    EXPECT_EQ(in_words(0.0123), "0.0123");
    EXPECT_EQ(in_words(0.0), "0");
    EXPECT_EQ(in_words(std::numeric_limits<double>::infinity()), "no number");
}

TEST(Sentence, SpeedSaysWhichIsFaster) {
    EXPECT_EQ(speed_against(100.0, 17300.0), "173 times as fast as");
    EXPECT_EQ(speed_against(86.0, 43.0), "2 times as slow as");
    EXPECT_EQ(speed_against(43.0, 44.0), "about as fast as");
}

}  // namespace
}  // namespace quadcut::reproduce
