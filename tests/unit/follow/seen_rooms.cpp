// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/seen_rooms.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/follow/follower.hpp"
#include "quadcut/zones/sightings.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/zones/three_rooms.hpp"

namespace quadcut::test {
namespace {

double all_scans(const Covisibility& counts) {
    double all = 0.0;
    for (const auto& [pair, scans] : counts.scans) {
        all += pair.first == pair.second ? scans : 2.0 * scans;
    }
    return all;
}

void expect_like_the_map(const Follower& follower) {
    std::set<std::uint32_t> rooms;
    for (const auto& [id, room] : follower.state().rooms) rooms.insert(id);
    for (const auto& [pair, scans] : follower.state().covisibility.scans) {
        EXPECT_TRUE(rooms.contains(pair.first) && rooms.contains(pair.second));
        EXPECT_LE(pair.first, pair.second);
        EXPECT_GT(scans, 0.0);
    }
}

TEST(SeenRooms, AreCountedScanByScan) {
    const ThreeRooms made = three_rooms();
    Follower follower;
    follower.update_cells(made.map.states);
    ASSERT_EQ(follower.num_rooms(), 3U);
    std::vector<Scan> scans = scans_at(made.map, kFivePlaces);
    for (const Scan& scan : scans) follower.add_scan(scan);
    expect_like_the_map(follower);
    EXPECT_NEAR(all_scans(follower.state().covisibility), 5.0, 1e-9);
    // As by a second look, when the rooms are known.
    const Segmentation rooms = follower.rooms();
    const GridMap map = follower.map().to_grid();
    const Covisibility again = covisibility_of(sightings_of(one_by_one(scans), map, rooms), rooms);
    for (const auto& [pair, count] : again.scans) {
        const auto counted = follower.state().covisibility.scans.find(pair);
        ASSERT_NE(counted, follower.state().covisibility.scans.end());
        EXPECT_NEAR(counted->second, count, 0.03);
    }
}

TEST(SeenRooms, OfRoomsThatPeopleMakeOneAreJoined) {
    const ThreeRooms made = three_rooms();
    Follower follower;
    follower.update_cells(made.map.states);
    for (const Scan& scan : scans_at(made.map, kFivePlaces)) follower.add_scan(scan);
    const RoomId a = follower.room_at(kFivePlaces[0]);
    const RoomId b = follower.room_at(kFivePlaces[2]);
    const double before = all_scans(follower.state().covisibility);
    Edit edit;
    edit.kind = EditKind::merge;
    edit.room = a;
    edit.other = b;
    follower.edit(edit);
    ASSERT_EQ(follower.num_rooms(), 2U);
    expect_like_the_map(follower);
    EXPECT_NEAR(all_scans(follower.state().covisibility), before, 1e-9);
}

TEST(SeenRooms, OfABuildingAreThoseOfASecondLook) {
    const sim::Building building = small_building(3);
    const std::vector<Scan> scans = scans_in(building);
    Follower follower;
    std::set<std::uint32_t> split;
    const auto note = [&](const FollowUpdate& update) {
        for (const RoomEvent& event : update.events) {
            if (event.change != RoomChange::split) continue;
            split.insert(static_cast<std::uint32_t>(event.room));
            split.insert(static_cast<std::uint32_t>(event.other));
        }
    };
    for (const Scan& scan : scans) {
        note(follower.add_scan(scan));
        expect_like_the_map(follower);
    }
    note(follower.finish());
    const Segmentation rooms = follower.rooms();
    const Covisibility again =
        covisibility_of(sightings_of(one_by_one(scans), follower.map().to_grid(), rooms), rooms);
    const double all = all_scans(follower.state().covisibility);
    EXPECT_GT(all, 0.6 * static_cast<double>(scans.size()));
    EXPECT_LE(all, static_cast<double>(scans.size()) + 1e-6);
    // What was seen before the first rooms were there, or by rooms that were one then, is not
    // known.
    double expected = 0.0;
    double apart = 0.0;
    for (const auto& [pair, count] : again.scans) {
        if (split.contains(pair.first) || split.contains(pair.second)) continue;
        const auto counted = follower.state().covisibility.scans.find(pair);
        const bool is_known = counted != follower.state().covisibility.scans.end();
        expected += count;
        apart += std::abs((is_known ? counted->second : 0.0) - count);
    }
    EXPECT_GT(expected, 0.1 * static_cast<double>(scans.size()));
    EXPECT_LT(apart, 0.1 * expected);
}

}  // namespace
}  // namespace quadcut::test
