// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <memory>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "reproduce/flat_grid.hpp"
#include "reproduce/pointer_quadtree.hpp"

namespace quadcut {
namespace {

TEST(MapBaselines, HoldTheSameCellsAsTheMap) {
    const Root root{{0, 0}, 6};
    OccupancyMap map(0.05, {}, root);
    FlatGrid grid(Raster<std::int8_t>({0, 0}, 64, 64));
    PointerQuadtree tree(root);
    Random random(3);
    for (int i = 0; i < 3000; ++i) {
        const Cell cell{static_cast<std::int32_t>(random.below(64)),
                        static_cast<std::int32_t>(random.below(64))};
        const CellState state = random.below(3) == 0 ? CellState::occupied : CellState::free;
        const int log_odds = state == CellState::free ? kMinLogOdds : kMaxLogOdds;
        map.set_state(cell, state);
        grid.set(cell, log_odds);
        tree.set(cell, log_odds);
    }
    map.commit();
    for (std::int32_t y = -2; y < 66; ++y) {
        for (std::int32_t x = -2; x < 66; ++x) {
            ASSERT_EQ(grid.log_odds({x, y}), map.log_odds({x, y}));
            ASSERT_EQ(tree.log_odds({x, y}), map.log_odds({x, y}));
        }
    }
    // Both split where values differ, down to single cells.
    EXPECT_EQ(tree.num_nodes(), map.num_nodes());
}

TEST(MapBaselines, AQuadtreeOfOneValueIsOneNode) {
    PointerQuadtree tree({{0, 0}, 3});
    for (std::int32_t i = 0; i < 64; ++i) tree.set({i % 8, i / 8}, 5);
    EXPECT_EQ(tree.num_nodes(), 1U);
    tree.set({0, 0}, 4);
    EXPECT_EQ(tree.num_nodes(), 13U);
}

}  // namespace
}  // namespace quadcut
