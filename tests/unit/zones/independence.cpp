// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/independence.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/zones/three_rooms.hpp"

namespace quadcut::test {
namespace {

std::vector<Sighting> five_sightings(const ThreeRooms& made) {
    return sightings_of(one_by_one(scans_at(made.map, kFivePlaces)), made.map, made.rooms);
}

TEST(Independence, OfRoomsIsCountedByHand) {
    const ThreeRooms made = three_rooms();
    const Independence rooms = independence_of_rooms(five_sightings(made), made.map, made.rooms);
    EXPECT_EQ(rooms.num_parts, 3U);
    EXPECT_EQ(rooms.num_scans, 5U);
    EXPECT_EQ(rooms.num_pairs(), 3U);
    // a and b are seen by all but the scan in c; the one in the door sees both, and stands at it.
    const std::vector<PairIndependence> expected{{10, 20, 1, {4, 1}, {3, 0}},
                                                 {20, 30, 1, {4, 1}, {3, 0}}};
    EXPECT_EQ(rooms.pairs, expected);
    EXPECT_EQ(num_independent(rooms.pairs, &PairIndependence::all), 0U);
    EXPECT_EQ(num_independent(rooms.pairs, &PairIndependence::given_doors), 2U);
    EXPECT_DOUBLE_EQ(rooms.pairs[0].all.share(), 0.25);
}

TEST(Independence, OfZonesIsThatOfTheirRoomsTogether) {
    const ThreeRooms made = three_rooms();
    const std::vector<std::uint32_t> zones{1, 1, 2};
    const Independence found =
        independence_of_zones(five_sightings(made), made.map, made.rooms, zones);
    EXPECT_EQ(found.num_parts, 2U);
    const std::vector<PairIndependence> expected{{1, 2, 1, {5, 1}, {4, 0}}};
    EXPECT_EQ(found.pairs, expected);
}

TEST(Independence, WhatIsSeenOutsideIsCountedInCellsOfScansThatStandInAPart) {
    const ThreeRooms made = three_rooms();
    const std::vector<Sighting> sightings{
        {{}, 1, {{1, 60}, {2, 30}, {3, 10}}}, {{}, 3, {{3, 100}}}, {{}, 0, {{1, 500}}}};
    const Independence rooms = independence_of_rooms(sightings, made.map, made.rooms);
    EXPECT_EQ(rooms.num_scans, 2U);
    EXPECT_DOUBLE_EQ(rooms.seen_outside, 40.0 / 200.0);
    const Independence zones =
        independence_of_zones(sightings, made.map, made.rooms, std::vector<std::uint32_t>{1, 1, 2});
    EXPECT_DOUBLE_EQ(zones.seen_outside, 10.0 / 200.0);
}

TEST(Independence, WithoutScansIsNone) {
    const ThreeRooms made = three_rooms();
    const Independence rooms = independence_of_rooms({}, made.map, made.rooms);
    EXPECT_EQ(rooms.seen_outside, 0.0);
    ASSERT_EQ(rooms.pairs.size(), 2U) << "the doors are there";
    EXPECT_EQ(rooms.pairs[0].all, SharedScans{});
    EXPECT_EQ(rooms.pairs[0].all.share(), 0.0);
}

}  // namespace
}  // namespace quadcut::test
