// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/edit_text.hpp"

#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/follow/followed.hpp"

namespace quadcut {
namespace {

std::vector<EditRecord> some_history() {
    Edit split = test::split({1.0, 2.0}, {1.0, 4.5});
    split.room = RoomId{3};
    split.other = RoomId{8};
    return {{1, 10, test::rename(RoomId{3}, "Hall"), EditState::done},
            {2, 20, test::merge(RoomId{3}, RoomId{4}), EditState::dropped},
            {3, 20, split, EditState::undone},
            {4, 30, test::lock(RoomId{3}), EditState::fixed}};
}

TEST(EditText, TellsTheHistory) {
    EXPECT_EQ(history_text({}), "no edits\n");
    EXPECT_EQ(history_text(some_history()),
              "1  scan 10  rename room 3 to Hall\n"
              "2  scan 20  merge room 4 into room 3  (undone for good)\n"
              "3  scan 20  split room 8 from room 3 between (1.00, 2.00) and (1.00, 4.50)  "
              "(undone)\n"
              "4  scan 30  lock room 3\n");
}

TEST(EditText, AsJson) {
    const nlohmann::json json = nlohmann::json::parse(history_json(some_history()));
    ASSERT_EQ(json.size(), 4U);
    EXPECT_EQ(json[0], nlohmann::json::parse(R"({"number": 1, "scan": 10, "kind": "rename",
        "room": 3, "name": "Hall", "is_undone": false, "can_be_redone": false})"));
    EXPECT_EQ(json[1].at("is_undone"), true);
    EXPECT_EQ(json[1].at("can_be_redone"), false);
    EXPECT_EQ(json[2].at("line"), nlohmann::json::parse("[[1.0, 2.0], [1.0, 4.5]]"));
    EXPECT_EQ(json[2].at("can_be_redone"), true);
}

TEST(EditText, TellsWhatHasBecomeOfARoom) {
    EXPECT_EQ(story_of(test::rename(RoomId{3}, "Hall")), "room 3 is now called Hall");
    EXPECT_EQ(story_of(test::merge(RoomId{3}, RoomId{4})), "room 4 is now part of room 3");
    EXPECT_EQ(story_of(test::lock(RoomId{3})), "room 3 keeps its border");
    EXPECT_EQ(story_of(test::unlock(RoomId{3})), "room 3 changes with what is seen");
    EXPECT_EQ(story_of(some_history()[2].edit),
              "room 8 is now apart from room 3, between (1.00, 2.00) and (1.00, 4.50)");
}

}  // namespace
}  // namespace quadcut
