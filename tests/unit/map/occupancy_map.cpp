// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/occupancy_map.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"
#include "tests/unit/map/log_odds.hpp"
#include "tests/unit/map/reference_tree.hpp"

namespace quadcut {
namespace {

using test::grid_from_text;
using test::text_from;

OccupancyMap with_one_cell(Cell cell) {
    OccupancyMap map(0.05);
    map.set_state(cell, CellState::occupied);
    map.commit();
    return map;
}

TEST(OccupancyMap, EmptyIsOneUnknownLeaf) {
    const OccupancyMap map(0.05);
    EXPECT_EQ(map.num_leaves(), 1U);
    EXPECT_EQ(map.num_nodes(), 1U);
    EXPECT_EQ(map.state({123, -456}), CellState::unknown);
    EXPECT_EQ(map.leaves().front().state, CellState::unknown);
    EXPECT_TRUE(map.to_raster().values.empty());
}

TEST(OccupancyMap, KeepsAPicture) {
    const std::vector<std::string> rows{"..........",  //
                                        ".########.",  //
                                        ".#??????#.",  //
                                        ".########.",  //
                                        "...#......"};
    const OccupancyMap map = OccupancyMap::from_grid(grid_from_text(rows));
    EXPECT_EQ(text_from(map.to_raster()), rows);
    EXPECT_EQ(map.root(), (Root{{0, 0}, 4}));
    EXPECT_EQ(map.log_odds({0, 0}), kMinLogOdds);
    EXPECT_EQ(map.log_odds({3, 0}), kMaxLogOdds);
    EXPECT_EQ(map.log_odds({4, 2}), 0);
}

TEST(OccupancyMap, LeavesComeDepthFirst) {
    const OccupancyMap map = OccupancyMap::from_grid(grid_from_text({"....????",  //
                                                                     "....????",  //
                                                                     "....????",  //
                                                                     "....????",  //
                                                                     "......#.",  //
                                                                     "........",  //
                                                                     "........",  //
                                                                     "........"}));
    const std::vector<Leaf> leaves = map.leaves();
    ASSERT_EQ(leaves.size(), 10U);
    EXPECT_EQ(leaves[0], (Leaf{{0, 0}, 2, CellState::free}));
    EXPECT_EQ(leaves[1], (Leaf{{4, 0}, 1, CellState::free}));
    EXPECT_EQ(leaves[2], (Leaf{{6, 0}, 1, CellState::free}));
    EXPECT_EQ(leaves[3], (Leaf{{4, 2}, 1, CellState::free}));
    EXPECT_EQ(leaves[4], (Leaf{{6, 2}, 0, CellState::free}));
    EXPECT_EQ(leaves[6], (Leaf{{6, 3}, 0, CellState::occupied}));
    EXPECT_EQ(leaves[8], (Leaf{{0, 4}, 2, CellState::free}));
    EXPECT_EQ(leaves[9], (Leaf{{4, 4}, 2, CellState::unknown}));
    EXPECT_EQ(map.num_nodes(), 13U);
}

TEST(OccupancyMap, GrowsTowardsTheSideWhereItIsLeft) {
    OccupancyMap map = with_one_cell({3, 3});
    EXPECT_EQ(map.root(), (Root{{0, 0}, 3}));
    map.set_state({8, 3}, CellState::free);
    map.commit();
    EXPECT_EQ(map.root().level, 4);
    EXPECT_EQ(map.root().lower_left.x, 0);
    const Root before = map.root();
    map.set_state({-1, 3}, CellState::free);
    map.commit();
    EXPECT_EQ(map.root().level, 5);
    EXPECT_EQ(map.root().lower_left.x, -16);
    map.set_state({3, before.lower_left.y - 100}, CellState::free);
    map.commit();
    EXPECT_LT(map.root().lower_left.y, -90);
    EXPECT_EQ(map.state({3, 3}), CellState::occupied);
    EXPECT_EQ(map.state({8, 3}), CellState::free);
    EXPECT_EQ(map.state({-1, 3}), CellState::free);
    EXPECT_EQ(map.num_leaves(), map.leaves().size());
}

TEST(OccupancyMap, ABlockOfOneValueGivesItsBytesBack) {
    OccupancyMap map(0.05);
    map.reserve({0, 0}, {1023, 1023});
    map.commit();
    const std::size_t empty = map.bytes();
    for (std::int32_t y = 0; y < 1024; ++y) {
        for (std::int32_t x = 0; x < 1024; x += 2) {
            map.set_state({x, y}, CellState::free);
        }
    }
    map.commit();
    EXPECT_GT(map.bytes(), empty + 1024 * 1024 / 2);
    for (std::int32_t y = 0; y < 1024; ++y) {
        for (std::int32_t x = 1; x < 1024; x += 2) {
            map.set_state({x, y}, CellState::free);
        }
    }
    const MapUpdate update = map.commit();
    EXPECT_LT(map.bytes(), empty + 1000);
    EXPECT_EQ(map.leaves(), (std::vector<Leaf>{{{0, 0}, 10, CellState::free}}));
    EXPECT_EQ(update.nodes_rebuilt, 1U);
    EXPECT_EQ(update.nodes_touched, 1U);
}

TEST(OccupancyMap, ReportsWhatAnUpdateDid) {
    OccupancyMap map =
        OccupancyMap::from_grid({0.05, {}, Raster<CellState>({0, 0}, 64, 64, CellState::free)});
    EXPECT_EQ(map.num_leaves(), 1U);
    map.set_state({63, 0}, CellState::occupied);
    const MapUpdate update = map.commit();
    // The root is divided six times; each time three quarters stay whole.
    EXPECT_EQ(map.num_leaves(), 19U);
    EXPECT_EQ(update.nodes_rebuilt, 25U);
    // The tile's 13 nodes, and the three blocks around it.
    EXPECT_EQ(update.nodes_touched, 16U);
    EXPECT_EQ(update.covering, (Root{{56, 0}, 3}));
    EXPECT_EQ(map.num_nodes_in(*update.covering), 13U);
    EXPECT_EQ(map.commit().nodes_rebuilt, 0U);
}

TEST(OccupancyMap, ChangedLogOddsOfTheSameStateRebuildNothing) {
    OccupancyMap map = with_one_cell({5, 5});
    test::add_log_odds(map, {5, 5}, -1);
    const MapUpdate update = map.commit();
    EXPECT_EQ(update.nodes_rebuilt, 0U);
    EXPECT_GT(update.nodes_touched, 0U);
    // A saturated cell does not even count as written.
    map.set_state({5, 5}, CellState::occupied);
    map.commit();
    test::add_log_odds(map, {5, 5}, 3);
    EXPECT_EQ(map.commit().nodes_touched, 0U);
}

TEST(OccupancyMap, BlockAroundIsTheSmallestOne) {
    const OccupancyMap map =
        OccupancyMap::from_grid({0.05, {}, Raster<CellState>({0, 0}, 64, 64, CellState::free)});
    EXPECT_EQ(map.block_around({1, 1}, {6, 6}), (Root{{0, 0}, 3}));
    EXPECT_EQ(map.block_around({34, 33}, {41, 40}), (Root{{32, 32}, 4}));
    // Across the middle of the map nothing smaller than the root will do.
    EXPECT_EQ(map.block_around({31, 5}, {32, 5}), (Root{{0, 0}, 6}));
}

TEST(OccupancyMap, TheTreeIsReadAfterCommitOnly) {
    OccupancyMap map(0.05);
    map.set_state({0, 0}, CellState::free);
    EXPECT_EQ(map.state({0, 0}), CellState::free);
    EXPECT_THROW(static_cast<void>(map.leaves()), std::logic_error);
    EXPECT_THROW(static_cast<void>(map.num_leaves()), std::logic_error);
    map.commit();
    EXPECT_NO_THROW(static_cast<void>(map.leaves()));
}

TEST(OccupancyMap, RefusesWhatIsTooFarAwayAndStaysAsItWas) {
    OccupancyMap map = with_one_cell({0, 0});
    EXPECT_THROW(map.set_state({1 << 28, 0}, CellState::free), InputError);
    EXPECT_THROW(map.set_state({0, -(1 << 28) - 1}, CellState::free), InputError);
    // Within the coordinates, but 2^54 cells of bounding box.
    EXPECT_THROW(map.set_state({1 << 27, 1 << 27}, CellState::free), InputError);
    EXPECT_THROW(static_cast<void>(map.cell_at({1e9, 0.0})), InputError);
    EXPECT_THROW(static_cast<void>(map.cell_at({0.0, std::nan("")})), InputError);
    EXPECT_LT(map.bytes(), 10'000U);
    EXPECT_EQ(map.root().level, 3);
    EXPECT_EQ(map.num_leaves(), map.leaves().size());
}

TEST(OccupancyMap, AFarRootIsNoTroubleIfTheMapIsSmall) {
    OccupancyMap map = with_one_cell({200'000'000, -200'000'000});
    EXPECT_LT(map.bytes(), 10'000U);
    map.set_state({200'000'100, -200'000'000}, CellState::free);
    map.commit();
    EXPECT_EQ(map.state({200'000'100, -200'000'000}), CellState::free);
    EXPECT_EQ(map.to_raster().width, 101);
}

TEST(OccupancyMap, RefusesSenselessGeometry) {
    EXPECT_THROW(OccupancyMap(0.0), InputError);
    EXPECT_THROW(OccupancyMap(-1.0), InputError);
    EXPECT_THROW(OccupancyMap(std::nan("")), InputError);
    EXPECT_THROW(OccupancyMap{std::numeric_limits<double>::infinity()}, InputError);
    EXPECT_THROW(OccupancyMap(0.05, {std::nan(""), 0.0, 0.0}), InputError);
    EXPECT_THROW(OccupancyMap(0.05, {}, Root{{4, 0}, 5}), InputError);
    EXPECT_THROW(OccupancyMap(0.05, {}, Root{{0, 0}, 2}), InputError);
}

TEST(OccupancyMap, CellsFollowThePose) {
    const OccupancyMap map(0.1, {1.0, 2.0, std::acos(0.0)});
    // The map is turned left: its x runs along the world's y.
    EXPECT_EQ(map.cell_at({0.95, 2.25}), (Cell{2, 0}));
}

TEST(OccupancyMap, GridStartsAtTheFirstKnownCell) {
    OccupancyMap map(0.5, {10.0, 20.0, 0.0});
    map.set_state({-3, 7}, CellState::free);
    map.set_state({1, 8}, CellState::occupied);
    map.commit();
    const GridMap grid = map.to_grid();
    EXPECT_EQ(text_from(grid.states), (std::vector<std::string>{"????#", ".????"}));
    EXPECT_EQ(grid.states.origin, (Cell{0, 0}));
    EXPECT_DOUBLE_EQ(grid.map_from_image.x, 8.5);
    EXPECT_DOUBLE_EQ(grid.map_from_image.y, 23.5);
}

}  // namespace
}  // namespace quadcut
