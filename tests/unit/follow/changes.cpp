// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/follow/change_log.hpp"
#include "quadcut/follow/follower.hpp"
#include "tests/unit/follow/followed.hpp"

namespace quadcut {
namespace {

bool is_same(const FollowedRoom& p, const FollowedRoom& q) {
    return static_cast<const RoomSettings&>(p) == q && p.num_cells == q.num_cells;
}

/// What differs between two states, looked for everywhere.
Changes differences(const FollowedMap& before, const FollowedMap& after) {
    Changes changes;
    std::set<RoomId> rooms;
    const auto note = [&](std::uint32_t id) {
        if (id != 0) rooms.insert(RoomId{id});
    };
    Box tiles = after.map.written_tiles();
    if (!before.written.is_empty()) tiles.include(before.map.written_tiles());
    for_each_cell(tiles, [&](Cell tile) {
        const RoomTile& was = before.cells.tile(tile);
        const RoomTile& is = after.cells.tile(tile);
        if (was != is || before.map.tile(tile).values != after.map.tile(tile).values) {
            changes.tiles.push_back(tile);
        }
        for (std::size_t i = 0; i < kTileCells; ++i) {
            if (was.rooms[i] == is.rooms[i]) continue;
            note(was.rooms[i]);
            note(is.rooms[i]);
        }
    });
    for (const auto* const state : {&before, &after}) {
        const auto& others = state == &before ? after.rooms : before.rooms;
        for (const auto& [id, room] : state->rooms) {
            const auto other = others.find(id);
            if (other == others.end() || !is_same(room, other->second)) note(id);
        }
    }
    changes.rooms.assign(rooms.begin(), rooms.end());
    std::set<DoorId> doors;
    for (const auto* const state : {&before, &after}) {
        const auto& others = state == &before ? after.doors : before.doors;
        for (const auto& [id, door] : state->doors) {
            const auto other = others.find(id);
            if (other == others.end() || other->second != door) doors.insert(id);
        }
    }
    changes.doors.assign(doors.begin(), doors.end());
    return changes;
}

bool is_before(Cell p, Cell q) { return std::pair(p.y, p.x) < std::pair(q.y, q.x); }

void expect_tells(const Changes& told, const Changes& expected) {
    EXPECT_TRUE(std::is_sorted(told.tiles.begin(), told.tiles.end(), is_before));
    EXPECT_TRUE(std::includes(told.tiles.begin(), told.tiles.end(), expected.tiles.begin(),
                              expected.tiles.end(), is_before));
    EXPECT_TRUE(std::includes(told.rooms.begin(), told.rooms.end(), expected.rooms.begin(),
                              expected.rooms.end()));
    EXPECT_TRUE(std::includes(told.doors.begin(), told.doors.end(), expected.doors.begin(),
                              expected.doors.end()));
}

/// A change that makes the follower cut a part of the hall again, or an edit.
void change(Follower& follower, Random& random) {
    const auto x = static_cast<std::int32_t>(random.below(200)) + 20;
    const auto y = static_cast<std::int32_t>(random.below(70)) + 20;
    const CellState state = random.below(2) == 0 ? CellState::occupied : CellState::free;
    switch (random.below(4)) {
        case 0:
            follower.update_cells(Raster<CellState>({x, y}, 12, 12, state));
            break;
        case 1:
            follower.update_cells(Raster<CellState>({100, 50}, 4, 18, state));
            break;
        case 2:
            follower.edit(test::rename(RoomId{follower.state().rooms.begin()->first},
                                       "name " + std::to_string(x)));
            break;
        default:
            follower.refine();
    }
}

TEST(Changes, TellAllThatDiffersToEveryListener) {
    Follower follower;
    Random random(5);
    struct Listener {
        FollowedMap then;
    };
    std::vector<Listener> listeners{{follower.state()}};
    follower.update_cells(test::hall_with_wall());
    for (int round = 0; round < 24; ++round) {
        change(follower, random);
        for (const Listener& listener : listeners) {
            const Changes told = follower.changes_since(listener.then.revision);
            EXPECT_EQ(told.revision, follower.state().revision);
            expect_tells(told, differences(listener.then, follower.state()));
        }
        // One begins to listen now and then; one has heard all.
        if (round % 6 == 0) listeners.push_back({follower.state()});
        listeners[random.below(listeners.size())].then = follower.state();
    }
    EXPECT_EQ(follower.changes_since(follower.state().revision).size(), 0U);
}

TEST(Changes, OfAnUpdateAreThoseSinceTheOneBefore) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const std::uint64_t before = follower.state().revision;
    const FollowUpdate update =
        follower.update_cells(Raster<CellState>({150, 60}, 12, 12, CellState::occupied));
    EXPECT_EQ(update.changes.revision, before + 1);
    const Changes since = follower.changes_since(before);
    EXPECT_EQ(since.tiles, update.changes.tiles);
    EXPECT_EQ(since.rooms, update.changes.rooms);
    EXPECT_FALSE(update.changes.tiles.empty());
    EXPECT_EQ(update.changes.rooms.size(), 1U) << "the other room is as it was";
}

TEST(Changes, NothingNewIsNoRevision) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    follower.finish();
    const std::uint64_t before = follower.state().revision;
    EXPECT_EQ(follower.finish().changes.revision, before);
    const RoomId room{1};
    EXPECT_EQ(follower.edit(test::lock(room)).update.changes.revision, before + 1);
    EXPECT_EQ(follower.changes_since(before).rooms, std::vector{room});
    EXPECT_TRUE(follower.changes_since(before).tiles.empty());
}

