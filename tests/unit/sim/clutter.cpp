// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/clutter.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"
#include "sim/building.hpp"

namespace quadcut::sim {
namespace {

Building building(double clutter) {
    BuildingOptions options;
    options.seed = 21;
    options.num_rooms = 16;
    options.furniture = 1.0;
    options.clutter = clutter;
    return generate_building(options);
}

std::size_t num_free(const Building& building) {
    const auto& states = building.map.states.values;
    return static_cast<std::size_t>(std::count(states.begin(), states.end(), CellState::free));
}

TEST(Clutter, LeavesRoomsAndDoorsAsTheyAre) {
    const Building tidy = building(0.0);
    const Building full = building(1.0);
    EXPECT_EQ(tidy.bare.states.values, full.bare.states.values);
    EXPECT_EQ(tidy.bare_labels.values, full.bare_labels.values);
    ASSERT_EQ(tidy.rooms.size(), full.rooms.size());
    ASSERT_EQ(tidy.doors.size(), full.doors.size());
    for (std::size_t i = 0; i < full.labels.values.size(); ++i) {
        const bool is_free = full.map.states.values[i] == CellState::free;
        if (!is_free) continue;
        ASSERT_EQ(full.labels.values[i], full.bare_labels.values[i]);
    }
}

TEST(Clutter, TakesFloorByDegrees) {
    const std::size_t tidy = num_free(building(0.0));
    const std::size_t some = num_free(building(0.4));
    const std::size_t full = num_free(building(1.0));
    EXPECT_LT(some, tidy);
    EXPECT_LT(full, some);
}

TEST(Clutter, KeepsDoorwaysFree) {
    const Building full = building(1.0);
    for (const TrueDoor& door : full.doors) {
        const Point middle{0.5 * (door.jamb_1.x + door.jamb_2.x),
                           0.5 * (door.jamb_1.y + door.jamb_2.y)};
        const GridMap& map = full.map;
        const Cell cell{static_cast<std::int32_t>(
                            std::floor((middle.x - map.map_from_image.x) / map.resolution_m)),
                        static_cast<std::int32_t>(
                            std::floor((middle.y - map.map_from_image.y) / map.resolution_m))};
        EXPECT_EQ(map.states.at(cell), CellState::free);
    }
}

TEST(Clutter, IsFromNoughtToOne) {
    EXPECT_THROW((void)building(-0.1), InputError);
    EXPECT_THROW((void)building(1.1), InputError);
}

}  // namespace
}  // namespace quadcut::sim
