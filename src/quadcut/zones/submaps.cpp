// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/submaps.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "quadcut/map/layout.hpp"
#include "quadcut/rooms/describe.hpp"
#include "quadcut/segment/reading_order.hpp"
#include "quadcut/zones/conductance.hpp"
#include "quadcut/zones/zones.hpp"

namespace quadcut {
namespace {

/// The doors between zones, as those of regions with the zones' numbers as ids.
std::vector<Door> doors_between(const Segmentation& rooms, const Zones& zones) {
    std::map<RoomId, RoomId> region_of;
    for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
        region_of[rooms.rooms[i].id] = RoomId{zones.zone_of_room[i]};
    }
    std::vector<Door> doors;
    for (Door door : rooms.doors) {
        door.a = region_of.at(door.a);
        door.b = region_of.at(door.b);
        if (door.a != door.b) doors.push_back(door);
    }
    return doors;
}

std::string why_not(std::size_t found, std::size_t asked) {
    return "asked for " + std::to_string(asked) + " submaps, found " + std::to_string(found) +
           (found > asked ? ": the building has parts that no doors join"
                          : ": the map has no more narrowings that could be doors");
}

}  // namespace

Segmentation joined_into_submaps(Segmentation rooms, std::size_t count, const GridMap& map,
                                 const Executor& executor) {
    if (count < rooms.rooms.size()) {
        const Zones zones = find_zones(conductance_graph(rooms), {count, ZoneWeights::conductance});
        rooms.doors = doors_between(rooms, zones);
        Raster<std::uint32_t> regions({0, 0}, map.states.width, map.states.height);
        for (std::size_t i = 0; i < regions.values.size(); ++i) {
            std::uint16_t& label = rooms.labels.values[i];
            if (label == 0) continue;
            regions.values[i] = zones.zone_of_room[label - std::size_t{1}];
            label = static_cast<std::uint16_t>(regions.values[i]);
        }
        rooms.rooms = describe_rooms(regions, zones.count, map, as_it_lies(map.states.box()),
                                     rooms.doors, executor);
        rooms.next_id = zones.count + 1;
        number_in_reading_order(rooms, map, executor);
    }
    if (rooms.rooms.size() != count && !rooms.rooms.empty()) {
        rooms.report.warnings.push_back(why_not(rooms.rooms.size(), count));
    }
    return rooms;
}

}  // namespace quadcut
