// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_name.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using testing::HasSubstr;

TEST(RoomName, SpacesAtTheEndsGo) {
    EXPECT_EQ(trimmed_room_name(" \t\u00A0\u3000K\u00FCche 2\u200B\n"), "K\u00FCche 2");
    EXPECT_EQ(trimmed_room_name("\u4F1A\u8B70\u5BA4 \U0001F6AA"), "\u4F1A\u8B70\u5BA4 \U0001F6AA");
}

TEST(RoomName, HasOneTo200Characters) {
    std::string name;
    for (int i = 0; i < 200; ++i) name += "\u00E4";
    EXPECT_EQ(trimmed_room_name(name), name);
    EXPECT_THAT(error_of([&] { static_cast<void>(trimmed_room_name(name + "a")); }),
                HasSubstr("of 201 characters: expected 1 to 200"));
    for (const char* const empty : {"", "  ", "\u00A0\u2003\uFEFF"}) {
        EXPECT_THAT(error_of([&] { static_cast<void>(trimmed_room_name(empty)); }),
                    HasSubstr("of 0 characters"));
    }
}

TEST(RoomName, IsTextThatControlsNothing) {
    for (const char* const bytes : {"a\x80", "\xC3", "\xC0\xAF", "\xED\xA0\x80", "\xFF"}) {
        EXPECT_THAT(error_of([&] { static_cast<void>(trimmed_room_name(bytes)); }),
                    HasSubstr("expected UTF-8"));
    }
    EXPECT_EQ(trimmed_room_name("a\uFFFD"), "a\uFFFD");
    for (const char* const name :
         {"a\nb", "a\x1B[31mb", "a\x7Fz", "a\u0085b", "a\u202Eb", "a\u2028b", "a\u2066b"}) {
        EXPECT_THAT(error_of([&] { static_cast<void>(trimmed_room_name(name)); }),
                    HasSubstr("control"));
    }
}

}  // namespace
}  // namespace quadcut::io
