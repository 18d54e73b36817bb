// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/leaf_table.hpp"

#include <gtest/gtest.h>

#include "quadcut/map/occupancy_map.hpp"
#include "tests/unit/map/reference_tree.hpp"

namespace quadcut {
namespace {

LeafTable table_of(const OccupancyMap& map) { return LeafTable(map.leaves(), map.root()); }

std::vector<std::size_t> leaves_in(const LeafTable& table, Cell low, Cell high) {
    std::vector<std::size_t> found;
    table.for_each_leaf_in(low, high, [&](LeafId id) { found.push_back(index(id)); });
    return found;
}

TEST(LeafTable, FindsFreeAndOccupiedLeavesOnly) {
    const LeafTable table =
        table_of(OccupancyMap::from_grid(test::grid_from_text({"????", "..#.", "...."})));
    ASSERT_TRUE(table.find({0, 0}));
    EXPECT_EQ(table.leaf(*table.find({0, 0})), (Leaf{{0, 0}, 1, CellState::free}));
    EXPECT_EQ(table.find({0, 0}), table.find({1, 1}));
    EXPECT_EQ(table.leaf(*table.find({2, 1})).state, CellState::occupied);
    EXPECT_FALSE(table.find({0, 2}));
    EXPECT_FALSE(table.find({4, 0}));
    EXPECT_FALSE(table.find({-1, 0}));
    EXPECT_FALSE(table.find({1'000'000'000, -1'000'000'000}));
}

TEST(LeafTable, VisitsALargeLeafOnce) {
    const LeafTable table = table_of(
        OccupancyMap::from_grid({0.05, {}, Raster<CellState>({0, 0}, 64, 64, CellState::free)}));
    EXPECT_EQ(leaves_in(table, {0, 0}, {63, 63}).size(), 1U);
    EXPECT_EQ(leaves_in(table, {20, 30}, {50, 40}).size(), 1U);
    EXPECT_EQ(leaves_in(table, {-1000, -1000}, {1000, 1000}).size(), 1U);
    EXPECT_TRUE(leaves_in(table, {64, 0}, {80, 63}).empty());
}

TEST(LeafTable, TakesAnEmptyListAndAPart) {
    EXPECT_FALSE(LeafTable({}, Root{{0, 0}, 5}).find({0, 0}));
    const LeafTable part({{{8, 0}, 3, CellState::free}, {{0, 8}, 0, CellState::free}},
                         Root{{0, 0}, 5});
    EXPECT_TRUE(part.find({15, 7}));
    EXPECT_TRUE(part.find({0, 8}));
    EXPECT_FALSE(part.find({1, 8}));
    EXPECT_FALSE(part.find({0, 0}));
}

}  // namespace
}  // namespace quadcut
