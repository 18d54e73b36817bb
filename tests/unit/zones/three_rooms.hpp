// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/random.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/scan.hpp"
#include "quadcut/segment/result.hpp"
#include "sim/laser.hpp"
#include "tests/unit/rooms/drawing.hpp"

namespace quadcut::test {

/// Rooms 10, 20 and 30 (a, b, c) of 3.5 x 6 m side by side, half a metre a character; the door from
/// a to b is at the bottom, that from b to c at the top, so that none sees through both.
inline const std::vector<std::string> kThreeRooms{
    "#########################", "#aaaaaaa#bbbbbbbbccccccc#", "#aaaaaaa#bbbbbbb#ccccccc#",
    "#aaaaaaa#bbbbbbb#ccccccc#", "#aaaaaaa#bbbbbbb#ccccccc#", "#aaaaaaa#bbbbbbb#ccccccc#",
    "#aaaaaaa#bbbbbbb#ccccccc#", "#aaaaaaa#bbbbbbb#ccccccc#", "#aaaaaaa#bbbbbbb#ccccccc#",
    "#aaaaaaa#bbbbbbb#ccccccc#", "#aaaaaaa#bbbbbbb#ccccccc#", "#aaaaaaa#bbbbbbb#ccccccc#",
    "#aaaaaaaabbbbbbb#ccccccc#", "#########################"};

struct ThreeRooms {
    GridMap map;
    Segmentation rooms;
};

inline ThreeRooms three_rooms() {
    constexpr std::int32_t kScale = 10;
    std::vector<std::string> rows = kThreeRooms;
    for (std::string& row : rows) {
        for (char& c : row) c = c == '#' ? '#' : '.';
    }
    ThreeRooms made{drawn_map(rows, 0.05, kScale), {}};
    const Raster<std::uint32_t> letters = drawn_labels(kThreeRooms);
    Segmentation& rooms = made.rooms;
    rooms.labels = Raster<std::uint16_t>(made.map.states.box());
    for (std::uint32_t id : {10, 20, 30}) {
        Room room;
        room.id = RoomId{id};
        rooms.rooms.push_back(room);
    }
    for (std::size_t i = 0; i < rooms.labels.values.size(); ++i) {
        const Cell cell = rooms.labels.cell(i);
        const std::uint32_t label = letters.at({cell.x / kScale, cell.y / kScale});
        rooms.labels.values[i] = static_cast<std::uint16_t>(label);
        if (label != 0) rooms.rooms[label - 1].area_m2 += 0.0025;
    }
    Door door;
    door.a = RoomId{10};
    door.b = RoomId{20};
    door.jamb_1 = {4.25, 0.5};
    door.jamb_2 = {4.25, 1.0};
    rooms.doors.push_back(door);
    rooms.doors.push_back({RoomId{20}, RoomId{30}, {8.25, 6.0}, {8.25, 6.5}, 0.5, 0.0, 0.0, 1.0});
    return made;
}

/// All around.
inline std::vector<Scan> scans_at(const GridMap& map, const std::vector<Point>& places) {
    const sim::RayCaster world(map);
    sim::LaserOptions laser;
    laser.field_of_view_rad = 2.0 * std::numbers::pi;
    laser.range_noise_m = laser.dropout = 0.0;
    Random random(1);
    std::vector<Scan> scans;
    for (const Point& at : places) {
        scans.push_back(sim::simulate_scan(world, {at.x, at.y, 0.3}, laser, random));
    }
    return scans;
}

/// In a, in the door to b, in b, in the door to c, in c; from within a room none sees as much as a
/// square metre of another.
inline const std::vector<Point> kFivePlaces{
    {3.9, 5.0}, {4.25, 0.75}, {7.75, 3.5}, {8.25, 6.25}, {8.7, 1.0}};

/// One by one.
inline NextScan one_by_one(std::vector<Scan> scans) {
    return [scans = std::move(scans), at = std::size_t{0}]() mutable {
        return at < scans.size() ? std::optional<Scan>(scans[at++]) : std::nullopt;
    };
}

}  // namespace quadcut::test
