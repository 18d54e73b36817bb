// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What a change makes of rooms, and what takes it back.
#include <algorithm>
#include <set>
#include <utility>

#include "quadcut/base/error.hpp"
#include "quadcut/follow/check_followed.hpp"
#include "quadcut/follow/cut_again.hpp"
#include "quadcut/follow/edits.hpp"
#include "quadcut/follow/live_doors.hpp"
#include "quadcut/follow/split_line.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/flood.hpp"

namespace quadcut {
namespace {

using Border = Reversal::Border;

std::pair<std::int32_t, std::int32_t> tile_at(Cell cell) {
    return {tile_of(cell).x, tile_of(cell).y};
}

std::uint64_t bit_of(Cell cell) { return std::uint64_t{1} << place_in_tile(cell); }

/// In masks of a room: the part that it loses.
constexpr std::uint8_t kPart = 2;

/// What the part shuts off from the most of the room's rest becomes part of it.
void give_what_is_shut_off(Raster<std::uint8_t>& mask) {
    const ConnectedParts rests =
        connected_parts(mask, [&](std::size_t i) { return mask.values[i] == 1 ? 1 : 0; });
    const std::vector<std::size_t> num_cells = rests.num_cells();
    std::vector<bool> is_shut_off(num_cells.size(), false);
    const auto most = std::max_element(num_cells.begin(), num_cells.end()) - num_cells.begin();
    rests.for_each_run([&](const CellRun& run, std::size_t first) {
        for (std::size_t i = first; i < first + (run.end - run.begin); ++i) {
            const Neighbours beside(mask, i, Connectivity::four);
            if (std::any_of(beside.begin(), beside.end(),
                            [&](std::size_t n) { return mask.values[n] == kPart; })) {
                is_shut_off[run.part] = true;
            }
        }
    });
    is_shut_off[static_cast<std::size_t>(most)] = false;
    for (const auto& cells : rests.cells_of(is_shut_off)) {
        for (const std::size_t i : cells) mask.values[i] = kPart;
    }
}

/// Who joins what was cut by hand takes that cut back: as a wall it would part them again.
std::vector<SplitLine> take_split_lines(FollowedMap& followed, const Reversal& change) {
    const std::set<std::uint32_t> both{static_cast<std::uint32_t>(change.room),
                                       static_cast<std::uint32_t>(change.other)};
    const auto is_between = [&](const SplitLine& line) {
        if (std::count(change.lines.begin(), change.lines.end(), line) != 0) return true;
        std::set<std::uint32_t> beside;
        for (const Cell cell : cells_of(line)) {
            // The ends lie in walls, behind which other rooms may be.
            if (followed.cells.room(cell) == 0) continue;
            for (const Cell step : kStepsBeside) {
                beside.insert(followed.cells.room({cell.x + step.x, cell.y + step.y}));
            }
        }
        beside.erase(0);
        return beside == both;
    };
    std::vector<SplitLine>& lines = followed.split_lines;
    const auto first = std::stable_partition(
        lines.begin(), lines.end(), [&](const SplitLine& line) { return !is_between(line); });
    std::vector<SplitLine> taken(first, lines.end());
    lines.erase(first, lines.end());
    return taken;
}

Reversal join(FollowedMap& followed, const Reversal& change, Reversal inverse,
              FollowUpdate& update) {
    const std::uint32_t into = existing(followed, change.room);
    const std::uint32_t from = existing(followed, change.other);
    FollowedRoom& whole = followed.rooms.at(into);
    const FollowedRoom& ended = followed.rooms.at(from);
    if (whole.is_locked || ended.is_locked) {
        throw InputError("one of the rooms is locked: it keeps its border");
    }
    std::vector<Cell> cells;
    bool do_touch = false;
    for_each_cell(ended.box, [&](Cell cell) {
        if (followed.cells.room(cell) != from) return;
        cells.push_back(cell);
        inverse.cells[tile_at(cell)] |= bit_of(cell);
        do_touch = do_touch || followed.cells.is_beside(cell, into);
    });
    if (into == from || !do_touch) {
        throw InputError("rooms " + std::to_string(into) + " and " + std::to_string(from) +
                         " do not touch: a room is connected");
    }
    inverse.border = Border::part;
    inverse.settings[from] = static_cast<const RoomSettings&>(ended);
    inverse.lines = take_split_lines(followed, change);
    for (const Cell cell : cells) set_room(followed, cell, into, update.changes);
    whole.num_cells += ended.num_cells;
    whole.peak_m = std::max(whole.peak_m, ended.peak_m);
    whole.box.include(ended.box);
    whole.announced_m2 += ended.announced_m2;
    followed.rooms.erase(from);
    update.events.push_back(
        {RoomChange::merged, change.other, change.room, inverse.settings[from].name, "by hand"});
    return inverse;
}

/// Of the room and those that were made one with it: where most of the part lies. They may have
/// come apart since.
std::uint32_t holder_of_part(const FollowedMap& followed, const Reversal& change) {
    const auto room = static_cast<std::uint32_t>(change.room);
    const std::uint32_t group = followed.rooms.at(room).merge_group;
    std::map<std::uint32_t, std::size_t> num_cells;
    for (const auto& [tile, cells] : change.cells) {
        const RoomTile& rooms = followed.cells.tile({tile.first, tile.second});
        for (std::size_t i = 0; i < kTileCells; ++i) num_cells[rooms.rooms[i]] += cells >> i & 1;
    }
    std::uint32_t holder = room;
    for (const auto& [id, count] : num_cells) {
        const auto found = followed.rooms.find(id);
        const bool is_one =
            found != followed.rooms.end() && group != 0 && group == found->second.merge_group;
        if (is_one && count > num_cells[holder]) holder = id;
    }
    return holder;
}

Reversal part(FollowedMap& followed, const Reversal& change, Reversal inverse,
              FollowUpdate& update) {
    const auto begun = static_cast<std::uint32_t>(change.other);
    if (begun == 0 || begun >= followed.next_id || followed.rooms.count(begun) != 0) {
        throw InputError("there cannot be a new " + name_of(change.other));
    }
    require_in_map(followed, change.lines);
    const std::uint32_t from = holder_of_part(followed, change);
    FollowedRoom& whole = followed.rooms.at(from);
    if (whole.is_locked) {
        throw InputError(name_of(RoomId{from}) + " is locked: it keeps its border");
    }
    Raster<std::uint8_t> mask = mask_of(followed, from);
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        const auto tile = change.cells.find(tile_at(mask.cell(i)));
        if (mask.values[i] == 0 || tile == change.cells.end()) continue;
        if ((tile->second & bit_of(mask.cell(i))) != 0) mask.values[i] = kPart;
    }
    give_what_is_shut_off(mask);
    FollowedRoom part;
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        if (mask.values[i] != kPart) continue;
        part.box.include({mask.cell(i), mask.cell(i)});
        ++part.num_cells;
    }
    const bool is_all = part.num_cells == whole.num_cells;
    if (part.num_cells == 0 || (is_all && RoomId{from} == change.room)) {
        throw InputError("the floor of one of the rooms " + std::to_string(index(change.room)) +
                         " and " + std::to_string(begun) + " is not there any more");
    }
    part.peak_m = whole.peak_m;
    part.announced_m2 = static_cast<double>(part.num_cells) * followed.cell_m2();
    whole.num_cells -= part.num_cells;
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        if (mask.values[i] == kPart) set_room(followed, mask.cell(i), begun, update.changes);
    }
    if (is_all) followed.rooms.erase(from);
    followed.rooms[begun] = part;
    followed.split_lines.insert(followed.split_lines.end(), change.lines.begin(),
                                change.lines.end());
    inverse.border = Border::join;
    inverse.lines = change.lines;
    update.events.push_back({RoomChange::split, change.other, RoomId{from}, {}, "by hand"});
    return inverse;
}

}  // namespace

