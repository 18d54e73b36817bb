// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/leaf.hpp"

namespace quadcut {

// A tile is 8 x 8 cells: one cache line.
constexpr std::int32_t kTileBits = 3;
constexpr std::int32_t kTileSide = 1 << kTileBits;
constexpr std::size_t kTileCells = kTileSide * kTileSide;

// Tiles have addresses as cells have: tile (x, y) begins at cell (8 x, 8 y).
[[nodiscard]] constexpr Cell tile_of(Cell cell) {
    return {cell.x >> kTileBits, cell.y >> kTileBits};
}
[[nodiscard]] constexpr Cell first_cell_of(Cell tile) {
    return {tile.x * kTileSide, tile.y * kTileSide};
}
/// The cells of tiles.
[[nodiscard]] constexpr Box cells_of_tiles(const Box& tiles) {
    const Cell high = first_cell_of(tiles.high);
    return {first_cell_of(tiles.low), {high.x + kTileSide - 1, high.y + kTileSide - 1}};
}
/// Where a cell lies in its tile, 8 y + x.
[[nodiscard]] constexpr std::size_t place_in_tile(Cell cell) {
    return static_cast<std::size_t>((cell.y & (kTileSide - 1)) * kTileSide +
                                    (cell.x & (kTileSide - 1)));
}

// A cell holds quantised log-odds of being occupied. 0: never observed, and an observed cell does
// not come back to it. Negative: free. Positive: occupied. The bounds are close to 0, so that a
// block which is seen a few times becomes one value and collapses; docs/decisions/0001.
constexpr int kMinLogOdds = -4;
constexpr int kMaxLogOdds = 11;

[[nodiscard]] constexpr CellState state_of(int log_odds) {
    return log_odds == 0  ? CellState::unknown
           : log_odds < 0 ? CellState::free
                          : CellState::occupied;
}

/// The log-odds of a cell that is certainly of a state.
[[nodiscard]] constexpr std::int8_t log_odds_of(CellState state) {
    const int known = state == CellState::free ? kMinLogOdds : kMaxLogOdds;
    return static_cast<std::int8_t>(state == CellState::unknown ? 0 : known);
}

/// Log-odds plus `delta`, within bounds; a sum of 0 becomes 1 in the direction of `delta`.
[[nodiscard]] constexpr std::int8_t bounded_sum(int log_odds, int delta) {
    const int sum = std::clamp(log_odds + delta, kMinLogOdds, kMaxLogOdds);
    return static_cast<std::int8_t>(sum != 0 || delta == 0 ? sum : delta < 0 ? -1 : 1);
}

/// 8 x 8 cells of log-odds; cell (x, y) is at 8 y + x.
struct alignas(kTileCells) Tile {
    std::array<std::int8_t, kTileCells> values{};
};

/// The cells whose log-odds are below 0, and those where they are at least `bound` >= 1: bit
/// 8 y + x for cell (x, y).
[[nodiscard]] std::uint64_t rows_below_zero(const Tile& tile);
[[nodiscard]] std::uint64_t rows_at_least(const Tile& tile, int bound);

/// bounded_sum() of each cell with `if_hit` where a bit of `hit` is set, else with `if_miss` where
/// one of `miss` is.
[[nodiscard]] Tile bounded_sums(const Tile& tile, std::uint64_t hit, int if_hit, std::uint64_t miss,
                                int if_miss);

/// A set of cells of one tile, one bit each, in Morton order: an aligned block of side 2^l is a run
/// of 4^l bits.
using TileMask = std::uint64_t;

constexpr TileMask kWholeTile = ~TileMask{0};

/// The mask of a tile whose bit 8 y + x stands for cell (x, y), in Morton order.
[[nodiscard]] TileMask morton_from_rows(std::uint64_t rows);

/// The states of the cells of one tile, without the log-odds.
struct TileStates {
    TileMask free = 0;
    TileMask occupied = 0;

    [[nodiscard]] TileMask of(CellState state) const;
    /// The state of the cell at `position` in Morton order.
    [[nodiscard]] CellState at(int position) const;
    friend bool operator==(const TileStates&, const TileStates&) = default;
};

[[nodiscard]] TileStates states_of(const Tile& tile);

/// Where the leaves of a tile that is not all of one state lie: by_level[l] has the bit of the
/// lower left cell of every leaf of side 2^l. All empty when the whole tile has one state.
struct TileLeaves {
    std::array<TileMask, kTileBits> by_level{};

    [[nodiscard]] int count() const;
    /// The same for the blocks of side 2, 4 and 8 (index 0, 1, 2) that are divided.
    [[nodiscard]] std::array<TileMask, kTileBits> inner_nodes() const;
};

[[nodiscard]] TileLeaves leaves_of(const TileStates& states);

/// Appends such leaves to a list, depth first. `corner` is the tile's lower left cell.
void append_leaves(const TileLeaves& in_tile, const TileStates& states, Cell corner,
                   std::vector<Leaf>& leaves);

}  // namespace quadcut
