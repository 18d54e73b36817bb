// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/bend.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace quadcut::sim {
namespace {

Building building() {
    BuildingOptions options;
    options.seed = 8;
    options.num_rooms = 10;
    options.furniture = 0.3;
    return generate_building(options);
}

double height_of(const Building& building) {
    return building.map.states.height * building.map.resolution_m;
}

std::uint16_t label_at(const Building& building, const Point& p) {
    const GridMap& map = building.bare;
    const Cell cell{
        static_cast<std::int32_t>(std::floor((p.x - map.map_from_image.x) / map.resolution_m)),
        static_cast<std::int32_t>(std::floor((p.y - map.map_from_image.y) / map.resolution_m))};
    return building.bare_labels.contains(cell) ? building.bare_labels.at(cell) : std::uint16_t{0};
}

Point middle_of(const Polygon& polygon) {
    Point sum;
    for (const Point& p : polygon) sum = {sum.x + p.x, sum.y + p.y};
    const auto n = static_cast<double>(polygon.size());
    return {sum.x / n, sum.y / n};
}

TEST(Bend, RoomsStayWhereTheirFloorsAre) {
    const Building straight = building();
    for (const double side : {1.0, -1.0}) {
        const Building arc = bent(straight, side * 3.0 * height_of(straight));
        ASSERT_EQ(arc.rooms.size(), straight.rooms.size());
        for (std::size_t i = 0; i < arc.rooms.size(); ++i) {
            const TrueRoom& room = arc.rooms[i];
            // A corridor's bow may leave the middle of its corners outside.
            if (room.kind == RoomKind::corridor) continue;
            EXPECT_EQ(label_at(arc, middle_of(room.floor.front())), i + 1) << room.name;
            EXPECT_NEAR(room.area_m2 / straight.rooms[i].area_m2, 1.0, 0.3);
        }
        for (std::size_t i = 0; i < arc.doors.size(); ++i) {
            EXPECT_NEAR(arc.doors[i].width_m / straight.doors[i].width_m, 1.0, 0.26);
        }
    }
}

TEST(Bend, AWideArcChangesLittle) {
    const Building straight = building();
    const Building arc = bent(straight, 1e6);
    for (std::size_t i = 0; i < arc.doors.size(); ++i) {
        EXPECT_NEAR(arc.doors[i].jamb_1.x, straight.doors[i].jamb_1.x, 0.01);
        EXPECT_NEAR(arc.doors[i].jamb_1.y, straight.doors[i].jamb_1.y, 0.01);
    }
    const auto num_free = [](const Building& b) {
        return std::count(b.map.states.values.begin(), b.map.states.values.end(), CellState::free);
    };
    EXPECT_NEAR(static_cast<double>(num_free(arc)) / static_cast<double>(num_free(straight)), 1.0,
                0.01);
}

TEST(Bend, RefusesATightArc) { EXPECT_THROW((void)bent(building(), 1.0), std::logic_error); }

}  // namespace
}  // namespace quadcut::sim
