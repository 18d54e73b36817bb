// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
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

/// To the four cells beside one.
inline constexpr std::array<Cell, 4> kStepsBeside{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// The cell at a place of a tile, 8 y + x.
[[nodiscard]] constexpr Cell cell_in(Cell tile, int place) {
    const Cell low = first_cell_of(tile);
    return {low.x + place % kTileSide, low.y + place / kTileSide};
}

/// The room of each cell of a followed map: tiles under a directory that grows with the map, so
/// that memory follows what was seen.
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

    /// Whether one of the four cells beside it belongs to the room.
    [[nodiscard]] bool is_beside(Cell cell, std::uint32_t room) const {
        return std::any_of(kStepsBeside.begin(), kStepsBeside.end(), [&](Cell step) {
            return this->room({cell.x + step.x, cell.y + step.y}) == room;
        });
    }
    /// Whether a tile has ever had a room, or free cells.
    [[nodiscard]] bool contains(Cell tile) const {
        return directory_.contains(tile) && directory_.at(tile) != 0;
    }

    /// Whether that changes anything.
    bool set_room(Cell cell, std::uint32_t room);
    bool set_cut_free(Cell cell, bool is_free);
    void set_tile(Cell tile, const RoomTile& values) { tiles_[number(tile)] = values; }

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
    std::vector<std::uint8_t> num_free_ = std::vector<std::uint8_t>(1);
    /// Of the free cells, by their tiles.
    Moments moments_;
};

}  // namespace quadcut
