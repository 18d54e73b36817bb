// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/file.hpp"
#include "quadcut/follow/edit.hpp"
#include "quadcut/follow/follower.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut {
namespace {

using io::test::error_of;
using testing::HasSubstr;

/// The door of hall_with_wall().
void set_door(Follower& follower, CellState state) {
    follower.update_cells(Raster<CellState>({100, 50}, 4, 18, state));
}

/// All that people see and set: cells, names, groups, locks, lines.
std::string all_of(const Follower& follower) {
    std::string text;
    const Segmentation rooms = follower.rooms();
    std::string labels;
    for (const std::uint16_t label : rooms.labels.values) labels += static_cast<char>(label);
    text += std::to_string(io::hash_bytes(labels));
    for (const auto& [id, room] : follower.state().rooms) {
        text += "\n" + std::to_string(id) + " " + room.name + " " +
                std::to_string(room.merge_group) + (room.is_locked ? " locked " : " ") +
                std::to_string(room.num_cells);
    }
    std::set<std::int32_t> lines;
    for (const SplitLine& line : follower.state().split_lines) lines.insert(line.from.x);
    for (const std::int32_t x : lines) text += "\nline at " + std::to_string(x);
    return text;
}

TEST(EditInverse, TakesEachEditBackAndMakesItAgain) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    const std::vector<std::function<Edited()>> edits{
        [&] { return follower.edit(test::rename(left, "Kitchen")); },
        [&] {
            return follower.edit(test::split({9.0, 1.0}, {9.0, 5.0}));
        },
        [&] { return follower.edit(test::rename(left, "Bath")); },
        [&] { return follower.edit(test::merge(left, right)); },
        [&] {
            return follower.edit(test::split({3.0, 1.0}, {3.0, 5.0}));
        },
        [&] {
            return follower.edit(test::merge(left, follower.room_at({11.0, 3.0})));
        },
        [&] { return follower.edit(test::lock(left)); },
        [&] { return follower.edit(test::unlock(left)); }};
    std::vector<std::string> states{all_of(follower)};
    std::vector<Reversal> inverses;
    for (const auto& edit : edits) {
        inverses.push_back(edit().inverse);
        states.push_back(all_of(follower));
    }
    for (int round = 0; round < 2; ++round) {
        for (std::size_t i = edits.size(); i-- > 0;) {
            inverses[i] = follower.apply(inverses[i]).inverse;
            ASSERT_EQ(all_of(follower), states[i]) << i;
        }
        for (std::size_t i = 0; i < edits.size(); ++i) {
            inverses[i] = follower.apply(inverses[i]).inverse;
            ASSERT_EQ(all_of(follower), states[i + 1]) << i;
        }
    }
}

TEST(EditInverse, FloorSeenSinceAMergeGoesToTheRoomThatItTouches) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    follower.edit(test::rename(right, "Store"));
    const Edited merged = follower.edit(test::merge(left, right));
    // On the right the wall gives way to more floor.
    follower.update_cells(Raster<CellState>({250, 10}, 40, 100, CellState::free));
    ASSERT_EQ(follower.room_at({14.0, 3.0}), left);
    const Edited undone = follower.apply(merged.inverse);
    EXPECT_EQ(undone.update.events.front().change, RoomChange::split);
    EXPECT_EQ(follower.room_at({2.0, 3.0}), left);
    EXPECT_EQ(follower.room_at({9.0, 3.0}), right);
    EXPECT_EQ(follower.room_at({14.0, 3.0}), right);
    EXPECT_EQ(follower.state().rooms.at(static_cast<std::uint32_t>(right)).name, "Store");
    // They stay apart: nobody says any more that they are one.
    set_door(follower, CellState::occupied);
    set_door(follower, CellState::free);
    EXPECT_EQ(follower.num_rooms(), 2U);
    EXPECT_EQ(follower.room_at({14.0, 3.0}), right);
}

TEST(EditInverse, WhatCameApartByItselfGetsItsOldIdBack) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    const Edited merged = follower.edit(test::merge(right, left));
    set_door(follower, CellState::occupied);
    ASSERT_EQ(follower.num_rooms(), 2U);
    ASSERT_NE(follower.room_at({2.0, 3.0}), left);
    follower.apply(merged.inverse);
    EXPECT_EQ(follower.num_rooms(), 2U);
    EXPECT_EQ(follower.room_at({2.0, 3.0}), left);
    EXPECT_EQ(follower.room_at({9.0, 3.0}), right);
}

