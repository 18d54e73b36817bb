// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/map/layout.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// The rooms of 8 x 8 cells of a followed map; cell (x, y) is at 8 y + x.
struct RoomTile {
    /// 0 = none.
    std::array<std::uint32_t, kTileCells> rooms{};
    /// Cells that were free when rooms were last cut there, bit 8 y + x.
    std::uint64_t cut_free = 0;
    friend bool operator==(const RoomTile&, const RoomTile&) = default;
};

/// The room of each cell of a followed map: tiles under a directory that grows with the map, so
/// that memory follows what was seen. It remembers which tiles have changed since they were saved.
class RoomCells {
public:
    /// 0 outside. O(1).
    [[nodiscard]] std::uint32_t room(Cell cell) const {
        return tile(tile_of(cell)).rooms[place_in_tile(cell)];
    }
    /// Empty outside. The reference dies with the next write.
    [[nodiscard]] const RoomTile& tile(Cell tile) const {
        return tiles_[directory_.contains(tile) ? directory_.at(tile) : 0];
    }

    /// Whether a tile has ever had a room, or a mark.
    [[nodiscard]] bool contains(Cell tile) const {
        return directory_.contains(tile) && directory_.at(tile) != 0;
    }

    /// Both mark the tile if something changes.
    void set_room(Cell cell, std::uint32_t room);
    void set_cut_free(Cell cell, bool is_free);
    /// Marks the tile.
    void set_tile(Cell tile, const RoomTile& values);
    /// Says that what belongs to a tile must be saved.
    void mark(Cell tile);
    /// The marked tiles, row by row; none is marked any more.
    [[nodiscard]] std::vector<Cell> take_marked();

    /// Says how many cells of a tile are free now.
    void note_free(Cell tile, int num_free);
    /// How standard_layout() would lay out the free cells, to the nearest tile; without a box.
    /// O(1).
    [[nodiscard]] Layout orientation() const;

    /// Bytes held.
    [[nodiscard]] std::size_t bytes() const;

private:
    /// Sums over cells, of powers of their tiles' x and y.
    struct Moments {
        // The third power of a tile's place, summed over cells, passes 64 bits.
        __extension__ using Integer = __int128;
        std::int64_t count = 0;
        std::array<Integer, 3> x{};
        std::array<Integer, 3> y{};

        void add(Cell tile, std::int64_t cells);
    };

    /// A tile's number, new if it had none.
    std::uint32_t number(Cell tile);

    /// 0 = the empty tile.
    Raster<std::uint32_t> directory_;
    std::vector<RoomTile> tiles_ = std::vector<RoomTile>(1);
    std::vector<bool> is_marked_ = std::vector<bool>(1);
    std::vector<Cell> marked_;
    std::vector<std::uint8_t> num_free_ = std::vector<std::uint8_t>(1);
    /// Of the free cells, by their tiles.
    Moments moments_;
};

}  // namespace quadcut