TEST(Changes, ARoomThatEndsIsAmongThem) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const RoomId left = follower.room_at({2.0, 3.0});
    const RoomId right = follower.room_at({9.0, 3.0});
    ASSERT_EQ(follower.state().doors.size(), 1U);
    const Changes changes = follower.edit(test::merge(left, right)).update.changes;
    EXPECT_EQ(changes.rooms, (std::vector{std::min(left, right), std::max(left, right)}));
    EXPECT_EQ(changes.doors.size(), 1U);
    EXPECT_TRUE(follower.state().doors.empty());
}

TEST(Changes, WhoGoesOnFromASavedStateTellsTheOthersAll) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    const std::uint64_t early = follower.state().revision;
    const RoomId left = follower.room_at({2.0, 3.0});
    follower.edit(test::merge(left, follower.room_at({9.0, 3.0})));
    Follower later({}, follower.state());
    const Changes all = later.changes_since(early);
    EXPECT_EQ(all.rooms.size(), 2U) << "the room that is no more, too";
    expect_tells(all, differences(FollowedMap(0.05), later.state()));
    EXPECT_EQ(later.changes_since(later.state().revision).size(), 0U);
    const std::uint64_t saved = later.state().revision;
    later.edit(test::rename(left, "Hall"));
    EXPECT_EQ(later.changes_since(saved).rooms, std::vector{left});
}

TEST(ChangeLog, DoesNotGrowWithTimeAndForgetsNothing) {
    ChangeLog log;
    Random random(2);
    std::vector<Changes> all;
    for (std::uint64_t revision = 1; revision <= 3000; ++revision) {
        Changes changes;
        changes.revision = revision;
        for (int i = 0; i < 20; ++i) {
            changes.tiles.push_back({static_cast<std::int32_t>(random.below(40)),
                                     static_cast<std::int32_t>(random.below(40))});
        }
        changes.rooms.push_back(RoomId{static_cast<std::uint32_t>(1 + random.below(9))});
        changes = tidied(std::move(changes));
        log.add(changes);
        all.push_back(changes);
        if (revision % 100 != 0) continue;
        const std::uint64_t since = random.below(revision);
        Changes expected;
        for (const Changes& one : all) {
            if (one.revision <= since) continue;
            expected.tiles.insert(expected.tiles.end(), one.tiles.begin(), one.tiles.end());
            expected.rooms.insert(expected.rooms.end(), one.rooms.begin(), one.rooms.end());
        }
        expected = tidied(std::move(expected));
        EXPECT_EQ(log.since(since).tiles, expected.tiles);
        EXPECT_EQ(log.since(since).rooms, expected.rooms);
    }
    EXPECT_LT(log.size(), 12000U) << "1609 keys changed 63000 times";
}

}  // namespace
}  // namespace quadcut
