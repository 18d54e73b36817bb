// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "quadcut/follow/room_cells.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// Rooms whose id has changed although they are the same: 80 % of the cells of both, the room then
/// and the room now, are shared. Tiles of `tiles` only. O(tiles).
inline std::size_t count_id_switches(const RoomCells& then, const RoomCells& now,
                                     const Box& tiles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> shared;
    std::map<std::uint32_t, std::size_t> cells_then;
    std::map<std::uint32_t, std::size_t> cells_now;
    for (Cell at = tiles.low; at.y <= tiles.high.y; ++at.y) {
        for (at.x = tiles.low.x; at.x <= tiles.high.x; ++at.x) {
            const RoomTile& a = then.tile(at);
            const RoomTile& b = now.tile(at);
            for (std::size_t i = 0; i < kTileCells;) {
                // Most tiles lie in one room.
                std::size_t end = i + 1;
                while (end < kTileCells && a.rooms[end] == a.rooms[i] && b.rooms[end] == b.rooms[i])
                    ++end;
                const std::size_t count = end - i;
                if (a.rooms[i] != 0) cells_then[a.rooms[i]] += count;
                if (b.rooms[i] != 0) cells_now[b.rooms[i]] += count;
                if (a.rooms[i] != 0 && b.rooms[i] != 0) {
                    shared[{a.rooms[i], b.rooms[i]}] += count;
                }
                i = end;
            }
        }
    }
    std::size_t switches = 0;
    for (const auto& [pair, count] : shared) {
        const bool is_same =
            10 * count >= 8 * cells_then[pair.first] && 10 * count >= 8 * cells_now[pair.second];
        if (is_same && pair.first != pair.second) ++switches;
    }
    return switches;
}

}  // namespace quadcut
