// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// A set of cells by tiles, bit 8 y + x for cell (x, y) of a tile: memory goes with the cells, not
/// with the box around them.
class TileSet {
public:
    [[nodiscard]] bool contains(Cell cell) const {
        return (rows(tile_of(cell)) >> place_in_tile(cell) & 1U) != 0;
    }
    [[nodiscard]] std::uint64_t rows(Cell tile) const {
        const auto found = rows_.find(key_of(tile));
        return found == rows_.end() ? 0 : found->second;
    }
    /// New ones are 0, or what `make(tile)` says.
    [[nodiscard]] std::uint64_t& rows(Cell tile) { return rows_[key_of(tile)]; }
    template <typename Make>
    [[nodiscard]] std::uint64_t& rows(Cell tile, const Make& make) {
        const auto [at, is_new] = rows_.try_emplace(key_of(tile), 0);
        if (is_new) at->second = make(tile);
        return at->second;
    }

    /// Calls `visit(tile, rows)` for each tile, in any order.
    template <typename Visit>
    void for_each(const Visit& visit) const {
        for (const auto& [key, rows] : rows_) {
            visit(Cell{static_cast<std::int32_t>(key >> 32U), static_cast<std::int32_t>(key)},
                  rows);
        }
    }

private:
    static std::uint64_t key_of(Cell tile) {
        return std::uint64_t{static_cast<std::uint32_t>(tile.x)} << 32U |
               static_cast<std::uint32_t>(tile.y);
    }

    std::unordered_map<std::uint64_t, std::uint64_t> rows_;
};

/// The cells of a tile that one may walk on, as bits.
using WaysOfTile = std::function<std::uint64_t(Cell tile)>;

/// The parts that cells are connected in, found from some of their cells: eight cells at a time.
class TileWalk {
public:
    explicit TileWalk(WaysOfTile ways_of) : ways_of_(std::move(ways_of)) {}
    /// The cell `from`, whether it is a way or not, and all that one can walk to from there in
    /// steps to the four neighbours. What is taken is no way any more. O(tiles taken).
    [[nodiscard]] TileSet take(Cell from);

private:
    WaysOfTile ways_of_;
    /// Of the tiles that were asked for.
    TileSet ways_;
};

}  // namespace quadcut
