// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/ids.hpp"
#include "quadcut/follow/room_event.hpp"

namespace quadcut {

/// What is not as it was in a followed map; each once, in order.
struct Changes {
    /// The number of the state that they led to.
    std::uint64_t revision = 0;
    /// 8 x 8 cells (8 x .., 8 y ..) whose log-odds or rooms may have changed, row by row.
    std::vector<Cell> tiles;
    /// Rooms that began, ended, or have other cells or settings.
    std::vector<RoomId> rooms;
    /// Doors that began, ended, or are others.
    std::vector<DoorId> doors;

    [[nodiscard]] std::size_t size() const { return tiles.size() + rooms.size() + doors.size(); }
    void note_tile(Cell tile) {
        if (tiles.empty() || tiles.back() != tile) tiles.push_back(tile);
    }
    void note_room(std::uint32_t room) {
        if (room == 0 || (!rooms.empty() && rooms.back() == RoomId{room})) return;
        rooms.push_back(RoomId{room});
    }
};

/// What one update did: a line of updates.jsonl.
struct FollowUpdate {
    std::size_t scan = 0;
    double integrate_ms = 0.0;
    double segment_ms = 0.0;
    std::size_t num_leaves = 0;
    std::size_t nodes_touched = 0;
    std::size_t nodes_rebuilt = 0;
    /// Eq. (12).
    double ps = 0.0;
    /// Of the largest graph that was cut; 0 when none was.
    std::size_t graph_nodes = 0;
    std::size_t num_rooms = 0;
    double relabelled_m2 = 0.0;
    /// Cells that were looked at to cut.
    std::size_t cells_read = 0;
    std::vector<RoomEvent> events;
    Changes changes;
};

}  // namespace quadcut
