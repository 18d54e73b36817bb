// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What a follower knows, as a Segmentation.
#include <map>

#include "quadcut/base/error.hpp"
#include "quadcut/follow/follower.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/rooms/describe.hpp"
#include "quadcut/rooms/doors.hpp"
#include "quadcut/rooms/open_space.hpp"

namespace quadcut {
namespace {

constexpr double kMinDoorM = 0.3;

}  // namespace

Segmentation Follower::rooms() const {
    const GridMap grid = map_.to_grid();
    const Raster<CellState> states = map_.to_raster();
    std::map<std::uint32_t, std::uint32_t> place_of_room;
    for (const auto& [id, room] : rooms_) {
        place_of_room.emplace(id, static_cast<std::uint32_t>(place_of_room.size() + 1));
    }
    if (place_of_room.size() > kMaxRoomId || next_id_ > kMaxRoomId + 1) {
        throw InputError("the map has had " + std::to_string(next_id_ - 1) +
                         " rooms: expected at most 65535, the range of a label");
    }
    Segmentation result;
    result.labels =
        Raster<std::uint16_t>(grid.states.origin, grid.states.width, grid.states.height);
    Raster<std::uint32_t> labels({0, 0}, grid.states.width, grid.states.height);
    Raster<std::uint8_t> kept({0, 0}, grid.states.width, grid.states.height);
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        const std::uint32_t room = cells_.room(states.cell(i));
        if (room == 0) continue;
        // What stands in a locked room does not open its border.
        if (states.values[i] != CellState::free && rooms_.at(room).is_locked) continue;
        labels.values[i] = place_of_room.at(room);
        result.labels.values[i] = static_cast<std::uint16_t>(labels.values[i]);
        kept.values[i] = states.values[i] == CellState::free ? 1 : 0;
    }
    const auto count = static_cast<std::uint32_t>(place_of_room.size());
    const RoomsOptions& rooms = options_.segment.rooms;
    Raster<float> clearance = clearance_m(
        open_space(std::move(kept), grid.resolution_m, rooms.max_furniture_m2, executor_),
        grid.resolution_m, executor_);
    const Layout layout = as_it_lies(grid.states.box());
    result.doors =
        find_doors(labels, count, clearance, {layout, grid.resolution_m, grid.map_from_image},
                   kMinDoorM, executor_);
    result.rooms =
        describe_rooms(labels, count, grid, layout, result.doors, executor_, std::move(clearance));
    for (const auto& [id, place] : place_of_room) {
        Room& room = result.rooms[place - 1];
        room.id = RoomId{id};
        const std::string& name = rooms_.at(id).name;
        room.name = name.empty() ? default_name(room.kind, room.id) : name;
    }
    for (Door& door : result.doors) {
        for (RoomId* side : {&door.a, &door.b}) *side = result.rooms[index(*side) - 1].id;
    }
    result.next_id = next_id_;
    return result;
}

}  // namespace quadcut
