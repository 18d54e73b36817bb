// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/check_followed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "quadcut/follow/follower.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut {
namespace {

using io::test::error_of;
using testing::HasSubstr;

TEST(CheckFollowed, WhatContradictsItselfIsRefused) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const auto error_with = [&](const auto& change) {
        FollowedMap state = follower.state();
        change(state);
        return error_of([&] { Follower({}, state); });
    };
    EXPECT_EQ(error_with([](FollowedMap&) {}), "no error");
    EXPECT_THAT(error_with([](FollowedMap& s) { s.rooms.erase(1); }), HasSubstr("not there"));
    EXPECT_THAT(error_with([](FollowedMap& s) { s.next_id = 1; }), HasSubstr("has no id"));
    EXPECT_THAT(error_with([](FollowedMap& s) { s.rooms[2].box.high.x += 100000; }),
                HasSubstr("outside"));
    EXPECT_THAT(error_with([](FollowedMap& s) { --s.rooms[2].num_cells; }), HasSubstr("expected"));
    EXPECT_THAT(error_with([](FollowedMap& s) {
                    s.cells.set_room({20, 20}, 0);
                }),
                HasSubstr("expected"));
    EXPECT_THAT(error_with([](FollowedMap& s) { s.cut_at = s.num_scans + 1; }),
                HasSubstr("after the last scan"));
    EXPECT_THAT(error_with([](FollowedMap& s) {
                    s.changed_tiles[{5000, 0}] = 1;
                }),
                HasSubstr("outside"));
    EXPECT_THAT(error_with([](FollowedMap& s) { ++s.num_changed; }), HasSubstr("changed cells"));
    EXPECT_THAT(error_with([](FollowedMap& s) {
                    s.split_lines.push_back({{0, 0}, {1 << 27, 0}});
                }),
                HasSubstr("outside"));
    EXPECT_THAT(error_of([&] {
                    FollowOptions coarse;
                    coarse.resolution_m = 0.1;
                    Follower(coarse, follower.state());
                }),
                HasSubstr("expected 0.1"));
}

TEST(CheckFollowed, ATileThatCannotBeIsNotAdded) {
    FollowedMap state(0.05);
    state.written = {{0, 0}, {15, 15}};
    Tile log_odds;
    EXPECT_EQ(error_of([&] { add_tile(state, {1, 1}, log_odds, {}); }), "no error");
    EXPECT_THAT(error_of([&] { add_tile(state, {2, 1}, log_odds, {}); }), HasSubstr("outside"));
    log_odds.values[5] = 100;
    EXPECT_THAT(error_of([&] { add_tile(state, {0, 1}, log_odds, {}); }), HasSubstr("log-odds"));
}

}  // namespace
}  // namespace quadcut
