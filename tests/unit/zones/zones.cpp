// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/zones.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/zones/conductance.hpp"

namespace quadcut {
namespace {

/// Wings of a corridor and `num_rooms` rooms each, corridor to corridor in a row.
Segmentation chain_of_wings(std::uint32_t num_wings, std::uint32_t num_rooms) {
    Segmentation result;
    const std::uint32_t wing_size = num_rooms + 1;
    const auto add_door = [&](std::uint32_t a, std::uint32_t b, double width_m) {
        Door door;
        door.a = RoomId{a};
        door.b = RoomId{b};
        door.width_m = width_m;
        result.doors.push_back(door);
    };
    for (std::uint32_t wing = 0; wing < num_wings; ++wing) {
        const std::uint32_t corridor = wing * wing_size + 1;
        for (std::uint32_t i = 0; i < wing_size; ++i) {
            const std::uint32_t id = corridor + i;
            Room room;
            room.id = RoomId{id};
            room.area_m2 = i == 0 ? 40.0 : 10.0 + 0.1 * id;
            room.label_point = {20.0 * wing + 2.0 * i, i == 0 ? 0.0 : 4.0};
            result.rooms.push_back(room);
            if (i > 0) add_door(corridor, id, 0.8 + 0.01 * i);
        }
        if (wing > 0) add_door(corridor - wing_size, corridor, 0.9);
    }
    return result;
}

std::vector<std::uint32_t> wings_of(std::uint32_t num_wings, std::uint32_t wing_size) {
    std::vector<std::uint32_t> wings;
    for (std::uint32_t i = 0; i < num_wings * wing_size; ++i) wings.push_back(i / wing_size + 1);
    return wings;
}

TEST(Zones, AreTheWingsOfAChainToldOrByTheEigengap) {
    for (const std::uint32_t num_wings : {2U, 3U, 5U}) {
        const Segmentation building = chain_of_wings(num_wings, 14);
        for (const std::size_t count : {std::size_t{0}, std::size_t{num_wings}}) {
            const Zones zones = find_zones(building, {count, ZoneWeights::conductance});
            EXPECT_EQ(zones.count, num_wings) << count;
            EXPECT_EQ(zones.zone_of_room, wings_of(num_wings, 15)) << count;
        }
    }
}

TEST(Zones, NoneAreMadeThatNobodyAskedFor) {
    EXPECT_EQ(find_zones(chain_of_wings(3, 9), {}), Zones{});
    EXPECT_EQ(find_zones(Segmentation{}, {2, ZoneWeights::conductance}), Zones{});
}

TEST(Zones, OneWingIsOneZone) {
    const Zones zones = find_zones(chain_of_wings(1, 30), {0, ZoneWeights::conductance});
    EXPECT_EQ(zones.count, 1U);
    EXPECT_EQ(zones.zone_of_room, std::vector<std::uint32_t>(31, 1));
}

TEST(Zones, TellTheSpectrumAndItsGaps) {
    const Zones zones = find_zones(chain_of_wings(3, 12), {0, ZoneWeights::conductance});
    ASSERT_EQ(zones.eigenvalues.size(), 39U);
    EXPECT_TRUE(std::is_sorted(zones.eigenvalues.begin(), zones.eigenvalues.end()));
    EXPECT_NEAR(zones.eigenvalues[0], 0.0, 1e-9);
    // Two more of cuts between wings, then those of rooms against their corridor: 1.
    EXPECT_LT(zones.eigenvalues[2], 0.2);
    EXPECT_NEAR(zones.eigenvalues[3], 1.0, 0.01);
    ASSERT_EQ(zones.gaps.size(), 38U);
    EXPECT_EQ(zones.gaps[0], 0.0);
    EXPECT_EQ(std::max_element(zones.gaps.begin(), zones.gaps.end()) - zones.gaps.begin(), 2);
}

TEST(Zones, EveryNumberUpToThatOfTheRoomsCanBeHad) {
    const Segmentation building = chain_of_wings(3, 5);
    for (std::size_t count = 1; count <= building.rooms.size(); ++count) {
        const Zones zones = find_zones(building, {count, ZoneWeights::conductance});
        EXPECT_EQ(zones.count, count);
        const std::set<std::uint32_t> used(zones.zone_of_room.begin(), zones.zone_of_room.end());
        EXPECT_EQ(used.size(), count);
        EXPECT_EQ(*used.begin(), 1U);
        EXPECT_EQ(*used.rbegin(), count);
    }
    EXPECT_EQ(find_zones(building, {99, ZoneWeights::conductance}).count, building.rooms.size());
}

TEST(Zones, AreConnectedThroughDoors) {
    const Segmentation building = chain_of_wings(4, 6);
    const Graph doors = conductance_graph(building);
    for (std::size_t count = 1; count <= building.rooms.size(); ++count) {
        const Zones zones = find_zones(building, {count, ZoneWeights::conductance});
        const std::vector<std::uint32_t> part = connected_components(doors, zones.zone_of_room);
        EXPECT_EQ(1 + *std::max_element(part.begin(), part.end()), count);
    }
}

TEST(Zones, AClosedRoomIsOfTheZoneThatIsNearest) {
    Segmentation building = chain_of_wings(2, 9);
    // The last room of the second wing loses its door.
    std::erase_if(building.doors, [](const Door& door) { return door.b == RoomId{20}; });
    const Zones zones = find_zones(building, {2, ZoneWeights::conductance});
    EXPECT_EQ(zones.zone_of_room, wings_of(2, 10));
}

TEST(Zones, BuildingsApartAreZonesFirst) {
    Segmentation building = chain_of_wings(3, 9);
    std::erase_if(building.doors,
                  [](const Door& door) { return door.a == RoomId{11} && door.b == RoomId{21}; });
    const Zones zones = find_zones(building, {2, ZoneWeights::conductance});
    std::vector<std::uint32_t> expected = wings_of(3, 10);
    for (std::uint32_t& wing : expected) wing = wing == 3 ? 2 : 1;
    EXPECT_EQ(zones.zone_of_room, expected);
}

TEST(Zones, OfAGraphInPartsAreAtLeastAsManyAsThese) {
    const std::vector<WeightedEdge> edges{{0, 1, 1.0}, {2, 3, 1.0}};
    const Graph graph = build_graph(edges, {1.0, 2.0, 3.0, 4.0, 5.0});
    const Zones zones = find_zones(graph, {2, ZoneWeights::conductance});
    EXPECT_EQ(zones.zone_of_room, (std::vector<std::uint32_t>{1, 1, 2, 2, 3}));
}

TEST(Zones, AreTheSameInWhateverOrderTheRoomsAre) {
    const Segmentation building = chain_of_wings(4, 7);
    const Graph graph = conductance_graph(building);
    const auto num_rooms = static_cast<std::uint32_t>(graph.num_nodes());
    // 13 and 32 have no common divisor.
    std::vector<std::uint32_t> place(num_rooms);
    std::vector<double> area_m2(num_rooms);
    std::vector<WeightedEdge> edges;
    for (std::uint32_t i = 0; i < num_rooms; ++i) {
        place[i] = (5 + 13 * i) % num_rooms;
        area_m2[place[i]] = graph.area_m2[i];
    }
    for (const Door& door : building.doors) {
        edges.push_back(
            {place[index(door.b) - 1], place[index(door.a) - 1], std::min(door.width_m, 1.0)});
    }
    const Graph moved = build_graph(edges, area_m2);
    for (const std::size_t count : {std::size_t{0}, std::size_t{3}, std::size_t{9}}) {
        const Zones zones = find_zones(graph, {count, ZoneWeights::conductance});
        const Zones others = find_zones(moved, {count, ZoneWeights::conductance});
        ASSERT_EQ(zones.count, others.count);
        for (std::uint32_t i = 0; i < num_rooms; ++i) {
            for (std::uint32_t j = 0; j < num_rooms; ++j) {
                EXPECT_EQ(zones.zone_of_room[i] == zones.zone_of_room[j],
                          others.zone_of_room[place[i]] == others.zone_of_room[place[j]]);
            }
        }
    }
}

TEST(ConductanceGraph, DoorsConductAsTheyAreWideUpToAMetreAndAddUp) {
    Segmentation building = chain_of_wings(1, 2);
    building.doors[0].width_m = 0.7;
    building.doors.push_back(building.doors[0]);
    building.doors[1].width_m = 3.0;
    const Graph graph = conductance_graph(building);
    ASSERT_EQ(graph.num_nodes(), 3U);
    EXPECT_EQ(graph.area_m2[0], 40.0);
    ASSERT_EQ(graph.neighbours(0).size(), 2U);
    EXPECT_DOUBLE_EQ(graph.neighbour_weights(0)[0], 1.4);
    EXPECT_DOUBLE_EQ(graph.neighbour_weights(0)[1], 1.0);
}

TEST(ConductanceGraph, JoinedByNearnessIsConnectedAndKeepsItsDoors) {
    Segmentation building = chain_of_wings(3, 3);
    building.doors.clear();
    const Graph apart = conductance_graph(building);
    EXPECT_EQ(num_edges(apart), 0U);
    const Graph joined = joined_by_nearness(apart, building.rooms);
    const std::vector<std::uint32_t> part = connected_components(joined);
    EXPECT_EQ(*std::max_element(part.begin(), part.end()), 0U);

    const Segmentation whole = chain_of_wings(2, 4);
    const Graph doors = conductance_graph(whole);
    EXPECT_EQ(joined_by_nearness(doors, whole.rooms).weights, doors.weights);
}

}  // namespace
}  // namespace quadcut
