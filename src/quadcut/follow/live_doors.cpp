// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/live_doors.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "quadcut/follow/beyond.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/rooms/open_space.hpp"

namespace quadcut {
namespace {

/// A door does not depend on what is farther away.
constexpr double kContextM = 10.0;
constexpr double kSameM = 0.5;

/// What is around a door, from cell (0, 0) on.
struct Surroundings {
    /// The rooms' places in `rooms`, from 1 on.
    Raster<std::uint32_t> labels;
    std::vector<std::uint32_t> rooms;
    std::vector<std::size_t> num_cells;
    Raster<std::uint8_t> free;
};

Surroundings look_around(const FollowedMap& followed, const Box& box) {
    Surroundings around{Raster<std::uint32_t>({0, 0}, box.width(), box.height()),
                        {},
                        {},
                        Raster<std::uint8_t>({0, 0}, box.width(), box.height())};
    std::map<std::uint32_t, std::uint32_t> places;
    for_each_cell(box, [&](Cell cell) { places.emplace(followed.cells.room(cell), 0); });
    places.erase(0);
    for (auto& [room, place] : places) {
        around.rooms.push_back(room);
        place = static_cast<std::uint32_t>(around.rooms.size());
    }
    around.num_cells.assign(around.rooms.size(), 0);
    std::size_t i = 0;
    for_each_cell(box, [&](Cell cell) {
        const std::size_t at = i++;
        const std::uint32_t room = followed.cells.room(cell);
        if (room == 0) return;
        const std::uint32_t place = places.at(room);
        ++around.num_cells[place - 1];
        const bool is_free = followed.map.state(cell) == CellState::free;
        // What stands in a locked room does not open its border.
        if (!is_free && followed.rooms.at(room).is_locked) return;
        around.labels.values[at] = place;
        around.free.values[at] = is_free ? 1 : 0;
    });
    return around;
}

std::vector<PlacedDoor> doors_in(const FollowedMap& followed, const Box& box,
                                 const RoomsOptions& options, const Executor& executor) {
    const Box window =
        box.grown(followed.in_cells(kContextM)).intersected(followed.written.grown(1));
    if (window.is_empty()) return {};
    const double resolution_m = followed.map.resolution_m();
    Surroundings around = look_around(followed, window);
    std::vector<Beyond> beyond;
    for (std::size_t i = 0; i < around.rooms.size(); ++i) {
        const std::size_t total = followed.rooms.at(around.rooms[i]).num_cells;
        const Outside outside{{0}, {total - around.num_cells[i]}, {}, 0};
        beyond.push_back(beyond_of(followed, window, around.rooms[i], outside).front());
    }
    const Raster<float> clearance = clearance_m(
        open_space(std::move(around.free), resolution_m, options.max_furniture_m2, executor),
        resolution_m, executor);
    const Cell low = window.low;
    const Box wanted{{box.low.x - low.x, box.low.y - low.y},
                     {box.high.x - low.x, box.high.y - low.y}};
    std::vector<PlacedDoor> doors = find_doors_in(
        wanted, beyond, around.labels, static_cast<std::uint32_t>(around.rooms.size()), clearance,
        {as_it_lies(window), resolution_m, followed.map.world_from_map()}, kMinDoorM, executor);
    for (PlacedDoor& found : doors) {
        found.a = {found.a.x + low.x, found.a.y + low.y};
        found.b = {found.b.x + low.x, found.b.y + low.y};
        for (RoomId* room : {&found.door.a, &found.door.b}) {
            *room = RoomId{around.rooms[index(*room) - 1]};
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

void update_doors(FollowedMap& followed, const Box& box, const RoomsOptions& options,
                  const Executor& executor, Changes& changes) {
    look_up_rooms(followed, changes);
    std::map<DoorId, PlacedDoor> before;
    for (auto at = followed.doors.begin(); at != followed.doors.end();) {
        const auto next = std::next(at);
        if (box.contains(at->second.a)) before.insert(followed.doors.extract(at));
        at = next;
    }
    for (const PlacedDoor& found : doors_in(followed, box, options, executor)) {
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
