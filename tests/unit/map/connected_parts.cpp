// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/connected_parts.hpp"

#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/segment/inside.hpp"
#include "tests/unit/map/reference_tree.hpp"

namespace quadcut {
namespace {

/// The part of each cell; 0 where none is.
Raster<std::uint32_t> labels_of(const ConnectedParts& free) {
    Raster<std::uint32_t> labels({0, 0}, free.width,
                                 static_cast<std::int32_t>(free.row_begin.size() - 1));
    std::vector<std::uint32_t> own(free.count + std::size_t{1});
    std::iota(own.begin(), own.end(), 0U);
    free.paint(own, labels);
    return labels;
}

ConnectedParts components_of(const std::vector<std::string>& rows) {
    return free_parts(test::grid_from_text(rows).states);
}

TEST(Components, NeighboursAreFourNotEight) {
    const ConnectedParts free = components_of({".#.",  //
                                               "#..",  //
                                               ".#."});
    ASSERT_EQ(free.count, 3U);
    const Raster<std::uint32_t> labels = labels_of(free);
    EXPECT_EQ(labels.at({0, 0}), 1U);
    EXPECT_EQ(labels.at({2, 0}), 2U);
    EXPECT_EQ(labels.at({1, 1}), 2U);
    EXPECT_EQ(labels.at({2, 2}), 2U);
    EXPECT_EQ(labels.at({0, 2}), 3U);
    EXPECT_EQ(labels.at({1, 0}), 0U);
    EXPECT_EQ(free.num_cells(), (std::vector<std::size_t>{0, 1, 4, 1}));
}

TEST(Components, ArmsThatMeetLateAreOne) {
    const ConnectedParts free = components_of({".........",  //
                                               ".#######.",  //
                                               ".#.#.#.#.",  //
                                               ".#.....#.",  //
                                               ".#######."});
    ASSERT_EQ(free.count, 2U);
    EXPECT_EQ(free.num_cells(), (std::vector<std::size_t>{0, 17, 8}));
    EXPECT_EQ(free.on_edge(), (std::vector<bool>{false, true, false}));
}

TEST(Components, TheGroundAroundABuildingIsOutside) {
    const ConnectedParts free = components_of({"........",  //
                                               ".######.",  //
                                               ".#....#.",  //
                                               ".#....#.",  //
                                               ".######.",  //
                                               "........"});
    EXPECT_EQ(find_outside(free, 4), 1U);
    // Too small to be a building.
    EXPECT_EQ(find_outside(free, 9), 0U);
}

TEST(Components, WhatHoldsTheFloorIsNotOutside) {
    // A hall whose leaky wall lets it reach the rim, and one small pallet of free cells in it.
    std::vector<std::string> rows(40, std::string(40, '.'));
    for (std::size_t i = 10; i < 14; ++i)
        rows[10][i] = rows[13][i] = rows[i][10] = rows[i][13] = '#';
    EXPECT_EQ(find_outside(components_of(rows), 2), 0U);
}

TEST(Components, ACroppedRoomIsNotOutside) {
    EXPECT_EQ(find_outside(components_of({"....", "....", "...."}), 1), 0U);
    EXPECT_EQ(find_outside(components_of({"######",  //
                                          "...#..",  //
                                          "...#..",  //
                                          "######"}),
                           1),
              0U);
    EXPECT_EQ(find_outside(components_of({"####", "####"}), 1), 0U);
    EXPECT_EQ(find_outside(ConnectedParts{}, 1), 0U);
}

TEST(Components, AreWhatAFloodFindsOnRandomMaps) {
    Random random(3);
    for (int round = 0; round < 50; ++round) {
        const auto width = static_cast<std::int32_t>(1 + random.below(30));
        const auto height = static_cast<std::int32_t>(1 + random.below(30));
        Raster<CellState> states({-4, 7}, width, height);
        for (CellState& state : states.values) {
            state = random.uniform() < 0.6 ? CellState::free : CellState::occupied;
        }
        const ConnectedParts free = free_parts(states);
        Raster<std::uint32_t> flood({-4, 7}, width, height);
        std::uint32_t num_floods = 0;
        for (std::size_t seed = 0; seed < states.values.size(); ++seed) {
            if (states.values[seed] != CellState::free || flood.values[seed] != 0) {
                continue;
            }
            ++num_floods;
            std::vector<Cell> open{states.cell(seed)};
            while (!open.empty()) {
                const Cell cell = open.back();
                open.pop_back();
                if (states.contains(cell) && states.at(cell) == CellState::free &&
                    flood.at(cell) == 0) {
                    flood.at(cell) = num_floods;
                    open.insert(open.end(), {{cell.x + 1, cell.y},
                                             {cell.x - 1, cell.y},
                                             {cell.x, cell.y + 1},
                                             {cell.x, cell.y - 1}});
                }
            }
        }
        ASSERT_EQ(labels_of(free).values, flood.values);
    }
}

/// In noise there is one for every other cell: what each takes is what a cell takes.
TEST(Components, AreSmall) { EXPECT_LE(sizeof(CellRun), 12U); }

}  // namespace
}  // namespace quadcut