TEST(EditInverse, IsRefusedWhereItsRoomsHaveGone) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    const Edited renamed = follower.edit(test::rename(left, "Kitchen"));
    const Edited merged = follower.edit(test::merge(right, left));
    follower.update_cells(Raster<CellState>({10, 10}, 94, 100, CellState::occupied));
    ASSERT_EQ(follower.num_rooms(), 1U);
    const std::string before = all_of(follower);
    EXPECT_THAT(error_of([&] { follower.apply(merged.inverse); }),
                HasSubstr("is not there any more"));
    EXPECT_THAT(error_of([&] { follower.apply(renamed.inverse); }), HasSubstr("there is no room"));
    EXPECT_EQ(all_of(follower), before);
}

TEST(EditInverse, OfASplitTakesItsLineBackWhereverItsRoomsEnd) {
    Follower follower;
    follower.update_cells(test::bare_hall());
    const RoomId hall = follower.room_at({9.0, 3.0});
    const Edited split = follower.edit(test::split({4.0, 1.0}, {4.0, 5.0}));
    follower.update_cells(Raster<CellState>({150, 60}, 12, 12, CellState::occupied));
    ASSERT_EQ(follower.num_rooms(), 2U);
    follower.apply(split.inverse);
    EXPECT_TRUE(follower.state().split_lines.empty());
    follower.update_cells(Raster<CellState>({150, 60}, 12, 12, CellState::free));
    EXPECT_EQ(follower.num_rooms(), 1U);
    EXPECT_EQ(follower.room_at({2.0, 3.0}), hall);
}

TEST(EditInverse, WhatWasSeenInALockedRoomCountsOnceItIsUnlocked) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    follower.edit(test::lock(left));
    follower.update_cells(Raster<CellState>({40, 40}, 20, 20, CellState::occupied));
    const auto number = static_cast<std::uint32_t>(left);
    const std::size_t cells = follower.state().rooms.at(number).num_cells;
    const Edited unlocked = follower.edit(test::unlock(left));
    EXPECT_EQ(follower.state().rooms.at(number).num_cells, cells - 400U);
    const Segmentation rooms = follower.rooms();
    const Raster<CellState> states = follower.map().to_grid().states;
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        ASSERT_TRUE(rooms.labels.values[i] == 0 || states.values[i] == CellState::free);
    }
    follower.apply(unlocked.inverse);
    EXPECT_TRUE(follower.state().rooms.at(number).is_locked);
    EXPECT_THAT(error_of([&] { follower.edit(test::lock(left)); }), HasSubstr("locked already"));
}

TEST(EditInverse, RoomsOfAGroupAreOneWithItAgain) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    const std::string before = all_of(follower);
    const Edited merged = follower.edit(test::merge(left, right));
    const Edited undone = follower.apply(merged.inverse);
    EXPECT_EQ(all_of(follower), before);
    follower.apply(undone.inverse);
    set_door(follower, CellState::occupied);
    ASSERT_EQ(follower.num_rooms(), 2U);
    set_door(follower, CellState::free);
    EXPECT_EQ(follower.num_rooms(), 1U) << "made again, it holds again";
}

TEST(EditInverse, OfAnotherMapIsRefused) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    Reversal edit;
    edit.room = left;
    edit.border = Reversal::Border::part;
    for (const std::uint32_t other : {0U, 1U, 2U, 3U, 4711U}) {
        edit.other = RoomId{other};
        EXPECT_NE(error_of([&] { follower.apply(edit); }), "no error") << other;
    }
    edit.cells[{1 << 25, -(1 << 25)}] = ~std::uint64_t{0};
    EXPECT_NE(error_of([&] { follower.apply(edit); }), "no error");
    edit.border = Reversal::Border::join;
    for (const std::uint32_t other : {0U, static_cast<std::uint32_t>(left), 4711U}) {
        edit.other = RoomId{other};
        EXPECT_NE(error_of([&] { follower.apply(edit); }), "no error") << other;
    }
}

}  // namespace
}  // namespace quadcut
