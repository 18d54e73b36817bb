// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/take_over.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "quadcut/follow/beyond.hpp"
#include "quadcut/follow/match_rooms.hpp"

namespace quadcut {
namespace {

/// A room has grown when it is so much larger than when that was last said.
constexpr double kGrownShare = 1.25;
constexpr double kGrownM2 = 2.0;

/// What the regions of a window and the rooms there share.
struct Overlaps {
    /// Cells by region and room, those outside of the window included.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> shared;
    std::vector<std::size_t> region_cells;
    /// Cells of each room in the window.
    std::map<std::uint32_t, std::size_t> cells_inside;
};

/// Who the regions are.
struct Names {
    std::vector<std::uint32_t> room_of_region;
    /// The rooms that new regions were a part of.
    std::map<std::uint32_t, std::uint32_t> parents;
    /// The regions that have most of a room.
    std::map<std::uint32_t, std::uint32_t> heirs;
};

/// Calls `visit(part)` for each part of a room that goes on outside, once a group.
template <typename Visit>
void for_each_group(const WindowCut& cut, const Visit& visit) {
    std::set<std::pair<std::uint32_t, std::size_t>> seen;
    for (const KeptPart& part : cut.kept) {
        if (part.region != 0 && seen.insert({part.room, part.group}).second) visit(part);
    }
}

Overlaps find_overlaps(const Window& window, const WindowCut& cut) {
    Overlaps overlaps;
    overlaps.region_cells.assign(cut.num_regions + std::size_t{1}, 0);
    std::pair<std::uint32_t, std::uint32_t> last;
    std::size_t* count = nullptr;
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        const std::pair here(cut.regions.values[i], window.rooms.values[i]);
        if (here.first == kNotCut) continue;
        // Neighbouring cells mostly have the same.
        if (count == nullptr || here != last) count = &overlaps.shared[last = here];
        ++*count;
        ++overlaps.region_cells[here.first];
    }
    for (const auto& [pair, cells] : overlaps.shared) {
        if (pair.second != 0) overlaps.cells_inside[pair.second] += cells;
    }
    std::erase_if(overlaps.shared, [](const auto& entry) {
        return entry.first.first == 0 || entry.first.second == 0;
    });
    for_each_group(cut, [&](const KeptPart& part) {
        const std::size_t cells = cut.outside.at(part.room).num_cells[part.group];
        overlaps.region_cells[part.region] += cells;
        overlaps.shared[{part.region, part.room}] += cells;
    });
    return overlaps;
}

Names name_regions(FollowedMap& followed, const Overlaps& overlaps, FollowUpdate& update) {
    std::map<std::uint32_t, std::size_t> place_of_room;
    std::vector<std::uint32_t> rooms;
    std::vector<double> room_cells;
    std::vector<Meeting> meetings;
    for (const auto& [pair, cells] : overlaps.shared) {
        const auto [region, room] = pair;
        const auto [place, is_new] = place_of_room.emplace(room, rooms.size());
        if (is_new) rooms.push_back(room);
        if (is_new) room_cells.push_back(static_cast<double>(followed.rooms.at(room).num_cells));
        meetings.push_back({place->second, region, static_cast<double>(cells)});
    }
    const std::vector<double> region_cells(overlaps.region_cells.begin(),
                                           overlaps.region_cells.end());
    const Kinship kinship = match_rooms(room_cells, region_cells, std::move(meetings));
    Names names;
    for (std::size_t room = 0; room < rooms.size(); ++room) {
        const std::size_t heir = kinship.earlier[room].holder;
        if (heir != kNoKin) names.heirs[rooms[room]] = static_cast<std::uint32_t>(heir);
    }
    names.room_of_region.push_back(0);
    for (std::size_t region = 1; region < region_cells.size(); ++region) {
        const Kin& kin = kinship.now[region];
        names.room_of_region.push_back(kin.same != kNoKin ? rooms[kin.same] : take_id(followed));
        if (kin.same != kNoKin) continue;
        const std::uint32_t room = names.room_of_region.back();
        const std::uint32_t parent = kin.holder != kNoKin ? rooms[kin.holder] : 0;
        if (parent != 0) names.parents[room] = parent;
        update.events.push_back(event_of(parent == 0 ? RoomChange::born : RoomChange::split,
                                         RoomId{room}, RoomId{parent}, {},
                                         region_cells[region] * followed.cell_m2()));
    }
    return names;
}

/// The rooms of the window's cells, and of what is connected with them outside.
void write_cells(FollowedMap& followed, const Window& window, const WindowCut& cut,
                 const Names& names, FollowUpdate& update) {
    // First all that is outside is found, then it gets its new rooms: one may be the name of
    // another.
    std::vector<std::pair<Cell, std::uint32_t>> outside;
    for_each_group(cut, [&](const KeptPart& part) {
        const std::uint32_t now = names.room_of_region[part.region];
        if (now == part.room) return;
        for (const Cell cell :
             cells_outside(followed, window, part.room, cut.outside.at(part.room), part.group)) {
            outside.emplace_back(cell, now);
        }
    });
    const double cell_m2 = followed.cell_m2();
    for (const auto& [cell, now] : outside) {
        set_room(followed, cell, now, update.changes);
        update.relabelled_m2 += cell_m2;
    }
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        const Cell cell = cut.regions.cell(i);
        if (window.decided.contains(cell)) {
            const bool is_free = followed.map.state(cell) == CellState::free;
            if (followed.cells.set_cut_free(cell, is_free)) update.changes.note_tile(tile_of(cell));
        }
        if (cut.regions.values[i] == kNotCut) continue;
        const std::uint32_t now = names.room_of_region[cut.regions.values[i]];
        const std::uint32_t before = window.rooms.values[i];
        if (before != 0 && now != 0 && before != now) update.relabelled_m2 += cell_m2;
        set_room(followed, cell, now, update.changes);
    }
}

