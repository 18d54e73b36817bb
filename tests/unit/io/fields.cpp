// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/fields.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

TEST(Fields, NumbersAreReadWholeOrNotAtAll) {
    EXPECT_EQ(parse_number("1.25"), 1.25);
    EXPECT_EQ(parse_number("-3e-2"), -0.03);
    EXPECT_EQ(parse_number("+.5"), 0.5);
    EXPECT_TRUE(std::isnan(parse_number("nan").value()));
    EXPECT_TRUE(std::isnan(parse_number("-NaN").value()));
    EXPECT_EQ(parse_number("inf"), INFINITY);
    for (const char* text :
         {"", "+", "-", "+-1", "1.2.3", "1,5", "0x10", "1e", "1e999", "5m", " 1"}) {
        EXPECT_FALSE(parse_number(text).has_value()) << text;
    }
}

TEST(Fields, IntegersHoldTheirRange) {
    EXPECT_EQ(parse_integer("180"), 180);
    EXPECT_EQ(parse_integer("-1"), -1);
    for (const char* text : {"", "1.0", "9223372036854775808", "1e3"}) {
        EXPECT_FALSE(parse_integer(text).has_value()) << text;
    }
}

TEST(Fields, WalksOverAnyWhiteSpace) {
    Fields fields("  FLASER\t2 \v1.5  x");
    EXPECT_EQ(fields.next(), "FLASER");
    EXPECT_EQ(fields.next_integer(), 2);
    EXPECT_EQ(fields.next_number(), 1.5);
    EXPECT_EQ(fields.rest(), "  x");
    EXPECT_FALSE(fields.next_number().has_value());
    EXPECT_EQ(fields.next(), "");
    EXPECT_FALSE(fields.next_number().has_value());
}

TEST(Fields, QuotesStayShortAndPrintable) {
    EXPECT_EQ(quote("ab\x01\x80"), "\"ab??\"");
    EXPECT_EQ(quote(std::string(100, 'x')), "\"" + std::string(40, 'x') + "...\"");
}

}  // namespace
}  // namespace quadcut::io
