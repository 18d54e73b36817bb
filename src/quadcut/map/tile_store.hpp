// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// Log-odds of a rectangle of tiles. A tile of one value costs its directory entry of four bytes,
/// any other 64 bytes more; tiles that become uniform give their bytes back to a free list.
///
/// The first tiles are shared constant ones, one for each value, so that a look-up is two loads and
/// no branch whether its tile is uniform or not. A directory entry is the place of the tile's
/// values less 8 y + x of its lower left cell in the rectangle, so that adding 8 y + x of any of
/// its cells gives the place of that cell: docs/decisions/0001.
class TileStore {
public:
    TileStore();

    /// Log-odds of a cell; 0 outside the rectangle. O(1).
    [[nodiscard]] int log_odds(Cell cell) const {
        // One comparison a side: what is left of the rectangle wraps around to a large number.
        const std::uint32_t x = static_cast<std::uint32_t>(cell.x) - low_x_;
        const std::uint32_t y = static_cast<std::uint32_t>(cell.y) - low_y_;
        if (x >= width_ || y >= height_) return 0;
        const std::uint32_t entry =
            directory_
                .values[std::size_t{y >> kTileBits} * (width_ >> kTileBits) + (x >> kTileBits)];
        // Tiles are arrays of values, one behind the other.
        const auto* values = reinterpret_cast<const std::int8_t*>(tiles_.data());
        return values[entry + kTileSide * y + x];
    }

    /// Rectangle of the directory, in tiles.
    [[nodiscard]] const Raster<std::uint32_t>& directory() const { return directory_; }
    [[nodiscard]] bool contains(Cell tile) const { return directory_.contains(tile); }
    /// Unknown outside the rectangle.
    [[nodiscard]] const Tile& tile(Cell tile) const { return tiles_[number(tile)]; }
    /// The value that all cells share; kMaxLogOdds + 1 if they do not.
    [[nodiscard]] int shared_log_odds(Cell tile) const {
        const std::uint32_t place = number(tile);
        return kMinLogOdds + static_cast<int>(std::min(place, kNumUniform));
    }
    /// All cells share one value and the tile holds no bytes of its own.
    [[nodiscard]] bool is_uniform(Cell tile) const { return number(tile) < kNumUniform; }

    /// Replaces a tile; gives its bytes back when all its cells share one value.
    /// @pre contains(tile).
    void set_tile(Cell tile, const Tile& values);

    /// Makes the rectangle cover these tiles; what it held stays.
    void set_rectangle(const Box& tiles);
    /// Gives back the bytes that no tile needs, if they are more than an eighth of the tiles'.
    /// O(directory) when it does, which as many tiles have paid for by collapsing.
    void give_back();
    /// Gives back all of them.
    void compact();

    /// Tiles that hold bytes of their own.
    [[nodiscard]] std::size_t num_tiles() const {
        return tiles_.size() - kNumUniform - free_.size();
    }
    [[nodiscard]] std::size_t bytes() const;

private:
    static constexpr std::uint32_t kNumUniform = kMaxLogOdds - kMinLogOdds + 1;
    /// The number of the constant tile of a value.
    static constexpr std::uint32_t uniform_number(int log_odds) {
        return static_cast<std::uint32_t>(log_odds - kMinLogOdds);
    }
    [[nodiscard]] std::uint32_t number(Cell tile) const {
        if (!directory_.contains(tile)) return uniform_number(0);
        return (directory_.at(tile) + bias(tile)) / std::uint32_t{kTileCells};
    }
    void set_number(Cell tile, std::uint32_t number) {
        directory_.at(tile) = number * std::uint32_t{kTileCells} - bias(tile);
    }
    /// 8 y + x of a tile's lower left cell, counted from the lower left of the rectangle.
    [[nodiscard]] std::uint32_t bias(Cell tile) const {
        return static_cast<std::uint32_t>(tile.x - directory_.origin.x) * kTileSide +
               static_cast<std::uint32_t>(tile.y - directory_.origin.y) * kTileSide * kTileSide;
    }
    /// A place for a tile that is not uniform.
    [[nodiscard]] std::uint32_t new_place();

    static_assert(sizeof(Tile) == kTileCells);

    Raster<std::uint32_t> directory_;
    /// The rectangle in cells.
    std::uint32_t low_x_ = 0;
    std::uint32_t low_y_ = 0;
    std::uint32_t width_ = 0;
    std::uint32_t height_ = 0;
    std::vector<Tile> tiles_;
    std::vector<std::uint32_t> free_;
};

}  // namespace quadcut