/// What was decided has changed no more, and its openings are those that were found now.
void note_decided(FollowedMap& followed, const Window& window, const WindowCut& cut) {
    const Cell low = tile_of(window.decided.low);
    const Cell high = tile_of(window.decided.high);
    for (auto at = followed.changed_tiles.begin(); at != followed.changed_tiles.end();) {
        const auto [x, y] = at->first;
        const bool is_done = x > low.x && x < high.x && y > low.y && y < high.y;
        if (is_done) followed.num_changed -= at->second;
        at = is_done ? followed.changed_tiles.erase(at) : std::next(at);
    }
    std::erase_if(followed.openings,
                  [&](const RoomOpening& opening) { return window.decided.contains(opening.a); });
    followed.openings.insert(followed.openings.end(), cut.openings.begin(), cut.openings.end());
}

/// The rooms of the window with what they have now.
std::map<std::uint32_t, FollowedRoom> rooms_after(const FollowedMap& followed, const WindowCut& cut,
                                                  const Overlaps& overlaps, const Names& names) {
    std::map<std::uint32_t, FollowedRoom> rooms;
    for (const auto& [room, cells] : overlaps.cells_inside) {
        rooms[room] = followed.rooms.at(room);
        rooms[room].num_cells -= cells;
    }
    // What rooms have outside goes to their heirs.
    for_each_group(cut, [&](const KeptPart& part) {
        const std::uint32_t now = names.room_of_region[part.region];
        if (now == part.room) return;
        const std::size_t cells = cut.outside.at(part.room).num_cells[part.group];
        rooms[part.room].num_cells -= cells;
        rooms[now].num_cells += cells;
        rooms[now].box.include(followed.rooms.at(part.room).box);
    });
    // A part that leaves a room which people made one is drawn to it when they touch again.
    for (const auto& [room, parent] : names.parents) {
        rooms[room].merge_group = followed.rooms.at(parent).merge_group;
    }
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        const std::uint32_t region = cut.regions.values[i];
        if (region == 0 || region == kNotCut) continue;
        FollowedRoom& room = rooms[names.room_of_region[region]];
        ++room.num_cells;
        room.box.include({cut.regions.cell(i), cut.regions.cell(i)});
    }
    for (std::uint32_t region = 1; region < names.room_of_region.size(); ++region) {
        FollowedRoom& room = rooms[names.room_of_region[region]];
        room.peak_m = std::max(room.peak_m, cut.peak_m.empty() ? 0.0 : cut.peak_m[region]);
    }
    return rooms;
}

void end_room(FollowedMap& followed, std::uint32_t id, const Names& names, FollowUpdate& update) {
    const auto heir = names.heirs.find(id);
    const bool is_merged = heir != names.heirs.end();
    update.events.push_back(
        event_of(is_merged ? RoomChange::merged : RoomChange::retired, RoomId{id},
                 is_merged ? RoomId{names.room_of_region[heir->second]} : RoomId{},
                 followed.rooms.at(id).name, 0.0));
    followed.rooms.erase(id);
}

void update_rooms(FollowedMap& followed, const std::map<std::uint32_t, FollowedRoom>& rooms,
                  const Names& names, FollowUpdate& update) {
    for (const auto& [id, after] : rooms) {
        FollowedRoom room = after;
        if (room.num_cells == 0) {
            end_room(followed, id, names, update);
            continue;
        }
        const double area_m2 = static_cast<double>(room.num_cells) * followed.cell_m2();
        if (room.announced_m2 == 0.0) room.announced_m2 = area_m2;
        if (area_m2 > kGrownShare * room.announced_m2 + kGrownM2) {
            update.events.push_back(
                {RoomChange::grown, RoomId{id}, RoomId{}, room.name,
                 "from " + square_metres(room.announced_m2) + " to " + square_metres(area_m2)});
            room.announced_m2 = area_m2;
        }
        followed.rooms[id] = std::move(room);
    }
}

}  // namespace

void take_over(FollowedMap& followed, const Window& window, const WindowCut& cut,
               FollowUpdate& update) {
    update.graph_nodes = std::max(update.graph_nodes, cut.num_nodes);
    const Overlaps overlaps = find_overlaps(window, cut);
    const Names names = name_regions(followed, overlaps, update);
    const auto rooms = rooms_after(followed, cut, overlaps, names);
    write_cells(followed, window, cut, names, update);
    note_decided(followed, window, cut);
    update_rooms(followed, rooms, names, update);
}

}  // namespace quadcut
