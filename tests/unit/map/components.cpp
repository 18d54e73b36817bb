// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/components.hpp"

#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "tests/unit/map/reference_tree.hpp"

namespace quadcut {
namespace {

/// 1 + the component of each cell; 0 where none is.
Raster<std::uint32_t> labels_of(const FreeComponents& free) {
    Raster<std::uint32_t> labels(free.origin, free.parts.width,
                                 static_cast<std::int32_t>(free.parts.row_begin.size() - 1));
    std::vector<std::uint32_t> own(free.components.size() + 1);
    std::iota(own.begin(), own.end(), 0U);
    free.parts.paint(own, labels);
    return labels;
}

FreeComponents components_of(const std::vector<std::string>& rows) {
    return find_free_components(test::grid_from_text(rows).states);
}

TEST(Components, NeighboursAreFourNotEight) {
    const FreeComponents free = components_of({".#.",  //
                                               "#..",  //
                                               ".#."});
    ASSERT_EQ(free.components.size(), 3U);
    const Raster<std::uint32_t> labels = labels_of(free);
    EXPECT_EQ(labels.at({0, 0}), 1U);
    EXPECT_EQ(labels.at({2, 0}), 2U);
    EXPECT_EQ(labels.at({1, 1}), 2U);
    EXPECT_EQ(labels.at({2, 2}), 2U);
    EXPECT_EQ(labels.at({0, 2}), 3U);
    EXPECT_EQ(labels.at({1, 0}), 0U);
    EXPECT_EQ(free.components[1].num_cells, 4U);
    EXPECT_EQ(free.components[1].num_border_cells, 3U);
}

TEST(Components, ArmsThatMeetLateAreOne) {
    const FreeComponents free = components_of({".........",  //
                                               ".#######.",  //
                                               ".#.#.#.#.",  //
                                               ".#.....#.",  //
                                               ".#######."});
    ASSERT_EQ(free.components.size(), 2U);
    EXPECT_EQ(free.components[0].num_cells, 17U);
    EXPECT_EQ(free.components[1].num_cells, 8U);
    EXPECT_EQ(free.components[1].num_border_cells, 0U);
}

TEST(Components, TheGroundAroundABuildingIsOutside) {
    const FreeComponents free = components_of({"........",  //
                                               ".######.",  //
                                               ".#....#.",  //
                                               ".#....#.",  //
                                               ".######.",  //
                                               "........"});
    EXPECT_EQ(find_outside(free, 4), 0U);
    // Too small to be a building.
    EXPECT_EQ(find_outside(free, 9), std::nullopt);
}

TEST(Components, WhatHoldsTheFloorIsNotOutside) {
    // A hall whose leaky wall lets it reach the rim, and one small pallet of free cells in it.
    std::vector<std::string> rows(40, std::string(40, '.'));
    for (std::size_t i = 10; i < 14; ++i)
        rows[10][i] = rows[13][i] = rows[i][10] = rows[i][13] = '#';
    EXPECT_EQ(find_outside(components_of(rows), 2), std::nullopt);
}

TEST(Components, ACroppedRoomIsNotOutside) {
    EXPECT_EQ(find_outside(components_of({"....", "....", "...."}), 1), std::nullopt);
    EXPECT_EQ(find_outside(components_of({"######",  //
                                          "...#..",  //
                                          "...#..",  //
                                          "######"}),
                           1),
              std::nullopt);
    EXPECT_EQ(find_outside(components_of({"####", "####"}), 1), std::nullopt);
    EXPECT_EQ(find_outside(FreeComponents{}, 1), std::nullopt);
}

TEST(Components, AreChosenByCells) {
    const FreeComponents free = components_of({"..#..", "..#..", "#####", "....."});
    const std::vector<Cell> robot{{4, 3}, {99, -5}, {2, 3}};
    const std::vector<bool> visited = components_with(free, robot);
    EXPECT_EQ(visited, (std::vector<bool>{false, false, true}));
    const Raster<std::uint8_t> mask = mask_of(free, visited);
    EXPECT_EQ(mask.at({3, 2}), 1);
    EXPECT_EQ(mask.at({0, 2}), 0);
    EXPECT_EQ(mask.at({2, 2}), 0);
    EXPECT_EQ(mask.at({0, 0}), 0);
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
        const FreeComponents free = find_free_components(states);
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
        std::size_t num_border = 0;
        std::size_t wanted = 0;
        for (const FreeComponents::Component& component : free.components) {
            num_border += component.num_border_cells;
        }
        for (std::size_t i = 0; i < states.values.size(); ++i) {
            const Cell cell = states.cell(i);
            wanted += states.values[i] == CellState::free &&
                      (cell.x == -4 || cell.y == 7 || cell.x == width - 5 || cell.y == height + 6);
        }
        ASSERT_EQ(num_border, wanted);
    }
}

/// In noise there is one for every other cell: what each takes is what a cell takes.
TEST(FreeComponents, AreSmall) {
    EXPECT_LE(sizeof(FreeComponents::Component), 8U);
    EXPECT_LE(sizeof(CellRun), 12U);
}

}  // namespace
}  // namespace quadcut
