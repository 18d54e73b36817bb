// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/followed_result.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "quadcut/follow/rooms_in_box.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/rooms/describe.hpp"
#include "quadcut/rooms/doors.hpp"
#include "quadcut/rooms/glimpses.hpp"
#include "quadcut/rooms/open_space.hpp"
#include "quadcut/zones/zones.hpp"

namespace quadcut {

Segmentation result_of(const FollowedMap& followed, const RoomsOptions& options,
                       const Executor& executor, const ZoneOptions& zones) {
    const GridMap grid = followed.map.to_grid();
    const Box box = followed.map.to_raster().box();
    RoomsInBox known = rooms_in_box(followed, box);
    const auto count = static_cast<std::uint32_t>(known.rooms.size());
    Segmentation result;
    result.labels = Raster<std::uint16_t>(grid.states.box());
    std::copy(known.labels.values.begin(), known.labels.values.end(), result.labels.values.begin());
    const WallLines lines =
        find_wall_lines(known.free, grid.resolution_m, options.door_width_m, executor);
    const Raster<float> free_clearance = clearance_m(known.free, grid.resolution_m, executor);
    Raster<float> clearance = clearance_m(open_space(std::move(known.free), grid.resolution_m,
                                                     options.max_furniture_m2, lines, executor),
                                          grid.resolution_m, executor);
    const Layout layout = as_it_lies(grid.states.box());
    result.doors = find_doors(
        known.labels, count, {clearance, free_clearance, grid.states, lines, grid.resolution_m},
        {layout, grid.resolution_m, grid.map_from_image}, kMinDoorM, executor);
    result.rooms = describe_rooms(known.labels, count, grid, layout, result.doors, executor,
                                  std::move(clearance));
    std::vector<Cell> way;
    for (const Cell cell : followed.way) way.push_back({cell.x - box.low.x, cell.y - box.low.y});
    judge_seen(result.rooms, known.labels, grid.states, layout, grid.resolution_m, result.doors,
               way, executor);
    for (std::size_t i = 0; i < known.rooms.size(); ++i) {
        Room& room = result.rooms[i];
        room.id = RoomId{known.rooms[i]};
        const std::string& name = followed.rooms.at(known.rooms[i]).name;
        room.name = name.empty() ? default_name(room) : name;
    }
    for (Door& door : result.doors) {
        for (RoomId* side : {&door.a, &door.b}) *side = result.rooms[index(*side) - 1].id;
    }
    result.next_id = followed.next_id;
    result.zones = find_zones(result, followed.covisibility, zones);
    return result;
}

}  // namespace quadcut
