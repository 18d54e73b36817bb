// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Rooms that have become others since they were decided.
#include <algorithm>
#include <cstdint>

#include "quadcut/follow/follower.hpp"

namespace quadcut {
namespace {

/// A room is refined in blocks of this side.
constexpr double kBlockM = 20.0;

}  // namespace

/// What a decision goes by may lie farther from a change than a window reaches: the area of a room,
/// and its other doors. So rooms that have become others are decided again, a block at a time.
bool Follower::refine_stalest(double min_stale, FollowUpdate& update) {
    std::uint32_t stalest = 0;
    for (const auto& [id, room] : rooms_) {
        const auto larger = static_cast<double>(std::max(room.num_cells, room.decided_cells));
        const auto smaller = static_cast<double>(std::min(room.num_cells, room.decided_cells));
        const double stale = 1.0 - smaller / larger;
        if (room.is_locked || stale < min_stale) continue;
        min_stale = stale;
        stalest = id;
    }
    if (stalest == 0) return false;
    FollowedRoom& room = rooms_.at(stalest);
    const auto side = static_cast<std::int32_t>(kBlockM / options_.resolution_m);
    const std::int32_t columns = (room.box.width() + side - 1) / side;
    const std::int32_t rows = (room.box.height() + side - 1) / side;
    const auto num_blocks = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    const auto block = static_cast<std::int32_t>(room.next_block % num_blocks);
    const Cell low{room.box.low.x + block % columns * side,
                   room.box.low.y + block / columns * side};
    const Box part{
        low,
        {std::min(low.x + side - 1, room.box.high.x), std::min(low.y + side - 1, room.box.high.y)}};
    const bool is_last = ++room.next_block >= num_blocks;
    cut_window(part.grown(in_cells(kNarrowingReachM)), update);
    const auto after = rooms_.find(stalest);
    if (is_last && after != rooms_.end()) {
        after->second.next_block = 0;
        after->second.decided_cells = after->second.num_cells;
    }
    return true;
}

void Follower::note_decided(const Box& decided) {
    for (auto& [id, room] : rooms_) {
        if (!decided.contains(room.box.low) || !decided.contains(room.box.high)) continue;
        room.decided_cells = room.num_cells;
        room.next_block = 0;
    }
}

}  // namespace quadcut
