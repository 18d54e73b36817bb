// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/followed_result.hpp"

#include <map>
#include <utility>

#include "quadcut/map/clearance.hpp"
#include "quadcut/rooms/describe.hpp"
#include "quadcut/rooms/doors.hpp"
#include "quadcut/rooms/open_space.hpp"

namespace quadcut {

Segmentation result_of(const FollowedMap& followed, const RoomsOptions& options,
                       const Executor& executor) {
    const GridMap grid = followed.map.to_grid();
    const Raster<CellState> states = followed.map.to_raster();
    std::map<std::uint32_t, std::uint32_t> place_of_room;
    for (const auto& [id, room] : followed.rooms) {
        place_of_room.emplace(id, static_cast<std::uint32_t>(place_of_room.size() + 1));
    }
    Segmentation result;
    result.labels =
        Raster<std::uint16_t>(grid.states.origin, grid.states.width, grid.states.height);
    Raster<std::uint32_t> labels({0, 0}, grid.states.width, grid.states.height);
    Raster<std::uint8_t> kept({0, 0}, grid.states.width, grid.states.height);
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        const std::uint32_t room = followed.cells.room(states.cell(i));
        if (room == 0) continue;
        // What stands in a locked room does not open its border.
        const bool is_free = states.values[i] == CellState::free;
        if (!is_free && followed.rooms.at(room).is_locked) continue;
        labels.values[i] = place_of_room.at(room);
        result.labels.values[i] = static_cast<std::uint16_t>(labels.values[i]);
        kept.values[i] = is_free ? 1 : 0;
    }
    const auto count = static_cast<std::uint32_t>(place_of_room.size());
    Raster<float> clearance = clearance_m(
        open_space(std::move(kept), grid.resolution_m, options.max_furniture_m2, executor),
        grid.resolution_m, executor);
    const Layout layout = as_it_lies(grid.states.box());
    result.doors =
        find_doors(labels, count, clearance, {layout, grid.resolution_m, grid.map_from_image},
                   kMinDoorM, executor);
    result.rooms =
        describe_rooms(labels, count, grid, layout, result.doors, executor, std::move(clearance));
    for (const auto& [id, place] : place_of_room) {
        Room& room = result.rooms[place - 1];
        room.id = RoomId{id};
        const std::string& name = followed.rooms.at(id).name;
        room.name = name.empty() ? default_name(room.kind, room.id) : name;
    }
    for (Door& door : result.doors) {
        for (RoomId* side : {&door.a, &door.b}) *side = result.rooms[index(*side) - 1].id;
    }
    result.next_id = followed.next_id;
    return result;
}

}  // namespace quadcut
