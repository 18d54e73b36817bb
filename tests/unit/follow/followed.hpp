// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "quadcut/follow/edit.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/map/scan.hpp"
#include "quadcut/segment/result.hpp"
#include "sim/building.hpp"
#include "sim/robot.hpp"

namespace quadcut::test {

/// A furnished building of eight rooms.
inline sim::Building small_building(std::uint64_t seed) {
    sim::BuildingOptions options;
    options.seed = seed;
    options.num_rooms = 8;
    options.furniture = 0.3;
    return sim::generate_building(options);
}

inline std::vector<Scan> scans_in(const sim::Building& building) {
    sim::RobotOptions robot;
    robot.seed = 1;
    return sim::explore(building.map, sim::start_pose(building), robot).scans;
}

inline std::set<RoomId> ids_of(const Segmentation& rooms) {
    std::set<RoomId> ids;
    for (const Room& room : rooms.rooms) ids.insert(room.id);
    return ids;
}

/// A free floor of 12 x 5 m with walls around, from cell (0, 0) on.
inline Raster<CellState> bare_hall() {
    Raster<CellState> states({0, 0}, 260, 120, CellState::occupied);
    for (std::int32_t y = 10; y < 110; ++y) {
        for (std::int32_t x = 10; x < 250; ++x) states.at({x, y}) = CellState::free;
    }
    return states;
}

/// The same with a wall across at x = 5 m and a door of 0.9 m in its middle.
inline Raster<CellState> hall_with_wall() {
    Raster<CellState> states = bare_hall();
    for (std::int32_t y = 10; y < 110; ++y) {
        for (std::int32_t x = 100; x < 104; ++x) {
            if (y < 50 || y >= 68) states.at({x, y}) = CellState::occupied;
        }
    }
    return states;
}

inline Edit rename(RoomId room, const std::string& name) {
    return {EditKind::rename, room, {}, name, {}, {}};
}
inline Edit merge(RoomId room, RoomId other) { return {EditKind::merge, room, other, {}, {}, {}}; }
inline Edit split(const Point& from, const Point& to) {
    return {EditKind::split, {}, {}, {}, from, to};
}
inline Edit lock(RoomId room) { return {EditKind::lock, room, {}, {}, {}, {}}; }
inline Edit unlock(RoomId room) { return {EditKind::unlock, room, {}, {}, {}, {}}; }

}  // namespace quadcut::test
