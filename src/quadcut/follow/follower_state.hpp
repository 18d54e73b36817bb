// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/follow/local_cut.hpp"
#include "quadcut/follow/room_cells.hpp"
#include "quadcut/map/root.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// What people say of a room.
struct RoomSettings {
    /// Empty: the default name.
    std::string name;
    /// Not 0: made one by people; rooms of one group that touch are one room.
    std::uint32_t merge_group = 0;
    /// Its cells are its own whatever is seen there.
    bool is_locked = false;
};

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

/// A cut that people drew: to the rooms on both sides it is a wall.
struct SplitLine {
    Cell from;
    Cell to;
    friend bool operator==(const SplitLine&, const SplitLine&) = default;
};

/// All that is known of one tile.
struct FollowedTile {
    Cell tile;
    Tile log_odds;
    RoomTile rooms;
};

/// What a Follower has to remember to go on as if nothing had happened.
struct FollowerState {
    /// Nothing: no cell was seen yet.
    std::optional<Root> root;
    /// Holds all tiles that were written, in cells.
    Box written;
    double cell_m2 = 0.0;
    std::size_t num_scans = 0;
    std::uint32_t next_id = 1;
    /// Changed cells that the last cut left alone, in patches that are too small.
    std::size_t num_left_over = 0;
    /// The number of scans when rooms were last cut.
    std::size_t cut_at = 0;
    std::map<std::uint32_t, FollowedRoom> rooms;
    std::vector<LocalOpening> openings;
    /// Tiles with changes that are not cut yet, and the number of changed cells.
    std::vector<std::pair<Cell, std::size_t>> changed_tiles;
    std::vector<SplitLine> split_lines;
    /// Submaps seen with something new since the last cut.
    std::set<std::uint32_t> seen;
    std::vector<FollowedTile> tiles;
};

}  // namespace quadcut
