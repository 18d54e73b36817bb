// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/seen_rooms.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace quadcut {
namespace {

/// Floors of a scan: few rooms are in sight.
void add_floor(std::vector<SeenFloor>& floors, std::uint32_t room, int num_cells) {
    if (room == 0 || num_cells == 0) return;
    auto at = std::find_if(floors.rbegin(), floors.rend(),
                           [room](const SeenFloor& floor) { return floor.room == room; });
    if (at == floors.rend()) {
        floors.push_back({room, 0});
        at = floors.rbegin();
    }
    at->num_cells += static_cast<std::uint32_t>(num_cells);
}

}  // namespace

void count_seen(FollowedMap& followed, const MapUpdate& scan) {
    std::vector<SeenFloor> floors;
    for (std::size_t i = 0; i < scan.observed.size(); ++i) {
        const std::array<std::uint32_t, kTileCells>& rooms =
            followed.cells.tile(scan.observed[i]).rooms;
        std::uint64_t seen = scan.observed_free[i];
        const bool is_of_one = std::all_of(
            rooms.begin(), rooms.end(), [&](std::uint32_t room) { return room == rooms.front(); });
        if (is_of_one) add_floor(floors, rooms.front(), std::popcount(seen));
        for (; seen != 0 && !is_of_one; seen &= seen - 1) {
            add_floor(floors, rooms[static_cast<std::size_t>(std::countr_zero(seen))], 1);
        }
    }
    count_scan(followed.covisibility, floors);
}

void count_events(FollowedMap& followed, const std::vector<RoomEvent>& events) {
    if (events.empty()) return;
    for (const RoomEvent& event : events) {
        if (event.change != RoomChange::merged) continue;
        join_rooms(followed.covisibility, static_cast<std::uint32_t>(event.room),
                   static_cast<std::uint32_t>(event.other));
    }
    std::erase_if(followed.covisibility.scans, [&](const auto& entry) {
        return !followed.rooms.contains(entry.first.first) ||
               !followed.rooms.contains(entry.first.second);
    });
}

}  // namespace quadcut
