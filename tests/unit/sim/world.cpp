// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/world.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace quadcut::sim {
namespace {

Building building() {
    BuildingOptions options;
    options.seed = 8;
    options.num_rooms = 10;
    options.furniture = 0.0;
    options.open_leaves = 0.0;
    options.turned_wings = 0.0;
    return generate_building(options);
}

CellState state_at(const GridMap& map, const Point& p) {
    const Cell cell{
        static_cast<std::int32_t>(std::floor((p.x - map.map_from_image.x) / map.resolution_m)),
        static_cast<std::int32_t>(std::floor((p.y - map.map_from_image.y) / map.resolution_m))};
    return map.states.at(cell);
}

Point middle(const TrueDoor& door) {
    return {0.5 * (door.jamb_1.x + door.jamb_2.x), 0.5 * (door.jamb_1.y + door.jamb_2.y)};
}

TEST(World, IsTheBuildingWhereNothingIsAskedFor) {
    const Building plan = building();
    const World world = draw_world(plan, {});
    for (std::size_t i = 0; i < plan.map.states.values.size(); ++i) {
        if (plan.map.states.values[i] == CellState::unknown) continue;
        const Cell cell = plan.map.states.cell(i);
        const Point at{plan.map.map_from_image.x + (cell.x + 0.5) * plan.map.resolution_m,
                       plan.map.map_from_image.y + (cell.y + 0.5) * plan.map.resolution_m};
        ASSERT_EQ(state_at(world.map, at), plan.map.states.values[i]);
    }
    for (const std::uint8_t glass : world.glass.values) ASSERT_EQ(glass, 0);
}

TEST(World, ClosedDoorsAreShutButThoseBetweenCorridors) {
    const Building plan = building();
    WorldOptions options;
    options.closed_doors = 1.0;
    const World world = draw_world(plan, options);
    const auto is_corridor = [&](RoomId room) {
        return plan.rooms[static_cast<std::size_t>(room) - 1].kind == RoomKind::corridor;
    };
    std::size_t num_shut = 0;
    for (const TrueDoor& door : plan.doors) {
        const bool is_open = door.is_open_passage || (is_corridor(door.a) && is_corridor(door.b));
        EXPECT_EQ(state_at(world.map, middle(door)),
                  is_open ? CellState::free : CellState::occupied);
        if (!is_open) ++num_shut;
    }
    EXPECT_GT(num_shut, 3U);
}

TEST(World, GlassStandsInWallsAndLooksAcrossThem) {
    const Building plan = building();
    WorldOptions options;
    options.windows = 1.0;
    options.glass_walls = 1.0;
    const World world = draw_world(plan, options);
    std::set<int> normals;
    std::size_t num_glass = 0;
    for (std::size_t i = 0; i < world.glass.values.size(); ++i) {
        if (world.glass.values[i] == 0) continue;
        ++num_glass;
        normals.insert(world.glass.values[i] - 1);
        EXPECT_EQ(world.map.states.values[i], CellState::occupied);
    }
    EXPECT_GT(num_glass, 200U);
    EXPECT_EQ(normals, (std::set<int>{0, 90}));
}

TEST(World, DoorsAjarStandAcrossTheirOpening) {
    const Building plan = building();
    WorldOptions options;
    options.doors_ajar = 1.0;
    const World world = draw_world(plan, options);
    std::size_t num_more = 0;
    for (const TrueDoor& door : plan.doors) {
        // A leaf hangs at one of the jambs.
        if (door.is_open_passage) continue;
        const Point m = middle(door);
        for (const Point& jamb : {door.jamb_1, door.jamb_2}) {
            const Point near{jamb.x + 0.06 * (m.x - jamb.x), jamb.y + 0.06 * (m.y - jamb.y)};
            if (state_at(world.map, near) == CellState::occupied) ++num_more;
        }
        EXPECT_EQ(state_at(plan.map, m), CellState::free);
    }
    EXPECT_GT(num_more, 3U);
}

TEST(World, LegsOfFurnitureAreThinAndCupboardsAreNot) {
    BuildingOptions options;
    options.seed = 8;
    options.num_rooms = 10;
    options.furniture = 1.0;
    const World world = draw_world(generate_building(options), {});
    std::size_t num_thin = 0;
    std::size_t num_solid = 0;
    for (std::size_t i = 0; i < world.glass.values.size(); ++i) {
        if (world.glass.values[i] == World::kThin) ++num_thin;
        if (world.glass.values[i] == 0 && world.map.states.values[i] == CellState::occupied) {
            ++num_solid;
        }
    }
    EXPECT_GT(num_thin, 50U);
    EXPECT_GT(num_solid, 20 * num_thin);
}

}  // namespace
}  // namespace quadcut::sim
