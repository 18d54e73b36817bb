// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/number_text.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

TEST(NumberText, RoundsAndDropsZeros) {
    EXPECT_EQ(rounded(12.5), "12.5");
    EXPECT_EQ(rounded(3.0), "3");
    EXPECT_EQ(rounded(100.0, 0), "100");
    EXPECT_EQ(rounded(0.0006), "0.001");
    EXPECT_EQ(rounded(-1.25, 1), "-1.2");
    EXPECT_EQ(rounded(1e15), "1000000000000000");
}

TEST(NumberText, HasNoNegativeZero) {
    EXPECT_EQ(rounded(-0.0), "0");
    EXPECT_EQ(rounded(-0.0001), "0");
}

TEST(NumberText, HasWordsForWhatIsNoNumber) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(rounded(std::numeric_limits<double>::quiet_NaN()), "null");
    EXPECT_EQ(rounded(infinity), "null");
    EXPECT_EQ(exact(std::numeric_limits<double>::quiet_NaN()), "NaN");
    EXPECT_EQ(exact(infinity), "Infinity");
    EXPECT_EQ(exact(-infinity), "-Infinity");
}

TEST(NumberText, ReadsBackExactly) {
    EXPECT_EQ(exact(0.05), "0.05");
    EXPECT_EQ(exact(-12.0), "-12.0");
    EXPECT_EQ(exact(1e-9), "1e-09");
    for (const double value : {1.0 / 3.0, 1e300, 2.3e-308, -0.1, 123456789.123456789}) {
        EXPECT_EQ(std::stod(exact(value)), value);
    }
}

}  // namespace
}  // namespace quadcut::io
