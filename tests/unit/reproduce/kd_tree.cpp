// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/kd_tree.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

std::int64_t least_squared_distance(const std::vector<Cell>& points, Cell to) {
    std::int64_t least = squared_distance(points.front(), to);
    for (const Cell point : points) least = std::min(least, squared_distance(point, to));
    return least;
}

TEST(KdTree, NearestIsThatOfAllPoints) {
    Random random(5);
    const auto cell = [&](std::uint64_t reach) {
        const auto half = static_cast<std::int32_t>(reach / 2);
        return Cell{static_cast<std::int32_t>(random.below(reach)) - half,
                    static_cast<std::int32_t>(random.below(reach)) - half};
    };
    for (std::size_t num_points = 1; num_points <= 200; num_points += 7) {
        // Few places: many points share a coordinate, some are the same.
        std::vector<Cell> points(num_points);
        for (Cell& point : points) point = cell(20);
        const KdTree tree(points);
        EXPECT_EQ(tree.num_nodes(), num_points);
        for (int i = 0; i < 50; ++i) {
            const Cell to = cell(40);
            EXPECT_EQ(squared_distance(tree.nearest(to).value(), to),
                      least_squared_distance(points, to));
        }
    }
}

TEST(KdTree, AnEmptyOneHasNoNearest) { EXPECT_FALSE(KdTree({}).nearest({0, 0}).has_value()); }

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
