// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/zones.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/segment/segment.hpp"
#include "quadcut/zones/conductance.hpp"
#include "sim/building.hpp"

// What must hold of the zones of every building.

namespace quadcut {
namespace {

Segmentation rooms_of(std::size_t draw) {
    sim::BuildingOptions options;
    options.seed = 900 + draw;
    options.num_rooms = 20 + 9 * static_cast<int>(draw);
    options.furniture = 0.5;
    return segment(sim::generate_building(options).map);
}

/// The rooms in another order, with the ids that they had.
Segmentation shuffled(Segmentation rooms, std::uint64_t seed) {
    Random random(seed);
    for (std::size_t i = rooms.rooms.size(); i > 1; --i) {
        std::swap(rooms.rooms[i - 1], rooms.rooms[random.below(i)]);
    }
    std::reverse(rooms.doors.begin(), rooms.doors.end());
    return rooms;
}

TEST(ZonesOfBuildings, AreSetsOfRoomsConnectedThroughDoorsWhereTheseAre) {
    for (std::size_t draw = 0; draw < 4; ++draw) {
        const Segmentation rooms = rooms_of(draw);
        const Graph graph = joined_by_nearness(conductance_graph(rooms), rooms.rooms);
        for (const std::size_t count : {std::size_t{0}, std::size_t{2}, std::size_t{7}}) {
            const Zones zones = find_zones(rooms, {count, ZoneWeights::conductance});
            ASSERT_EQ(zones.zone_of_room.size(), rooms.rooms.size());
            EXPECT_TRUE(count == 0 || zones.count == count);
            const std::vector<std::uint32_t> part = connected_components(graph, zones.zone_of_room);
            EXPECT_EQ(1 + *std::max_element(part.begin(), part.end()), zones.count) << draw;
        }
    }
}

TEST(ZonesOfBuildings, DependOnNoOrderOfTheRooms) {
    for (std::size_t draw = 0; draw < 4; ++draw) {
        const Segmentation rooms = rooms_of(draw);
        for (const std::size_t count : {std::size_t{0}, std::size_t{5}}) {
            const ZoneOptions options{count, ZoneWeights::conductance};
            const Zones zones = find_zones(rooms, options);
            EXPECT_EQ(find_zones(rooms, options), zones);
            const Segmentation others = shuffled(rooms, draw);
            const Zones again = find_zones(others, options);
            std::map<std::uint32_t, std::uint32_t> same;
            for (std::size_t i = 0; i < others.rooms.size(); ++i) {
                const std::uint32_t before = zones.zone_of_room[index(others.rooms[i].id) - 1];
                const auto known = same.emplace(before, again.zone_of_room[i]).first;
                EXPECT_EQ(known->second, again.zone_of_room[i]) << draw;
            }
            EXPECT_EQ(same.size(), again.count);
        }
    }
}

}  // namespace
}  // namespace quadcut
