// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/followed_map.hpp"

#include <bit>
#include <cmath>
#include <string>

#include "quadcut/base/error.hpp"
#include "quadcut/base/geometry.hpp"
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

RoomId room_at(const FollowedMap& followed, const Point& point) {
    const double x = point.x / followed.map.resolution_m();
    const double y = point.y / followed.map.resolution_m();
    // Beyond it no cell has an address. Written so that NaN is nowhere, too.
    constexpr double kFar = 268435456.0;
    if (!(std::abs(x) < kFar && std::abs(y) < kFar)) return RoomId{};
    return RoomId{followed.cells.room(followed.map.cell_at(point))};
}

Changes everything_in(const FollowedMap& followed) {
    Changes changes;
    const Box tiles{tile_of(followed.written.low), tile_of(followed.written.high)};
    for_each_cell(followed.written.is_empty() ? Box{} : tiles, [&](Cell tile) {
        if (followed.cells.contains(tile)) changes.tiles.push_back(tile);
    });
    for (std::uint32_t id = 1; id < followed.next_id; ++id) changes.rooms.push_back(RoomId{id});
    for (std::uint32_t id = 1; id < followed.next_door_id; ++id) {
        changes.doors.push_back(DoorId{id});
    }
    changes.revision = followed.revision;
    return changes;
}

}  // namespace quadcut
