// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/room_cells.hpp"

#include <map>
#include <utility>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

TEST(RoomCells, HoldWhatWasSetWhereverItLies) {
    RoomCells cells;
    Random random(7);
    std::map<std::pair<int, int>, std::uint32_t> expected;
    for (int i = 0; i < 5000; ++i) {
        const Cell cell{static_cast<std::int32_t>(random.below(4000)) - 2000,
                        static_cast<std::int32_t>(random.below(300)) - 50};
        const auto room = static_cast<std::uint32_t>(random.below(5));
        cells.set_room(cell, room);
        expected[{cell.x, cell.y}] = room;
    }
    for (const auto& [at, room] : expected) EXPECT_EQ(cells.room({at.first, at.second}), room);
    EXPECT_EQ(cells.room({100000, -100000}), 0U);
}

TEST(RoomCells, SayWhatChanges) {
    RoomCells cells;
    EXPECT_FALSE(cells.set_room({0, 0}, 0));
    EXPECT_FALSE(cells.contains({0, 0})) << "nothing has changed";
    EXPECT_TRUE(cells.set_room({17, 9}, 3));
    EXPECT_TRUE(cells.set_cut_free({-1, -1}, true));
    EXPECT_FALSE(cells.set_room({17, 9}, 3)) << "the same again is no change";
    EXPECT_FALSE(cells.set_cut_free({-1, -1}, true));
    EXPECT_TRUE(cells.set_cut_free({-1, -1}, false));
    EXPECT_EQ(cells.tile({-1, -1}), RoomTile{});
    EXPECT_TRUE(cells.is_beside({17, 10}, 3));
    EXPECT_FALSE(cells.is_beside({18, 10}, 3));
}

}  // namespace
}  // namespace quadcut
