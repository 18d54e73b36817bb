// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/live_doors.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "quadcut/follow/beyond.hpp"
#include "quadcut/follow/rooms_in_box.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/rooms/open_space.hpp"

namespace quadcut {
namespace {

/// A door does not depend on what is farther away.
constexpr double kContextM = 10.0;
constexpr double kSameM = 0.5;

std::vector<PlacedDoor> doors_in(const FollowedMap& followed, const Box& box, const Box& wished,
                                 const RoomsOptions& options, const Executor& executor) {
    const Box around = box.grown(followed.in_cells(kContextM));
    const Box window = wished.is_empty() ? around.intersected(followed.written.grown(1)) : wished;
    if (window.is_empty()) return {};
    const double resolution_m = followed.map.resolution_m();
    RoomsInBox there = rooms_in_box(followed, window);
    std::vector<Beyond> beyond;
    for (std::size_t i = 0; i < there.rooms.size(); ++i) {
        const std::size_t total = followed.rooms.at(there.rooms[i]).num_cells;
        const Outside outside{{0}, {total - there.num_cells[i]}, {}, 0};
        beyond.push_back(beyond_of(followed, window, there.rooms[i], outside).front());
    }
    const WallLines lines =
        find_wall_lines(there.free, resolution_m, options.door_width_m, executor);
    const Raster<float> free_clearance = clearance_m(there.free, resolution_m, executor);
    const Raster<float> clearance = clearance_m(
        open_space(std::move(there.free), resolution_m, options.max_furniture_m2, lines, executor),
        resolution_m, executor);
    const Cell low = window.low;
    const Box wanted{{box.low.x - low.x, box.low.y - low.y},
                     {box.high.x - low.x, box.high.y - low.y}};
    std::vector<PlacedDoor> doors = find_doors_in(
        wanted, beyond, there.labels, static_cast<std::uint32_t>(there.rooms.size()),
        {clearance, free_clearance, there.states, lines, resolution_m},
        {as_it_lies(window), resolution_m, followed.map.world_from_map()}, kMinDoorM, executor);
    for (PlacedDoor& found : doors) {
        found.a = {found.a.x + low.x, found.a.y + low.y};
        found.b = {found.b.x + low.x, found.b.y + low.y};
        for (RoomId* room : {&found.door.a, &found.door.b}) {
            *room = RoomId{there.rooms[index(*room) - 1]};
        }
    }
    return doors;
}

/// Rooms may have become others without that anything near the door has changed.
void look_up_rooms(FollowedMap& followed, Changes& changes) {
    for (auto at = followed.doors.begin(); at != followed.doors.end();) {
        auto& [id, placed] = *at;
        const RoomId a{followed.cells.room(placed.a)};
        const RoomId b{followed.cells.room(placed.b)};
        const bool is_door = a != b && a != RoomId{} && b != RoomId{};
        if (!is_door || a != placed.door.a || b != placed.door.b) changes.doors.push_back(id);
        placed.door.a = a;
        placed.door.b = b;
        if (b < a) {
            std::swap(placed.a, placed.b);
            std::swap(placed.door.a, placed.door.b);
            std::swap(placed.door.room_a_width_m, placed.door.room_b_width_m);
        }
        at = is_door ? std::next(at) : followed.doors.erase(at);
    }
}

Point middle_of(const Door& door) {
    return {(door.jamb_1.x + door.jamb_2.x) / 2.0, (door.jamb_1.y + door.jamb_2.y) / 2.0};
}

}  // namespace

void update_doors(FollowedMap& followed, const Box& box, const Box& window,
                  const RoomsOptions& options, const Executor& executor, Changes& changes) {
    look_up_rooms(followed, changes);
    std::map<DoorId, PlacedDoor> before;
    for (auto at = followed.doors.begin(); at != followed.doors.end();) {
        const auto next = std::next(at);
        if (box.contains(at->second.a)) before.insert(followed.doors.extract(at));
        at = next;
    }
    for (const PlacedDoor& found : doors_in(followed, box, window, options, executor)) {
        auto same = before.end();
        double least = kSameM;
        for (auto at = before.begin(); at != before.end(); ++at) {
            const double far = distance(middle_of(at->second.door), middle_of(found.door));
            if (far >= least) continue;
            least = far;
            same = at;
        }
        const bool is_new = same == before.end();
        const DoorId id = is_new ? DoorId{followed.next_door_id++} : same->first;
        if (is_new || same->second != found) changes.doors.push_back(id);
        if (!is_new) before.erase(same);
        followed.doors[id] = found;
    }
    // The others are no more.
    for (const auto& [id, placed] : before) changes.doors.push_back(id);
}

}  // namespace quadcut
