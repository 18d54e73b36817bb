// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// One window of a followed map: read, cut, named, written back.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "quadcut/follow/follower.hpp"

namespace quadcut {
namespace {

/// A room has grown when it is so much larger than when that was last said.
constexpr double kGrownShare = 1.25;
constexpr double kGrownM2 = 2.0;
/// Rooms with cells this near to a change are cut again, as far as this from it.
constexpr double kTouchedM = 1.0;
constexpr double kFarM = 20.0;
/// What lies farther than this from a cell plays next to no part in what is decided there.
constexpr double kContextM = 10.0;

std::string square_metres(double area_m2) {
    return std::to_string(static_cast<long>(std::lround(area_m2))) + " m^2";
}

}  // namespace

/// All that changed and what the door model sees from there, and the rooms that it touches: what is
/// known of them now may be more than when they were cut. Of a large room only what is near.
Box Follower::cells_to_decide(const Box& changed) const {
    const Box near = changed.grown(in_cells(kNarrowingReachM));
    const Box touched = changed.grown(in_cells(kTouchedM));
    const Box far = changed.grown(in_cells(kFarM));
    std::set<std::uint32_t> rooms;
    for (std::int32_t y = touched.low.y; y <= touched.high.y; ++y) {
        for (std::int32_t x = touched.low.x; x <= touched.high.x; ++x) {
            if (cells_.room({x, y}) != 0) rooms.insert(cells_.room({x, y}));
        }
    }
    Box decided = near;
    for (const std::uint32_t number : rooms) {
        const FollowedRoom& room = rooms_.at(number);
        if (!room.is_locked) decided.include(room.box);
    }
    return {{std::max(decided.low.x, far.low.x), std::max(decided.low.y, far.low.y)},
            {std::min(decided.high.x, far.high.x), std::min(decided.high.y, far.high.y)}};
}

/// Locked rooms and the lines where people cut are walls to what is around them.
LocalWindow Follower::read_window(const Box& decided) const {
    // Nothing is known outside of what was written.
    const Box around = decided.grown(in_cells(kContextM));
    const Box box{
        {std::max(around.low.x, written_.low.x - 1), std::max(around.low.y, written_.low.y - 1)},
        {std::min(around.high.x, written_.high.x + 1),
         std::min(around.high.y, written_.high.y + 1)}};
    LocalWindow window{Raster<CellState>(box, CellState::unknown),
                       Raster<std::uint32_t>(box),
                       decided,
                       options_.resolution_m,
                       cells_.orientation(),
                       {},
                       {}};
    for (const auto& [number, room] : rooms_) {
        if (room.is_locked) window.locked.insert(number);
        if (room.merge_group != 0) window.merge_groups[number] = room.merge_group;
    }
    for (std::size_t i = 0; i < window.states.values.size(); ++i) {
        const Cell cell = window.states.cell(i);
        window.states.values[i] = map_.state(cell);
        window.rooms.values[i] = cells_.room(cell);
        if (window.locked.empty() || window.locked.count(window.rooms.values[i]) == 0) continue;
        window.states.values[i] = CellState::occupied;
    }
    for (const auto& [y, x] : split_cells_) {
        if (box.contains({x, y})) window.states.at({x, y}) = CellState::occupied;
    }
    return window;
}

void Follower::cut_window(const Box& decided, FollowUpdate& update) {
    const LocalWindow window = read_window(decided);
    outside_.clear();
    LocalCut cut = cut_locally(
        window, options_.segment,
        [&](std::uint32_t room, const std::vector<Cell>& cells,
            const Raster<std::uint32_t>& parts) { return look_beyond(window, room, cells, parts); },
        executor_);
    fill_split_lines(window, cut);
    take_over(window, cut, update);
    note_decided(decided);
}

void Follower::take_over(const LocalWindow& window, const LocalCut& cut, FollowUpdate& update) {
    update.graph_nodes = std::max(update.graph_nodes, cut.num_nodes);
    const Overlaps overlaps = find_overlaps(window, cut);
    const std::vector<std::uint32_t> room_of_region =
        name_regions(overlaps, cut.num_regions, update);
    write_window(window, cut, room_of_region, update);
    update_rooms(cut, overlaps, room_of_region, update);
}

/// Calls `visit(room, group, region)` for each part of a room that goes on outside, once a group.
template <typename Visit>
void Follower::for_each_group(const LocalCut& cut, const Visit& visit) const {
    std::map<std::uint32_t, std::size_t> next_part;
    std::set<std::pair<std::uint32_t, std::size_t>> seen;
    for (std::size_t k = 0; k < cut.kept.size(); ++k) {
        const std::uint32_t room = cut.kept[k].room;
        const std::size_t group = outside_.at(room).group_of_part[next_part[room]++];
        const std::uint32_t region = cut.region_of_kept[k];
        if (region != 0 && seen.insert({room, group}).second) visit(room, group, region);
    }
}

/// What regions and rooms share, in the window and beyond.
Follower::Overlaps Follower::find_overlaps(const LocalWindow& window, const LocalCut& cut) const {
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
    for_each_group(cut, [&](std::uint32_t room, std::size_t group, std::uint32_t region) {
        const std::size_t cells = outside_.at(room).num_cells[group];
        overlaps.region_cells[region] += cells;
        overlaps.shared[{region, room}] += cells;
    });
    return overlaps;
}

/// Ids by what regions and rooms share, the largest first (see track()).
std::vector<std::uint32_t> Follower::name_regions(const Overlaps& overlaps,
                                                  std::uint32_t num_regions, FollowUpdate& update) {
    std::vector<std::array<std::size_t, 3>> largest_first;
    for (const auto& [pair, count] : overlaps.shared) {
        largest_first.push_back({count, pair.first, pair.second});
    }
    std::stable_sort(largest_first.begin(), largest_first.end(),
                     [](const auto& p, const auto& q) { return p[0] > q[0]; });
    std::vector<std::uint32_t> room_of_region(num_regions + std::size_t{1}, 0);
    std::vector<std::uint32_t> parents(num_regions + std::size_t{1}, 0);
    std::map<std::uint32_t, std::uint32_t> region_of_room;
    heirs_.clear();
    for (const auto& [count, region_number, room_number] : largest_first) {
        const auto region = static_cast<std::uint32_t>(region_number);
        const auto room = static_cast<std::uint32_t>(room_number);
        const bool has_room = 2 * count >= rooms_.at(room).num_cells;
        const bool has_region = 2 * count >= overlaps.region_cells[region];
        if (has_room) heirs_.emplace(room, region);
        if (has_region && parents[region] == 0) parents[region] = room;
        if ((has_room || has_region) && room_of_region[region] == 0 &&
            region_of_room.emplace(room, region).second) {
            room_of_region[region] = room;
        }
    }
    const double cell_m2 = options_.resolution_m * options_.resolution_m;
    for (std::uint32_t region = 1; region <= num_regions; ++region) {
        if (room_of_region[region] != 0) continue;
        room_of_region[region] = new_id();
        const std::string area =
            square_metres(static_cast<double>(overlaps.region_cells[region]) * cell_m2);
        const bool is_born = parents[region] == 0;
        update.events.push_back({is_born ? RoomLife::born : RoomLife::split,
                                 RoomId{room_of_region[region]}, RoomId{parents[region]},
                                 area + (is_born ? " seen for the first time" : " behind a door")});
    }
    return room_of_region;
}

void Follower::write_window(const LocalWindow& window, const LocalCut& cut,
                            const std::vector<std::uint32_t>& room_of_region,
                            FollowUpdate& update) {
    const double cell_m2 = options_.resolution_m * options_.resolution_m;
    // First all that is outside is found, then it gets its new rooms: one may be the name of
    // another.
    std::vector<std::pair<Cell, std::uint32_t>> outside;
    for_each_group(cut, [&](std::uint32_t room, std::size_t group, std::uint32_t region) {
        if (room_of_region[region] == room) return;
        for (const Cell cell : cells_outside(window, room, group)) {
            outside.emplace_back(cell, room_of_region[region]);
        }
    });
    for (const auto& [cell, now] : outside) {
        cells_.set_room(cell, now);
        update.relabelled_m2 += cell_m2;
    }
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        const Cell cell = cut.regions.cell(i);
        if (window.decided.contains(cell)) {
            cells_.set_cut_free(cell, map_.state(cell) == CellState::free);
        }
        if (cut.regions.values[i] == kNotCut) continue;
        const std::uint32_t now = room_of_region[cut.regions.values[i]];
        const std::uint32_t before = window.rooms.values[i];
        if (before != 0 && now != 0 && before != now) update.relabelled_m2 += cell_m2;
        cells_.set_room(cell, now);
    }
    const Cell low = tile_of(window.decided.low);
    const Cell high = tile_of(window.decided.high);
    for (auto at = changed_tiles_.begin(); at != changed_tiles_.end();) {
        const auto [x, y] = at->first;
        const bool is_done = x > low.x && x < high.x && y > low.y && y < high.y;
        if (is_done) num_changed_ -= at->second;
        at = is_done ? changed_tiles_.erase(at) : std::next(at);
    }
    std::erase_if(openings_,
                  [&](const LocalOpening& opening) { return window.decided.contains(opening.a); });
    openings_.insert(openings_.end(), cut.openings.begin(), cut.openings.end());
}

