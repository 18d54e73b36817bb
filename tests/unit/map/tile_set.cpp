// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/tile_set.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {
namespace {

std::size_t num_tiles(const TileSet& set) {
    std::size_t count = 0;
    set.for_each([&](Cell, std::uint64_t) { ++count; });
    return count;
}

/// Cell by cell.
Raster<std::uint8_t> walked(const Raster<std::uint8_t>& ways, Cell from) {
    Raster<std::uint8_t> taken(ways.box());
    taken.at(from) = 1;
    std::vector<Cell> waiting{from};
    while (!waiting.empty()) {
        const Cell at = waiting.back();
        waiting.pop_back();
        for (const Cell next : {Cell{at.x - 1, at.y}, Cell{at.x + 1, at.y}, Cell{at.x, at.y - 1},
                                Cell{at.x, at.y + 1}}) {
            if (!ways.contains(next) || ways.at(next) == 0 || taken.at(next) != 0) continue;
            taken.at(next) = 1;
            waiting.push_back(next);
        }
    }
    return taken;
}

std::uint64_t rows_in(const Raster<std::uint8_t>& ways, Cell tile) {
    std::uint64_t rows = 0;
    const Cell low = first_cell_of(tile);
    for (Cell cell = low; cell.y < low.y + kTileSide; ++cell.y) {
        for (cell.x = low.x; cell.x < low.x + kTileSide; ++cell.x) {
            if (ways.contains(cell) && ways.at(cell) != 0) {
                rows |= std::uint64_t{1} << place_in_tile(cell);
            }
        }
    }
    return rows;
}

TEST(TileWalk, TakesWhatAWalkCellByCellReaches) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
        Random random(seed);
        // Across 0, and of a size that is no multiple of a tile.
        Raster<std::uint8_t> ways({-37, -21}, 83, 59);
        for (std::uint8_t& way : ways.values) way = random.below(100) < 62 ? 1 : 0;
        TileWalk walk([&](Cell tile) { return rows_in(ways, tile); });
        for (const Cell from : {Cell{0, 0}, Cell{-37, -21}, Cell{45, 37}, Cell{-1, 7}}) {
            const Raster<std::uint8_t> expected = walked(ways, from);
            const TileSet taken = walk.take(from);
            for (std::size_t i = 0; i < ways.values.size(); ++i) {
                ASSERT_EQ(taken.contains(ways.cell(i)), expected.values[i] != 0) << i;
                // What is taken is no way any more.
                if (expected.values[i] != 0) ways.values[i] = 0;
            }
        }
    }
}

TEST(TileWalk, MemoryGoesWithTheCellsNotWithTheBoxAroundThem) {
    // Steps of one cell along a diagonal of 80,000: the box has 6.4 billion cells.
    constexpr std::int32_t kLength = 80000;
    std::size_t num_asked = 0;
    TileWalk walk([&](Cell tile) {
        ++num_asked;
        if (tile.x != tile.y || tile.x < 0 || tile.x >= kLength / kTileSide) {
            return tile.x == tile.y + 1 ? std::uint64_t{1} << 56U : 0;
        }
        std::uint64_t rows = 0;
        for (std::int32_t i = 0; i < kTileSide; ++i) {
            rows |= std::uint64_t{1} << place_in_tile({i, i});
            if (i > 0) rows |= std::uint64_t{1} << place_in_tile({i, i - 1});
        }
        return rows;
    });
    const TileSet taken = walk.take({0, 0});
    EXPECT_TRUE(taken.contains({kLength - 1, kLength - 1}));
    EXPECT_FALSE(taken.contains({0, kLength - 1}));
    EXPECT_LE(num_tiles(taken), 2U * kLength / kTileSide + 2U);
    EXPECT_LE(num_asked, 8U * kLength / kTileSide);
}

}  // namespace
}  // namespace quadcut
