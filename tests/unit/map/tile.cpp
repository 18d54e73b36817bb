// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/tile.hpp"

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/map/morton.hpp"

namespace quadcut {
namespace {

// From rows of text, the top row first: '.' free, '#' occupied, else unknown.
TileStates states_from(const std::array<const char*, 8>& rows) {
    Tile tile;
    for (std::size_t y = 0; y < 8; ++y) {
        for (std::size_t x = 0; x < 8; ++x) {
            const char cell = rows[7 - y][x];
            tile.values[8 * y + x] = cell == '.'   ? std::int8_t{-1}
                                     : cell == '#' ? std::int8_t{3}
                                                   : std::int8_t{0};
        }
    }
    return states_of(tile);
}

TEST(Morton, CodesInterleaveAndComeBack) {
    EXPECT_EQ(morton_code({3, 0}), 0b0101U);
    EXPECT_EQ(morton_code({0, 3}), 0b1010U);
    for (const Cell cell : {Cell{0, 0}, Cell{5, 9}, Cell{(1 << 28) - 1, 12345}, Cell{1, 1 << 29}}) {
        EXPECT_EQ(morton_position(morton_code(cell)), cell);
    }
}

TEST(Tile, EightCellsAtATimeAreAsOneByOne) {
    Random random(5);
    for (int round = 0; round < 200; ++round) {
        Tile tile;
        for (std::int8_t& value : tile.values) {
            value = static_cast<std::int8_t>(kMinLogOdds + static_cast<int>(random.below(16)));
        }
        const std::uint64_t hit = random.bits() & random.bits();
        const std::uint64_t miss = random.bits();
        const int if_hit = static_cast<int>(random.below(20));
        const int if_miss = -static_cast<int>(random.below(20));
        const int bound = 1 + static_cast<int>(random.below(12));
        const std::uint64_t below = rows_below_zero(tile);
        const std::uint64_t at_least = rows_at_least(tile, bound);
        const Tile sums = bounded_sums(tile, hit, if_hit, miss, if_miss);
        for (std::size_t i = 0; i < kTileCells; ++i) {
            ASSERT_EQ(below >> i & 1, tile.values[i] < 0 ? 1U : 0U);
            ASSERT_EQ(at_least >> i & 1, tile.values[i] >= bound ? 1U : 0U);
            const int delta = (hit >> i & 1) != 0 ? if_hit : (miss >> i & 1) != 0 ? if_miss : 0;
            ASSERT_EQ(sums.values[i], bounded_sum(tile.values[i], delta)) << delta;
        }
    }
}

TEST(Tile, RowsBecomeMortonOrder) {
    for (std::int32_t y = 0; y < 8; ++y) {
        for (std::int32_t x = 0; x < 8; ++x) {
            EXPECT_EQ(morton_from_rows(std::uint64_t{1} << (8 * y + x)),
                      std::uint64_t{1} << morton_code({x, y}));
        }
    }
}

TEST(Tile, OneStateHasNoLeavesInside) {
    for (const CellState state : {CellState::unknown, CellState::free, CellState::occupied}) {
        Tile tile;
        tile.values.fill(log_odds_of(state));
        EXPECT_EQ(leaves_of(states_of(tile)).count(), 0);
    }
}

TEST(Tile, LeavesAreTheLargestBlocks) {
    const TileLeaves leaves = leaves_of(states_from({"........",  //
                                                     "........",  //
                                                     "........",  //
                                                     "........",  //
                                                     "....??..",  //
                                                     "....??..",  //
                                                     "......#.",  //
                                                     "........"}));
    EXPECT_EQ(std::popcount(leaves.by_level[2]), 3);
    EXPECT_EQ(std::popcount(leaves.by_level[1]), 3);
    EXPECT_EQ(std::popcount(leaves.by_level[0]), 4);
    EXPECT_EQ(leaves.by_level[0] & -leaves.by_level[0], TileMask{1} << morton_code({6, 0}));
    // Nodes of 2, 4 and 8 cells a side that are divided: one of each.
    for (const TileMask nodes : leaves.inner_nodes()) {
        EXPECT_EQ(std::popcount(nodes), 1);
    }
}

TEST(Tile, AnObservedCellDoesNotBecomeUnknownAgain) {
    EXPECT_EQ(bounded_sum(3, -3), -1);
    EXPECT_EQ(bounded_sum(-1, 1), 1);
    EXPECT_EQ(bounded_sum(0, 0), 0);
    EXPECT_EQ(bounded_sum(kMaxLogOdds, 5), kMaxLogOdds);
    EXPECT_EQ(bounded_sum(kMinLogOdds, -5), kMinLogOdds);
}

}  // namespace
}  // namespace quadcut
