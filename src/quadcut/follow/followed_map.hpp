// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/follow/edit.hpp"
#include "quadcut/follow/follow_update.hpp"
#include "quadcut/follow/room_cells.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "quadcut/map/tile.hpp"
#include "quadcut/rooms/doors.hpp"

namespace quadcut {

/// A room that is followed.
struct FollowedRoom : RoomSettings {
    std::size_t num_cells = 0;
    /// The largest clearance that was found in it.
    double peak_m = 0.0;
    /// Holds all its cells; may be larger.
    Box box;
    /// Its area when it was last said to have grown.
    double announced_m2 = 0.0;
    /// Its cells when all of it was last decided in one state of the map around.
    std::size_t decided_cells = 0;
    /// The next part of it to be refined.
    std::size_t next_block = 0;
};

/// An opening between two rooms: their cells at its widest place.
struct RoomOpening {
    Cell a;
    Cell b;
    float clearance_m = 0.0F;
};

/// All that is known of a building that is followed: what is saved, drawn, served and compared.
struct FollowedMap {
    explicit FollowedMap(double resolution_m) : map(resolution_m) {}

    OccupancyMap map;
    /// The room of each cell.
    RoomCells cells;
    /// By id.
    std::map<std::uint32_t, FollowedRoom> rooms;
    std::vector<RoomOpening> openings;
    std::map<DoorId, PlacedDoor> doors;
    std::vector<SplitLine> split_lines;
    /// Holds all tiles that were written, in cells.
    Box written;
    /// Tiles, by x and y, with cells that are free now and were not when rooms were last cut there,
    /// or the other way round, and how many.
    std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> changed_tiles;
    /// In all changed tiles.
    std::size_t num_changed = 0;
    /// Changed cells that the last cut left alone, in patches that are too small.
    std::size_t num_left_over = 0;
    /// Preset `paper`: submaps seen with something new since the last cut.
    std::set<std::uint32_t> seen;
    /// And what else was seen then: tiles with free cells that have no room, in cells.
    Box seen_roomless;
    /// Where the robot was, in order.
    std::vector<Cell> way;
    std::size_t num_scans = 0;
    /// The number of scans when rooms were last cut.
    std::size_t cut_at = 0;
    /// No room, and no door, has had this id or a higher one.
    std::uint32_t next_id = 1;
    std::uint32_t next_door_id = 1;
    /// Rises by one with each update.
    std::uint64_t revision = 0;

    [[nodiscard]] double cell_m2() const { return map.resolution_m() * map.resolution_m(); }
    /// Rounded up.
    [[nodiscard]] std::int32_t in_cells(double length_m) const;
};

/// A room's id that was never given. Throws InputError when there is none left.
[[nodiscard]] std::uint32_t take_id(FollowedMap& followed);

/// Sets the room of a cell.
void set_room(FollowedMap& followed, Cell cell, std::uint32_t room, Changes& changes);

/// Takes note of tiles that were written: compares what is free in them with what was when rooms
/// were last cut there.
void note_written(FollowedMap& followed, const std::vector<Cell>& tiles, Changes& changes);

/// The room at a point of the map frame; 0 = none. O(1).
[[nodiscard]] RoomId room_at(const FollowedMap& followed, const Point& point);

/// All tiles that were seen, and all rooms and doors that there are or were, as changes.
[[nodiscard]] Changes everything_in(const FollowedMap& followed);

}  // namespace quadcut
