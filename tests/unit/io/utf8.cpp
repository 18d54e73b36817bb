// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/utf8.hpp"

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

std::string again(std::string_view bytes) {
    std::string text;
    for (const char32_t code_point : decode_utf8(bytes)) append_utf8(text, code_point);
    return text;
}

TEST(Utf8, ReadsAndWritesAllLengths) {
    EXPECT_EQ(decode_utf8("a\u00E4\u20AC\U0001F6AA"), U"a\u00E4\u20AC\U0001F6AA");
    EXPECT_EQ(again("a\u00E4\u20AC\U0001F6AA"), "a\u00E4\u20AC\U0001F6AA");
    EXPECT_EQ(again(std::string_view("\0", 1)), std::string_view("\0", 1));
}

TEST(Utf8, ReplacesWhatIsNoText) {
    EXPECT_EQ(decode_utf8("a\x80z"), U"a\uFFFDz");                // A continuation of nothing.
    EXPECT_EQ(decode_utf8("\xE2\x82"), U"\uFFFD\uFFFD");          // Cut short.
    EXPECT_EQ(decode_utf8("\xC0\xAF"), U"\uFFFD\uFFFD");          // Overlong.
    EXPECT_EQ(decode_utf8("\xED\xA0\x80").front(), 0xFFFDU);      // A surrogate.
    EXPECT_EQ(decode_utf8("\xF4\x90\x80\x80").front(), 0xFFFDU);  // Beyond the last one.
    EXPECT_EQ(decode_utf8("\xFFz"), U"\uFFFDz");
}

}  // namespace
}  // namespace quadcut::io
