// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// What must hold for the counts of any scans.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/zones/independence.hpp"

namespace quadcut {
namespace {

constexpr std::uint32_t kNumRooms = 12;

struct Building {
    GridMap map;
    Segmentation rooms;
    std::vector<Sighting> sightings;
};

Building random_building(std::uint64_t seed) {
    Random random(seed);
    Building building;
    for (std::uint32_t id = 1; id <= kNumRooms; ++id) {
        Room room;
        room.id = RoomId{id};
        room.area_m2 = random.uniform(0.5, 30.0);
        building.rooms.rooms.push_back(room);
    }
    for (int i = 0; i < 15; ++i) {
        Door door;
        door.a = RoomId{1 + static_cast<std::uint32_t>(random.below(kNumRooms))};
        door.b = RoomId{1 + static_cast<std::uint32_t>(random.below(kNumRooms))};
        door.jamb_1 = {random.uniform(0.0, 20.0), random.uniform(0.0, 20.0)};
        door.jamb_2 = {door.jamb_1.x + random.uniform(-1.0, 1.0), door.jamb_1.y};
        building.rooms.doors.push_back(door);
    }
    for (int i = 0; i < 200; ++i) {
        Sighting sighting;
        sighting.at = {random.uniform(0.0, 20.0), random.uniform(0.0, 20.0)};
        sighting.own = static_cast<std::uint32_t>(random.below(kNumRooms + 1));
        for (std::uint32_t label = 1; label <= kNumRooms; ++label) {
            if (random.below(3) != 0) continue;
            sighting.floors.push_back({label, 1 + static_cast<std::uint32_t>(random.below(900))});
        }
        building.sightings.push_back(sighting);
    }
    return building;
}

TEST(ZonesCovisibility, TheGraphIsSymmetricAndEachScanCountsOne) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Building building = random_building(seed);
        const Graph graph =
            covisibility_graph(covisibility_of(building.sightings, building.rooms), building.rooms);
        double all = 0.0;
        for (std::uint32_t a = 0; a < graph.num_nodes(); ++a) {
            for (std::size_t k = 0; k < graph.neighbours(a).size(); ++k) {
                const std::uint32_t b = graph.neighbours(a)[k];
                const auto back =
                    std::lower_bound(graph.neighbours(b).begin(), graph.neighbours(b).end(), a) -
                    graph.neighbours(b).begin();
                ASSERT_EQ(graph.neighbour_weights(a)[k],
                          graph.neighbour_weights(b)[static_cast<std::size_t>(back)]);
                all += graph.neighbour_weights(a)[k];
            }
        }
        const auto num_seeing =
            std::count_if(building.sightings.begin(), building.sightings.end(),
                          [](const Sighting& sighting) { return !sighting.floors.empty(); });
        EXPECT_NEAR(all, static_cast<double>(num_seeing), 1e-9) << seed;
    }
}

TEST(ZonesCovisibility, ConditioningTakesScansAway) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Building building = random_building(seed);
        const Independence rooms =
            independence_of_rooms(building.sightings, building.map, building.rooms);
        ASSERT_FALSE(rooms.pairs.empty());
        ASSERT_LE(rooms.pairs.size(), rooms.num_pairs());
        for (const PairIndependence& pair : rooms.pairs) {
            EXPECT_LT(pair.a, pair.b);
            EXPECT_LE(pair.all.both, pair.all.either);
            EXPECT_LE(pair.given_doors.both, pair.given_doors.either);
            EXPECT_LE(pair.given_doors.both, pair.all.both);
            EXPECT_LE(pair.given_doors.either, pair.all.either);
            EXPECT_TRUE(pair.num_doors != 0 || pair.given_doors == pair.all);
        }
    }
}

TEST(ZonesCovisibility, JoiningRoomsIsCountingThemAsOne) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Building building = random_building(seed);
        Covisibility joined = covisibility_of(building.sightings, building.rooms);
        join_rooms(joined, 5, 9);
        join_rooms(joined, 9, 2);
        for (Sighting& sighting : building.sightings) {
            std::uint32_t cells = 0;
            std::erase_if(sighting.floors, [&](const SeenFloor& floor) {
                const bool is_one = floor.room == 2 || floor.room == 5 || floor.room == 9;
                cells += is_one ? floor.num_cells : 0;
                return is_one;
            });
            if (cells != 0) sighting.floors.push_back({2, cells});
        }
        const Covisibility expected = covisibility_of(building.sightings, building.rooms);
        ASSERT_EQ(joined.scans.size(), expected.scans.size());
        for (const auto& [pair, scans] : expected.scans) {
            EXPECT_NEAR(joined.scans.at(pair), scans, 1e-9);
        }
    }
}

TEST(ZonesCovisibility, MoreZonesSeeMoreOutside) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Building building = random_building(seed);
        double last = 0.0;
        for (std::uint32_t count = 1; count <= kNumRooms; count *= 2) {
            std::vector<std::uint32_t> zones;
            for (std::uint32_t room = 0; room < kNumRooms; ++room) zones.push_back(room % count);
            const double outside =
                independence_of_zones(building.sightings, building.map, building.rooms, zones)
                    .seen_outside;
            EXPECT_GE(outside, last) << "each is a part of one before";
            last = outside;
        }
    }
}

}  // namespace
}  // namespace quadcut