Reversal apply(FollowedMap& followed, const Reversal& change, const FollowOptions& options,
               const Executor& executor, FollowUpdate& update) {
    static_cast<void>(existing(followed, change.room));
    Reversal inverse;
    inverse.room = change.room;
    inverse.other = change.other;
    for (const auto& [id, settings] : change.settings) {
        if (followed.rooms.count(id) != 0) inverse.settings[id] = followed.rooms.at(id);
    }
    if (change.border == Border::part) inverse = part(followed, change, std::move(inverse), update);
    if (change.border == Border::join) inverse = join(followed, change, std::move(inverse), update);
    Box changed;
    for (const Cell tile : update.changes.tiles) changed.include(cells_of_tiles({tile, tile}));
    if (!changed.is_empty()) {
        update_doors(followed, changed, {}, options.segment.rooms, executor, update.changes);
    }
    for (const auto& [id, settings] : change.settings) {
        const auto room = followed.rooms.find(id);
        if (room == followed.rooms.end()) continue;
        const bool is_unlocked = room->second.is_locked && !settings.is_locked;
        static_cast<RoomSettings&>(room->second) = settings;
        update.changes.note_room(id);
        if (is_unlocked) catch_up(followed, options, id, executor, update);
    }
    return inverse;
}

}  // namespace quadcut