void Follower::update_rooms(const LocalCut& cut, const Overlaps& overlaps,
                            const std::vector<std::uint32_t>& room_of_region,
                            FollowUpdate& update) {
    std::map<std::uint32_t, FollowedRoom> changed;
    for (const auto& [room, cells] : overlaps.cells_inside) {
        changed[room] = rooms_.at(room);
        changed[room].num_cells -= cells;
    }
    // What rooms have outside goes to their heirs.
    for_each_group(cut, [&](std::uint32_t room, std::size_t group, std::uint32_t region) {
        const std::uint32_t now = room_of_region[region];
        if (now == room) return;
        changed[room].num_cells -= outside_.at(room).num_cells[group];
        changed[now].num_cells += outside_.at(room).num_cells[group];
        changed[now].box.include(rooms_.at(room).box);
    });
    // A part that leaves a room which people made one is drawn to it when they touch again.
    for (const LifeEvent& event : update.events) {
        const auto parent = rooms_.find(static_cast<std::uint32_t>(event.other));
        if (event.life != RoomLife::split || parent == rooms_.end()) continue;
        const auto child = static_cast<std::uint32_t>(event.room);
        if (rooms_.count(child) == 0) changed[child].merge_group = parent->second.merge_group;
    }
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        const std::uint32_t region = cut.regions.values[i];
        if (region == 0 || region == kNotCut) continue;
        FollowedRoom& room = changed[room_of_region[region]];
        ++room.num_cells;
        const Cell cell = cut.regions.cell(i);
        room.box.include({cell, cell});
    }
    for (std::uint32_t region = 1; region <= cut.num_regions; ++region) {
        FollowedRoom& room = changed[room_of_region[region]];
        room.peak_m = std::max(room.peak_m, cut.peak_m.empty() ? 0.0 : cut.peak_m[region]);
    }
    const double cell_m2 = options_.resolution_m * options_.resolution_m;
    for (auto& [id, room] : changed) {
        if (room.num_cells == 0) {
            rooms_.erase(id);
            const auto heir = heirs_.find(id);
            update.events.push_back(heir != heirs_.end()
                                        ? LifeEvent{RoomLife::merged, RoomId{id},
                                                    RoomId{room_of_region[heir->second]},
                                                    "nothing like a door is between them"}
                                        : LifeEvent{RoomLife::retired, RoomId{id}, RoomId{},
                                                    "its floor is no longer free"});
            continue;
        }
        const double area_m2 = static_cast<double>(room.num_cells) * cell_m2;
        if (room.announced_m2 == 0.0) room.announced_m2 = area_m2;
        if (area_m2 > kGrownShare * room.announced_m2 + kGrownM2) {
            update.events.push_back(
                {RoomLife::grown, RoomId{id}, RoomId{},
                 "from " + square_metres(room.announced_m2) + " to " + square_metres(area_m2)});
            room.announced_m2 = area_m2;
        }
        rooms_[id] = room;
    }
}

}  // namespace quadcut
