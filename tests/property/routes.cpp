// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// Ways over rooms and doors against A* over all cells, on simulated buildings.

#include <optional>

#include <gtest/gtest.h>

#include "bench/cell_search.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/route/route_planner.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "sim/building.hpp"

namespace quadcut {
namespace {

Cell random_place(const RobotFloor& floor, Random& random) {
    for (;;) {
        const std::size_t offset = random.below(floor.clearance_m.values.size());
        if (floor.clearance_m.values[offset] >= floor.radius_m) {
            return floor.clearance_m.cell(offset);
        }
    }
}

TEST(Routes, AreAsShortAsByAllCells) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        sim::BuildingOptions options;
        options.seed = seed;
        options.num_rooms = 14;
        options.furniture = seed % 2 == 0 ? 0.7 : 0.0;
        const GridMap map = sim::generate_building(options).map;
        const Segmentation rooms = segment(map, SegmentOptions{});
        RoutePlanner planner(map, rooms, 0.5);
        CellSearch cells(planner.floor());
        Random random(seed);
        double length = 0.0;
        double length_by_cells = 0.0;
        for (int i = 0; i < 40; ++i) {
            const Cell from = random_place(planner.floor(), random);
            const Cell to = random_place(planner.floor(), random);
            const CellWay by_cells = cells.find(from, to);
            const std::optional<Route> route = planner.find(from, to);
            ASSERT_EQ(by_cells.cells.empty(), !route) << "seed " << seed << ", pair " << i;
            if (!route) continue;
            const double cells_long = route->length_m / map.resolution_m;
            // Bends keep off the walls, which tells on short ways.
            EXPECT_LT(cells_long, 1.03 * by_cells.length + 6.0) << "seed " << seed << ", " << i;
            EXPECT_GT(cells_long, 0.92 * by_cells.length - 1.0) << "seed " << seed << ", " << i;
            length += cells_long;
            length_by_cells += by_cells.length;
        }
        EXPECT_LT(length, 1.0 * length_by_cells) << "seed " << seed;
    }
}

TEST(Routes, LeadThroughRoomsThatTouch) {
    sim::BuildingOptions options;
    options.seed = 3;
    options.num_rooms = 14;
    const GridMap map = sim::generate_building(options).map;
    const Segmentation rooms = segment(map, SegmentOptions{});
    RoutePlanner planner(map, rooms, 0.5);
    Random random(1);
    for (int i = 0; i < 40; ++i) {
        const Cell from = random_place(planner.floor(), random);
        const Cell to = random_place(planner.floor(), random);
        const std::optional<Route> route = planner.find(from, to);
        if (!route) continue;
        const auto room_at = [&](Cell cell) {
            return rooms.rooms[rooms.labels.at(cell) - std::size_t{1}].id;
        };
        RoomId room = route->first_room;
        EXPECT_EQ(room, room_at(from));
        double after_m = 0.0;
        for (const RouteStep& step : route->steps) {
            EXPECT_EQ(step.from, room);
            EXPECT_GE(step.after_m, after_m);
            EXPECT_TRUE(step.door) << "all openings of a simulated building are doors";
            room = step.to;
            after_m = step.after_m;
        }
        EXPECT_EQ(room, room_at(to));
        EXPECT_LE(after_m, route->length_m);
    }
}

}  // namespace
}  // namespace quadcut
