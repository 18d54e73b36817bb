// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/lost_frame.hpp"

#include <gtest/gtest.h>

#include "quadcut/segment/segment.hpp"
#include "sim/building.hpp"

namespace quadcut {
namespace {

GridMap building_map() {
    sim::BuildingOptions options;
    options.seed = 12;
    options.num_rooms = 14;
    GridMap map = sim::generate_building(options).map;
    map.states.origin = {0, 0};
    return map;
}

/// The map in an image that has grown to the left and downwards.
Raster<CellState> grown(const Raster<CellState>& states, Cell by) {
    Raster<CellState> result({0, 0}, states.width + by.x, states.height + by.y);
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        const Cell cell = states.cell(i);
        result.at({cell.x + by.x, cell.y + by.y}) = states.values[i];
    }
    return result;
}

TEST(LostFrame, AnImageThatHasGrownIsFoundAgain) {
    const GridMap map = building_map();
    const Raster<std::uint16_t> rooms = segment(map).labels;
    for (const Cell by : {Cell{57, 31}, Cell{0, 0}, Cell{3, 120}}) {
        const std::optional<Cell> shift = find_shift(rooms, grown(map.states, by));
        ASSERT_TRUE(shift) << by.x;
        EXPECT_EQ(shift->x, by.x);
        EXPECT_EQ(shift->y, by.y);
    }
}

TEST(LostFrame, OfAnotherBuildingThereIsNone) {
    const Raster<std::uint16_t> rooms = segment(building_map()).labels;
    sim::BuildingOptions other;
    other.seed = 99;
    EXPECT_FALSE(find_shift(rooms, sim::generate_building(other).map.states));
    // Free ground fits each floor, but no border.
    EXPECT_FALSE(find_shift(rooms, Raster<CellState>({0, 0}, 900, 900, CellState::free)));
    EXPECT_FALSE(find_shift(Raster<std::uint16_t>({0, 0}, 9, 9), {}));
}

}  // namespace
}  // namespace quadcut
