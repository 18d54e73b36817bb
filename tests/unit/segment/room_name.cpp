// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/room_name.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "quadcut/segment/follow.hpp"
#include "tests/unit/io/scratch.hpp"
#include "tests/unit/segment/followed.hpp"

namespace quadcut {
namespace {

using io::test::error_of;
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

TEST(RoomName, DefaultNamesBelongToTheirRooms) {
    EXPECT_EQ(room_with_default_name("room 7"), RoomId{7});
    EXPECT_EQ(room_with_default_name("corridor 12"), RoomId{12});
    for (const char* const name :
         {"room", "room 007", "Room 7 b", "7", "", "cellar 7", "room -1"}) {
        EXPECT_EQ(room_with_default_name(name), RoomId{}) << name;
    }
}

TEST(RoomName, IsNoOtherRooms) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    const std::string number = std::to_string(index(right));
    follower.rename(right, " Store\u00A0");
    EXPECT_THAT(error_of([&] { follower.rename(left, "Store "); }),
                HasSubstr("'Store' is the name of room " + number));
    for (const std::string word : {"room ", "corridor ", "hall "}) {
        EXPECT_THAT(error_of([&] { follower.rename(left, word + number); }),
                    HasSubstr("is the name of room " + number));
        EXPECT_THAT(error_of([&] { follower.rename(left, word + "4711"); }),
                    HasSubstr("is the name of room 4711"))
            << "a room of later has it";
    }
    follower.rename(left, "room " + std::to_string(index(left)));
    follower.rename(right, "Store");
    EXPECT_EQ(follower.followed().at(static_cast<std::uint32_t>(right)).name, "Store");
}

}  // namespace
}  // namespace quadcut
