// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/followed_map.hpp"

#include <bit>
#include <cmath>
#include <string>

#include "quadcut/base/error.hpp"
#include "quadcut/map/room.hpp"

namespace quadcut {

std::int32_t FollowedMap::in_cells(double length_m) const {
    return static_cast<std::int32_t>(std::ceil(length_m / map.resolution_m()));
}

std::uint32_t take_id(FollowedMap& followed) {
    if (followed.next_id > kMaxRoomId) {
        throw InputError("the map has had " + std::to_string(followed.next_id - 1) +
                         " rooms: expected at most 65535, the range of a label");
    }
    return followed.next_id++;
}

void set_room(FollowedMap& followed, Cell cell, std::uint32_t room, Changes& changes) {
    const std::uint32_t before = followed.cells.room(cell);
    if (!followed.cells.set_room(cell, room)) return;
    changes.note_tile(tile_of(cell));
    changes.note_room(before);
    changes.note_room(room);
}

void note_written(FollowedMap& followed, const std::vector<Cell>& tiles, Changes& changes) {
    for (const Cell tile : tiles) {
        changes.note_tile(tile);
        followed.written.include(cells_of_tiles({tile, tile}));
        const std::uint64_t free = rows_below_zero(followed.map.tile(tile));
        followed.cells.note_free(tile, std::popcount(free));
        const auto found = followed.changed_tiles.find({tile.x, tile.y});
        if (found != followed.changed_tiles.end()) {
            followed.num_changed -= found->second;
            followed.changed_tiles.erase(found);
        }
        const auto count =
            static_cast<std::size_t>(std::popcount(free ^ followed.cells.tile(tile).cut_free));
        if (count == 0) continue;
        followed.changed_tiles[{tile.x, tile.y}] = count;
        followed.num_changed += count;
    }
}

}  // namespace quadcut
