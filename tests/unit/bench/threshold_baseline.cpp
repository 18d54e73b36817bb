// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/threshold_baseline.hpp"

#include <set>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

// Two rooms of 3 m by 3 m with a door of 0.8 m between them.
GridMap two_rooms() {
    GridMap map;
    map.resolution_m = 0.1;
    map.states = Raster<CellState>({0, 0}, 64, 32, CellState::occupied);
    for_each_cell({{1, 1}, {30, 30}}, [&](Cell cell) { map.states.at(cell) = CellState::free; });
    for_each_cell({{33, 1}, {62, 30}}, [&](Cell cell) { map.states.at(cell) = CellState::free; });
    for_each_cell({{31, 12}, {32, 19}}, [&](Cell cell) { map.states.at(cell) = CellState::free; });
    return map;
}

TEST(ThresholdBaseline, ADoorDividesTwoRooms) {
    const GridMap map = two_rooms();
    const Raster<std::uint32_t> rooms = threshold_baseline(map);
    EXPECT_NE(rooms.at({5, 5}), rooms.at({58, 5}));
    for (std::size_t i = 0; i < rooms.values.size(); ++i) {
        EXPECT_EQ(rooms.values[i] != 0, map.states.values[i] == CellState::free);
    }
    EXPECT_EQ(std::set<std::uint32_t>(rooms.values.begin(), rooms.values.end()).size(), 3U);
}

TEST(ThresholdBaseline, AnEmptyMapHasNoRooms) {
    GridMap map;
    map.states = Raster<CellState>({0, 0}, 8, 8);
    for (const std::uint32_t room : threshold_baseline(map).values) EXPECT_EQ(room, 0U);
}

}  // namespace
}  // namespace quadcut
