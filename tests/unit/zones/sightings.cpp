// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/sightings.hpp"

#include <bit>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/map/integrate.hpp"
#include "tests/unit/zones/three_rooms.hpp"

namespace quadcut::test {
namespace {

using Labels = std::vector<std::uint32_t>;

std::vector<Labels> all_seen(const std::vector<Sighting>& sightings, const ThreeRooms& made) {
    std::vector<Labels> seen;
    for (const Sighting& sighting : sightings) {
        seen.push_back(labels_seen(sighting, made.map, made.rooms));
    }
    return seen;
}

TEST(Sightings, OnlyFromTheDoorsTwoRoomsAreSeen) {
    const ThreeRooms made = three_rooms();
    const std::vector<Sighting> sightings =
        sightings_of(one_by_one(scans_at(made.map, kFivePlaces)), made.map, made.rooms);
    EXPECT_EQ(all_seen(sightings, made), (std::vector<Labels>{{1}, {1, 2}, {2}, {2, 3}, {3}}));
    Labels own;
    for (const Sighting& sighting : sightings) own.push_back(sighting.own);
    EXPECT_EQ(own, (Labels{1, 1, 2, 2, 3}));
    EXPECT_EQ(sightings[0].at, kFivePlaces[0]);
    // From within a room all of it, but what lies along its walls.
    EXPECT_NEAR(sightings[4].floors.back().num_cells * 0.0025, 3.5 * 6.0, 1.0);
}

TEST(Sightings, AreTheSameInAnotherFrameAndOnAnyNumberOfThreads) {
    ThreeRooms made = three_rooms();
    std::vector<Point> places;
    for (int i = 0; i < 600; ++i) places.push_back(kFivePlaces[static_cast<std::size_t>(i % 5)]);
    std::vector<Scan> scans = scans_at(made.map, places);
    const std::vector<Sighting> one =
        sightings_of(one_by_one(scans), made.map, made.rooms, {}, Executor{1});
    ASSERT_EQ(one.size(), places.size());
    const std::vector<Sighting> two =
        sightings_of(one_by_one(scans), made.map, made.rooms, {}, Executor{2});
    made.map.map_from_image = {-40.0, 10.0, 1.0};
    for (Scan& scan : scans) {
        scan.world_from_sensor = compose(made.map.map_from_image, scan.world_from_sensor);
    }
    const std::vector<Sighting> moved = sightings_of(one_by_one(scans), made.map, made.rooms);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].floors, two[i].floors) << i;
        EXPECT_EQ(one[i].own, moved[i].own) << i;
        ASSERT_EQ(one[i].floors.size(), moved[i].floors.size()) << i;
        for (std::size_t k = 0; k < one[i].floors.size(); ++k) {
            EXPECT_NEAR(one[i].floors[k].num_cells, moved[i].floors[k].num_cells, 20.0) << i;
        }
    }
}

TEST(Sightings, CountWhatTheMappingOfTheScanCounts) {
    const ThreeRooms made = three_rooms();
    const std::vector<Scan> scans = scans_at(made.map, {kFivePlaces[1]});
    OccupancyMap map(made.map.resolution_m);
    std::size_t num_free = 0;
    for (const std::uint64_t free : integrate_scan(map, scans[0]).observed_free) {
        num_free += static_cast<std::size_t>(std::popcount(free));
    }
    std::size_t num_seen = 0;
    for (const Sighting& sighting : sightings_of(one_by_one(scans), made.map, made.rooms)) {
        for (const SeenFloor& floor : sighting.floors) num_seen += floor.num_cells;
    }
    EXPECT_GT(num_seen, num_free - num_free / 100);
    EXPECT_LE(num_seen, num_free + num_free / 100);
}

TEST(Sightings, CountByTheIdsOfTheRooms) {
    const ThreeRooms made = three_rooms();
    const std::vector<Sighting> sightings{{{}, 1, {{1, 30}, {3, 10}}}};
    const Covisibility counts = covisibility_of(sightings, made.rooms);
    ASSERT_EQ(counts.scans.size(), 3U);
    EXPECT_DOUBLE_EQ(counts.scans.at({10, 30}), 3.0 / 16.0);
}

TEST(Sightings, ARoomIsSeenByASquareMetreOrByHalfOfIt) {
    EXPECT_TRUE(is_seen(1.0, 50.0));
    EXPECT_FALSE(is_seen(0.99, 50.0));
    EXPECT_TRUE(is_seen(0.5, 1.0));
    EXPECT_FALSE(is_seen(0.0, 0.0));
}

}  // namespace
}  // namespace quadcut::test
