// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What a follower remembers, and how it goes on from there.
#include <bit>
#include <string>

#include "quadcut/base/error.hpp"
#include "quadcut/follow/follower.hpp"

namespace quadcut {
namespace {

std::string name_of(Cell tile) {
    return "tile (" + std::to_string(tile.x) + ", " + std::to_string(tile.y) + ")";
}

bool holds(const Box& box, Cell cell) { return !box.is_empty() && box.contains(cell); }

}  // namespace

Follower::Follower(const FollowOptions& options, const FollowerState& state, const RunOptions& run)
    : options_(with_preset(options)),
      executor_(run.executor()),
      map_(state.root ? OccupancyMap(options.resolution_m, {}, *state.root)
                      : OccupancyMap(options.resolution_m)),
      num_scans_(state.num_scans),
      written_(state.written),
      rooms_(state.rooms),
      openings_(state.openings),
      next_id_(state.next_id),
      num_left_over_(state.num_left_over),
      cut_at_(state.cut_at),
      seen_(state.seen) {
    if (cut_at_ > num_scans_) throw InputError("rooms were cut after the last scan");
    if (!written_.is_empty()) require_room_for(written_);
    take_rooms(state);
    for (const FollowedTile& tile : state.tiles) take_tile(tile);
    map_.commit();
    if (state.root && map_.root() != *state.root) throw InputError("tiles lie outside of the map");
    static_cast<void>(cells_.take_marked());
    for (const auto& [id, room] : rooms_) {
        if (room.num_cells == 0) throw InputError("room " + std::to_string(id) + " has no cells");
    }
    for (const auto& [tile, count] : state.changed_tiles) {
        const bool is_new = changed_tiles_.emplace(std::pair{tile.x, tile.y}, count).second;
        if (!is_new || !holds(written_, first_cell_of(tile))) {
            throw InputError(name_of(tile) + " has changed twice, or lies outside of the map");
        }
        num_changed_ += count;
    }
}

void Follower::take_rooms(const FollowerState& state) {
    std::erase_if(seen_, [&](std::uint32_t room) { return rooms_.count(room) == 0; });
    for (auto& [id, room] : rooms_) {
        const std::string name = "room " + std::to_string(id);
        if (id == 0 || id >= next_id_ || next_id_ > kMaxRoomId + 1) {
            throw InputError(name + " has no id that can be");
        }
        room.num_cells = 0;
        if (!holds(written_, room.box.low) || !holds(written_, room.box.high)) {
            throw InputError(name + " lies outside of the map");
        }
    }
    for (const SplitLine& line : state.split_lines) {
        // The ends lie in walls, which need not be seen.
        Box around = written_;
        if (!around.is_empty()) around = around.grown(in_cells(1.0));
        if (!holds(around, line.from) || !holds(around, line.to)) {
            throw InputError("a cut by hand lies outside of the map");
        }
        add_split_line(line);
    }
}

void Follower::take_tile(const FollowedTile& tile) {
    const Cell low = first_cell_of(tile.tile);
    if (!holds(written_, low)) throw InputError(name_of(tile.tile) + " lies outside of the map");
    for (const std::int8_t value : tile.log_odds.values) {
        if (value < kMinLogOdds || value > kMaxLogOdds) {
            throw InputError(name_of(tile.tile) + ": log-odds of " + std::to_string(value));
        }
    }
    for (std::size_t i = 0; i < kTileCells; ++i) {
        if (tile.rooms.rooms[i] == 0) continue;
        const auto room = rooms_.find(tile.rooms.rooms[i]);
        const Cell cell{low.x + static_cast<std::int32_t>(i % kTileSide),
                        low.y + static_cast<std::int32_t>(i / kTileSide)};
        if (room == rooms_.end() || !holds(room->second.box, cell)) {
            throw InputError(name_of(tile.tile) + " has cells of a room that is not there");
        }
        ++room->second.num_cells;
    }
    map_.set_tile(tile.tile, tile.log_odds);
    cells_.set_tile(tile.tile, tile.rooms);
    cells_.note_free(tile.tile, std::popcount(free_rows(tile.log_odds)));
}

FollowerState Follower::state_since_save() {
    FollowerState state;
    if (map_.is_placed()) state.root = map_.root();
    state.written = written_;
    state.num_scans = num_scans_;
    state.next_id = next_id_;
    state.num_left_over = num_left_over_;
    state.cut_at = cut_at_;
    state.rooms = rooms_;
    state.openings = openings_;
    for (LocalOpening& opening : state.openings) {
        opening.room_a = cells_.room(opening.a);
        opening.room_b = cells_.room(opening.b);
    }
    state.cell_m2 = options_.resolution_m * options_.resolution_m;
    for (const auto& [at, count] : changed_tiles_) {
        state.changed_tiles.push_back({{at.first, at.second}, count});
    }
    state.split_lines = split_lines_;
    state.seen = seen_;
    for (const Cell tile : cells_.take_marked()) {
        state.tiles.push_back({tile, map_.tile(tile), cells_.tile(tile)});
    }
    return state;
}

}  // namespace quadcut
