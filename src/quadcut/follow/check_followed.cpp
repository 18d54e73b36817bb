// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/check_followed.hpp"

#include <bit>
#include <cmath>
#include <map>
#include <string>

#include "quadcut/base/error.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/room.hpp"

namespace quadcut {
namespace {

std::string name_of(Cell tile) {
    return "tile (" + std::to_string(tile.x) + ", " + std::to_string(tile.y) + ")";
}

bool holds(const Box& box, Cell cell) { return !box.is_empty() && box.contains(cell); }

void check_rooms(const FollowedMap& followed) {
    for (const auto& [id, room] : followed.rooms) {
        const std::string name = "room " + std::to_string(id);
        if (id == 0 || id >= followed.next_id || followed.next_id > kMaxRoomId + 1) {
            throw InputError(name + " has no id that can be");
        }
        if (!holds(followed.written, room.box.low) || !holds(followed.written, room.box.high)) {
            throw InputError(name + " lies outside of the map");
        }
    }
}

void check_cells(const FollowedMap& followed) {
    std::map<std::uint32_t, std::size_t> num_cells;
    const Box tiles{tile_of(followed.written.low), tile_of(followed.written.high)};
    for_each_cell(followed.written.is_empty() ? Box{} : tiles, [&](Cell tile) {
        if (!followed.cells.contains(tile)) return;
        const RoomTile& rooms = followed.cells.tile(tile);
        for (int i = 0; i < static_cast<int>(kTileCells); ++i) {
            const std::uint32_t id = rooms.rooms[static_cast<std::size_t>(i)];
            if (id == 0) continue;
            const auto room = followed.rooms.find(id);
            if (room == followed.rooms.end() || !holds(room->second.box, cell_in(tile, i))) {
                throw InputError(name_of(tile) + " has cells of a room that is not there");
            }
            ++num_cells[id];
        }
    });
    for (const auto& [id, room] : followed.rooms) {
        if (room.num_cells == 0 || room.num_cells != num_cells[id]) {
            throw InputError("room " + std::to_string(id) + " has " +
                             std::to_string(num_cells[id]) + " cells: expected " +
                             std::to_string(room.num_cells));
        }
    }
}

void check_doors(const FollowedMap& followed) {
    for (const auto& [id, placed] : followed.doors) {
        const RoomId a{followed.cells.room(placed.a)};
        const RoomId b{followed.cells.room(placed.b)};
        const bool is_door = a != b && a != RoomId{} && b != RoomId{};
        if (!is_door || placed.door.a != a || placed.door.b != b || id == DoorId{} ||
            index(id) >= followed.next_door_id) {
            throw InputError("door " + std::to_string(index(id)) + " is not between its rooms");
        }
    }
}

void check_covisibility(const FollowedMap& followed) {
    for (const auto& [rooms, scans] : followed.covisibility.scans) {
        const bool are_there =
            followed.rooms.contains(rooms.first) && followed.rooms.contains(rooms.second);
        // A scan adds products of shares, one at most; sums are rounded.
        const double most = 1.001 * static_cast<double>(followed.num_scans);
        if (are_there && rooms.first <= rooms.second && scans >= 0.0 && scans <= most) continue;
        throw InputError("rooms " + std::to_string(rooms.first) + " and " +
                         std::to_string(rooms.second) + " cannot have been seen together");
    }
}

}  // namespace

void check(const FollowedMap& followed) {
    if (followed.cut_at > followed.num_scans) {
        throw InputError("rooms were cut after the last scan");
    }
    require_room_for(followed, {});
    check_rooms(followed);
    require_in_map(followed, followed.split_lines);
    const Box& roomless = followed.seen_roomless;
    if (!roomless.is_empty() &&
        (!holds(followed.written, roomless.low) || !holds(followed.written, roomless.high))) {
        throw InputError("what was seen lies outside of the map");
    }
    check_cells(followed);
    check_doors(followed);
    check_covisibility(followed);
    std::size_t num_changed = 0;
    for (const auto& [tile, count] : followed.changed_tiles) {
        if (!holds(followed.written, first_cell_of({tile.first, tile.second}))) {
            throw InputError(name_of({tile.first, tile.second}) +
                             " has changed and lies outside of the map");
        }
        num_changed += count;
    }
    if (num_changed != followed.num_changed) throw InputError("changed cells are not all there");
}

void require_in_map(const FollowedMap& followed, const std::vector<SplitLine>& lines) {
    Box around = followed.written;
    if (!around.is_empty()) around = around.grown(followed.in_cells(1.0));
    for (const SplitLine& line : lines) {
        if (holds(around, line.from) && holds(around, line.to)) continue;
        throw InputError("a cut by hand lies outside of the map");
    }
}

void require_room_for(const FollowedMap& followed, Box cells) {
    if (!cells.is_empty()) cells = cells_of_tiles({tile_of(cells.low), tile_of(cells.high)});
    if (!followed.written.is_empty()) cells.include(followed.written);
    if (cells.is_empty()) return;
    if (std::int64_t{cells.width()} * cells.height() <= kMaxCellsOfScans) return;
    throw InputError("the followed map would span " + std::to_string(cells.width()) + " x " +
                     std::to_string(cells.height()) + " cells: expected at most " +
                     std::to_string(kMaxCellsOfScans) + "; is a pose wrong?");
}

void add_tile(FollowedMap& followed, Cell tile, const Tile& log_odds, const RoomTile& rooms) {
    if (!holds(followed.written, first_cell_of(tile))) {
        throw InputError(name_of(tile) + " lies outside of the map");
    }
    for (const std::int8_t value : log_odds.values) {
        if (value < kMinLogOdds || value > kMaxLogOdds) {
            throw InputError(name_of(tile) + ": log-odds of " + std::to_string(value));
        }
    }
    followed.map.set_tile(tile, log_odds);
    followed.cells.set_tile(tile, rooms);
    followed.cells.note_free(tile, std::popcount(rows_below_zero(log_odds)));
}

}  // namespace quadcut
