// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/void_rule.hpp"

#include <gtest/gtest.h>

namespace quadcut {
namespace {

TEST(VoidRule, RegionsMostlyInTheVoidCountNowhere) {
    GridMap map;
    map.states = Raster<CellState>({0, 0}, 8, 1, CellState::free);
    Raster<std::uint32_t> truth({0, 0}, 8, 1, 1);
    Raster<std::uint32_t> predicted({0, 0}, 8, 1, 1);
    for (std::size_t i = 4; i < 8; ++i) predicted.values[i] = 2;
    truth.values[5] = truth.values[6] = truth.values[7] = 0;
    truth.values[0] = truth.values[1] = 0;
    const Raster<std::uint32_t> kept = without_void(predicted, truth, map);
    EXPECT_EQ(kept.values[0], 1U);  // a half is no more than a half
    EXPECT_EQ(kept.values[4], 0U);
    EXPECT_EQ(kept.values[7], 0U);
    // Cells that are not free do not speak.
    map.states.values[5] = map.states.values[6] = CellState::unknown;
    EXPECT_EQ(without_void(predicted, truth, map).values[4], 2U);
}

}  // namespace
}  // namespace quadcut
