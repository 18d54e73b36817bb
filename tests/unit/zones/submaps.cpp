// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/submaps.hpp"

#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "quadcut/map/connected_parts.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "sim/building.hpp"

namespace quadcut {
namespace {

Segmentation submaps_of(const GridMap& map, std::size_t count) {
    SegmentOptions options;
    options.paper.num_submaps = count;
    return joined_into_submaps(segment(map, options), count, map);
}

sim::Building building_of_24() {
    sim::BuildingOptions options;
    options.seed = 77;
    options.num_rooms = 24;
    return sim::generate_building(options);
}

/// Rooms in the order of their ids, with the labels' area, connected, and doors between them.
void expect_sound(const Segmentation& result, const GridMap& map) {
    std::map<std::uint16_t, std::size_t> cells;
    for (const std::uint16_t label : result.labels.values) ++cells[label];
    cells.erase(0);
    ASSERT_EQ(cells.size(), result.rooms.size());
    EXPECT_EQ(result.next_id, result.rooms.size() + 1);
    for (std::size_t i = 0; i < result.rooms.size(); ++i) {
        EXPECT_EQ(index(result.rooms[i].id), i + 1);
        const double cell_m2 = map.resolution_m * map.resolution_m;
        const auto label = static_cast<std::uint16_t>(i + 1);
        EXPECT_NEAR(result.rooms[i].area_m2, static_cast<double>(cells[label]) * cell_m2, 1e-6);
        Raster<CellState> own({0, 0}, map.states.width, map.states.height, CellState::occupied);
        for (std::size_t k = 0; k < own.values.size(); ++k) {
            if (result.labels.values[k] == label) own.values[k] = CellState::free;
        }
        EXPECT_EQ(free_parts(own).count, 1U) << "room " << label;
    }
    for (const Door& door : result.doors) {
        EXPECT_LT(door.a, door.b);
        EXPECT_LE(index(door.b), result.rooms.size());
    }
}

TEST(SubmapsOfRooms, AreAsManyAsAskedFor) {
    const sim::Building building = building_of_24();
    const std::size_t num_rooms = segment(building.map).rooms.size();
    for (const std::size_t count : {std::size_t{2}, std::size_t{5}, num_rooms, num_rooms + 3}) {
        const Segmentation result = submaps_of(building.map, count);
        EXPECT_EQ(result.rooms.size(), count);
        EXPECT_TRUE(result.report.warnings.empty());
        expect_sound(result, building.map);
    }
}

TEST(SubmapsOfRooms, AreNestedOverTheRooms) {
    const sim::Building building = building_of_24();
    const Segmentation rooms = segment(building.map);
    const Segmentation few = submaps_of(building.map, 4);
    const Segmentation many = submaps_of(building.map, rooms.rooms.size() + 4);
    std::map<std::uint16_t, std::set<std::uint16_t>> submaps_of_room;
    std::map<std::uint16_t, std::set<std::uint16_t>> rooms_of_part;
    for (std::size_t i = 0; i < rooms.labels.values.size(); ++i) {
        if (rooms.labels.values[i] == 0) continue;
        submaps_of_room[rooms.labels.values[i]].insert(few.labels.values[i]);
        rooms_of_part[many.labels.values[i]].insert(rooms.labels.values[i]);
    }
    for (const auto& [room, submaps] : submaps_of_room) EXPECT_EQ(submaps.size(), 1U) << room;
    for (const auto& [part, own] : rooms_of_part) EXPECT_EQ(own.size(), 1U) << part;
}

TEST(SubmapsOfRooms, AsManyAsRoomsAreTheRooms) {
    const sim::Building building = building_of_24();
    const Segmentation rooms = segment(building.map);
    const Segmentation same = submaps_of(building.map, rooms.rooms.size());
    EXPECT_EQ(same.labels.values, rooms.labels.values);
    EXPECT_EQ(same.doors, rooms.doors);
}

TEST(SubmapsOfRooms, WarnWhereTheNumberCannotBeHad) {
    const sim::Building building = building_of_24();
    const Segmentation many = submaps_of(building.map, 1500);
    EXPECT_LT(many.rooms.size(), 1500U);
    ASSERT_EQ(many.report.warnings.size(), 1U);
    EXPECT_NE(many.report.warnings[0].find("asked for 1500 submaps, found " +
                                           std::to_string(many.rooms.size())),
              std::string::npos);

    // Two halls that no door joins are two regions at least.
    GridMap halls;
    halls.states = Raster<CellState>({0, 0}, 260, 120, CellState::occupied);
    for (std::int32_t y = 10; y < 110; ++y) {
        for (std::int32_t x = 10; x < 250; ++x) {
            if (x < 120 || x >= 130) halls.states.at({x, y}) = CellState::free;
        }
    }
    const Segmentation two = submaps_of(halls, 1);
    EXPECT_EQ(two.rooms.size(), 2U);
    ASSERT_EQ(two.report.warnings.size(), 1U);
    EXPECT_NE(two.report.warnings[0].find("that no doors join"), std::string::npos);
}

}  // namespace
}  // namespace quadcut
