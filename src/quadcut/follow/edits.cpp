// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What people change in followed rooms.
#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "quadcut/base/error.hpp"
#include "quadcut/follow/follower.hpp"
#include "quadcut/follow/split_line.hpp"
#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/flood.hpp"
#include "quadcut/rooms/describe.hpp"

namespace quadcut {
namespace {

const std::array<Cell, 4> kBeside{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

std::string name_of(RoomId room) { return "room " + std::to_string(index(room)); }

std::pair<std::int32_t, std::int32_t> tile_at(Cell cell) {
    return {tile_of(cell).x, tile_of(cell).y};
}

std::uint64_t bit_of(Cell cell) { return std::uint64_t{1} << place_in_tile(cell); }

/// Calls visit(cell) for the cells of a room.
template <typename Visit>
void for_each_cell_of(std::uint32_t room, const RoomCells& cells, const Box& box,
                      const Visit& visit) {
    for_each_cell(box, [&](Cell cell) {
        if (cells.room(cell) == room) visit(cell);
    });
}

bool is_beside(Cell cell, std::uint32_t room, const RoomCells& cells) {
    return std::any_of(kBeside.begin(), kBeside.end(), [&](Cell step) {
        return cells.room({cell.x + step.x, cell.y + step.y}) == room;
    });
}

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

}  // namespace

std::uint32_t Follower::existing(RoomId room) const {
    const auto number = static_cast<std::uint32_t>(room);
    if (rooms_.count(number) == 0) {
        throw InputError("there is no " + name_of(room) + ": expected one of the " +
                         std::to_string(rooms_.size()) + " rooms that there are");
    }
    return number;
}

Edited Follower::edit(const Edit& edit) {
    switch (edit.kind) {
        case EditKind::rename:
            return apply(rename(edit.room, edit.name));
        case EditKind::merge:
            return apply(merge(edit.room, edit.other));
        case EditKind::split:
            return apply(split(edit.from, edit.to));
        case EditKind::lock:
            return apply(lock(edit.room));
        case EditKind::unlock:
            return apply(unlock(edit.room));
    }
    throw std::logic_error("an edit of no kind");
}

Reversal Follower::as_is(RoomId room) const {
    Reversal now;
    now.room = room;
    now.settings[static_cast<std::uint32_t>(room)] = rooms_.at(existing(room));
    return now;
}

Reversal Follower::rename(RoomId room, const std::string& name) const {
    Reversal change = as_is(room);
    RoomSettings& settings = change.settings.begin()->second;
    settings.name = name;
    RoomId owner = room_with_default_name(settings.name);
    for (const auto& [id, other] : rooms_) {
        if (!name.empty() && other.name == name) owner = RoomId{id};
    }
    if (owner != RoomId{} && owner != room) {
        throw InputError("'" + settings.name + "' is the name of " + name_of(owner) +
                         ": expected one that no other room has");
    }
    return change;
}

Reversal Follower::merge(RoomId room, RoomId other) const {
    Reversal change = as_is(room);
    change.other = other;
    change.border = Reversal::Border::join;
    if (room == other) throw InputError("a room cannot be merged with itself");
    std::uint32_t& group = change.settings.begin()->second.merge_group;
    if (group == 0) group = static_cast<std::uint32_t>(room);
    const std::uint32_t other_group = rooms_.at(existing(other)).merge_group;
    for (const auto& [id, followed] : rooms_) {
        if (other_group == 0 || followed.merge_group != other_group || RoomId{id} == other)
            continue;
        change.settings[id] = followed;
        change.settings[id].merge_group = group;
    }
    return change;
}

Reversal Follower::lock(RoomId room) const {
    Reversal change = as_is(room);
    if (std::exchange(change.settings.begin()->second.is_locked, true)) {
        throw InputError(name_of(room) + " is locked already");
    }
    return change;
}

Reversal Follower::unlock(RoomId room) const {
    Reversal change = as_is(room);
    if (!std::exchange(change.settings.begin()->second.is_locked, false)) {
        throw InputError(name_of(room) + " is not locked");
    }
    return change;
}

Edited Follower::apply(const Reversal& reversal) {
    static_cast<void>(existing(reversal.room));
    Edited done;
    done.inverse.room = reversal.room;
    done.inverse.other = reversal.other;
    for (const auto& [id, settings] : reversal.settings) {
        if (rooms_.count(id) != 0) done.inverse.settings[id] = rooms_.at(id);
    }
    if (reversal.border == Reversal::Border::part) part(reversal, done);
    if (reversal.border == Reversal::Border::join) join(reversal, done);
    for (const auto& [id, settings] : reversal.settings) {
        const auto room = rooms_.find(id);
        if (room == rooms_.end()) continue;
        const bool is_unlocked = room->second.is_locked && !settings.is_locked;
        static_cast<RoomSettings&>(room->second) = settings;
        if (is_unlocked) catch_up(id, done.update);
    }
    done.update.scan = num_scans_;
    done.update.num_rooms = rooms_.size();
    done.update.num_leaves = map_.num_leaves();
    return done;
}

void Follower::join(const Reversal& reversal, Edited& done) {
    const std::uint32_t into = existing(reversal.room);
    const std::uint32_t from = existing(reversal.other);
    FollowedRoom& whole = rooms_.at(into);
    const FollowedRoom& ended = rooms_.at(from);
    if (whole.is_locked || ended.is_locked) {
        throw InputError("one of the rooms is locked: it keeps its border");
    }
    bool do_touch = false;
    for_each_cell_of(from, cells_, ended.box, [&](Cell cell) {
        done.inverse.cells[tile_at(cell)] |= bit_of(cell);
        do_touch = do_touch || is_beside(cell, into, cells_);
    });
    if (into == from || !do_touch) {
        throw InputError("rooms " + std::to_string(into) + " and " + std::to_string(from) +
                         " do not touch: a room is connected");
    }
    done.inverse.border = Reversal::Border::part;
    const RoomSettings& settings = ended;
    done.inverse.settings[from] = settings;
    done.inverse.lines = take_split_lines(reversal);
    for_each_cell_of(from, cells_, ended.box, [&](Cell cell) { cells_.set_room(cell, into); });
    whole.num_cells += ended.num_cells;
    whole.peak_m = std::max(whole.peak_m, ended.peak_m);
    whole.box.include(ended.box);
    whole.announced_m2 += ended.announced_m2;
    rooms_.erase(from);
    done.update.events.push_back({RoomLife::merged, reversal.other, reversal.room, "by hand"});
}

/// Of the room and those that were made one with it: where most of the part lies. They may have
/// come apart since.
std::uint32_t Follower::holder_of_part(const Reversal& reversal) const {
    const auto room = static_cast<std::uint32_t>(reversal.room);
    const std::uint32_t group = rooms_.at(room).merge_group;
    std::map<std::uint32_t, std::size_t> num_cells;
    for (const auto& [tile, cells] : reversal.cells) {
        const RoomTile& rooms = cells_.tile({tile.first, tile.second});
        for (std::size_t i = 0; i < kTileCells; ++i) num_cells[rooms.rooms[i]] += cells >> i & 1;
    }
    std::uint32_t holder = room;
    for (const auto& [id, count] : num_cells) {
        const auto found = rooms_.find(id);
        const bool is_one =
            found != rooms_.end() && group != 0 && group == found->second.merge_group;
        if (is_one && count > num_cells[holder]) holder = id;
    }
    return holder;
}

void Follower::part(const Reversal& reversal, Edited& done) {
    const auto begun = static_cast<std::uint32_t>(reversal.other);
    if (begun == 0 || begun >= next_id_ || rooms_.count(begun) != 0) {
        throw InputError("there cannot be a new " + name_of(reversal.other));
    }
    const std::uint32_t from = holder_of_part(reversal);
    FollowedRoom& whole = rooms_.at(from);
    if (whole.is_locked)
        throw InputError(name_of(RoomId{from}) + " is locked: it keeps its border");
    Raster<std::uint8_t> mask = mask_of(from);
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        const auto tile = reversal.cells.find(tile_at(mask.cell(i)));
        if (mask.values[i] == 0 || tile == reversal.cells.end()) continue;
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
    if (part.num_cells == 0 || (is_all && RoomId{from} == reversal.room)) {
        throw InputError("the floor of one of the rooms " + std::to_string(index(reversal.room)) +
                         " and " + std::to_string(begun) + " is not there any more");
    }
    part.peak_m = whole.peak_m;
    part.announced_m2 =
        static_cast<double>(part.num_cells) * options_.resolution_m * options_.resolution_m;
    whole.num_cells -= part.num_cells;
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        if (mask.values[i] == kPart) cells_.set_room(mask.cell(i), begun);
    }
    if (is_all) rooms_.erase(from);
    rooms_[begun] = part;
    for (const SplitLine& line : reversal.lines) add_split_line(line);
    done.inverse.border = Reversal::Border::join;
    done.inverse.lines = reversal.lines;
    done.update.events.push_back({RoomLife::split, reversal.other, RoomId{from}, "by hand"});
}

/// Cells of a room that was locked and are not free, or free ones beside it that have no room, are
/// changes since it was cut.
void Follower::catch_up(std::uint32_t room, FollowUpdate& update) {
    MapUpdate change;
    const Box box = rooms_.at(room).box.grown(1);
    std::set<std::pair<std::int32_t, std::int32_t>> tiles;
    for_each_cell(box, [&](Cell cell) {
        const bool is_free = map_.state(cell) == CellState::free;
        const std::uint32_t own = cells_.room(cell);
        if (is_free ? own != 0 || !is_beside(cell, room, cells_) : own != room) return;
        // What is noted as a change already is cut in its time.
        const std::uint64_t cut_free = cells_.tile(tile_of(cell)).cut_free;
        if (((cut_free & bit_of(cell)) != 0) != is_free) return;
        cells_.set_cut_free(cell, !is_free);
        tiles.insert(tile_at(cell));
    });
    for (const auto& [x, y] : tiles) change.written.push_back({x, y});
    note_changes(change);
    if (!tiles.empty()) cut_again(0.0, update);
}

Raster<std::uint8_t> Follower::mask_of(std::uint32_t room) const {
    const Box& box = rooms_.at(room).box;
    Raster<std::uint8_t> mask(box);
    for_each_cell_of(room, cells_, box, [&](Cell cell) { mask.at(cell) = 1; });
    return mask;
}

void Follower::add_split_line(const SplitLine& line) {
    split_lines_.push_back(line);
    for (const Cell cell : cells_of(line)) split_cells_.emplace(cell.y, cell.x);
}

/// Who joins what was cut by hand takes that cut back: as a wall it would part them again.
std::vector<SplitLine> Follower::take_split_lines(const Reversal& reversal) {
    const std::set<std::uint32_t> both{static_cast<std::uint32_t>(reversal.room),
                                       static_cast<std::uint32_t>(reversal.other)};
    std::vector<SplitLine> taken;
    split_cells_.clear();
    for (const SplitLine& line : std::exchange(split_lines_, {})) {
        std::set<std::uint32_t> beside;
        for (const Cell cell : cells_of(line)) {
            // The ends lie in walls, behind which other rooms may be.
            if (cells_.room(cell) == 0) continue;
            for (const Cell step : kBeside) {
                beside.insert(cells_.room({cell.x + step.x, cell.y + step.y}));
            }
        }
        beside.erase(0);
        const bool is_named = std::count(reversal.lines.begin(), reversal.lines.end(), line) != 0;
        if (is_named || beside == both) {
            taken.push_back(line);
        } else {
            add_split_line(line);
        }
    }
    return taken;
}

/// The cells of lines where people cut belong to the room beside them.
void Follower::fill_split_lines(const LocalWindow& window, LocalCut& cut) const {
    bool is_any = true;
    while (is_any) {
        is_any = false;
        for (const auto& [y, x] : split_cells_) {
            if (!window.states.contains({x, y}) || map_.state({x, y}) != CellState::free) continue;
            if (cut.regions.at({x, y}) != 0) continue;
            for (const Cell step : kBeside) {
                const Cell beside{x + step.x, y + step.y};
                if (!cut.regions.contains(beside)) continue;
                const std::uint32_t region = cut.regions.at(beside);
                if (region == 0 || region == kNotCut) continue;
                cut.regions.at({x, y}) = region;
                is_any = true;
                break;
            }
        }
    }
}

}  // namespace quadcut
