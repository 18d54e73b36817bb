// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/kd_tree.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

TEST(KdTree, HoldsEveryPoint) {
    Random random(5);
    std::vector<Cell> points(200);
    for (Cell& point : points) {
        // Few places: many points share a coordinate, some are the same.
        point = {static_cast<std::int32_t>(random.below(20)) - 10,
                 static_cast<std::int32_t>(random.below(20)) - 10};
    }
    EXPECT_EQ(build_kd_tree(points), points.size());
    EXPECT_EQ(build_kd_tree({}), 0U);
}

TEST(KdTree, ObstaclesAreTheOccupiedCellsOfAMap) {
    OccupancyMap map(0.05);
    map.set_state({3, -4}, CellState::occupied);
    map.set_state({90, 7}, CellState::occupied);
    map.set_state({5, 5}, CellState::free);
    map.commit();
    std::vector<Cell> cells = obstacles_of(map);
    ASSERT_EQ(cells.size(), 2U);
    std::sort(cells.begin(), cells.end(), [](Cell a, Cell b) { return a.x < b.x; });
    EXPECT_EQ(cells, (std::vector<Cell>{{3, -4}, {90, 7}}));
}

}  // namespace
}  // namespace quadcut
