// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// The paper's incremental segmentation of a followed map.
#include <cstdint>
#include <map>
#include <set>

#include "quadcut/follow/follower.hpp"
#include "quadcut/follow/local_submaps.hpp"

namespace quadcut {
namespace {

/// Grows a box to blocks of kWindowBlock cells of the quadtree.
Box whole_blocks(const Box& box, const Root& root) {
    constexpr std::int32_t kMask = kWindowBlock - 1;
    const auto down = [](std::int32_t at, std::int32_t from) { return at - ((at - from) & kMask); };
    return {
        {down(box.low.x, root.lower_left.x), down(box.low.y, root.lower_left.y)},
        {down(box.high.x, root.lower_left.x) + kMask, down(box.high.y, root.lower_left.y) + kMask}};
}

}  // namespace

/// The submaps in an observation that brought something new.
void Follower::note_seen(const std::vector<Cell>& tiles) {
    if (options_.segment.preset != Preset::paper) return;
    for (const Cell tile : tiles) {
        std::uint32_t last = 0;
        for (const std::uint32_t room : cells_.tile(tile).rooms) {
            if (room != 0 && room != last) seen_.insert(room);
            last = room;
        }
    }
}

void Follower::cut_seen_submaps(FollowUpdate& update) {
    // Locked submaps, and the lines where people cut, are walls.
    std::set<std::uint32_t> locked;
    std::map<std::uint32_t, std::uint32_t> merge_groups;
    for (const auto& [number, room] : rooms_) {
        if (room.is_locked) locked.insert(number);
        if (room.merge_group != 0) merge_groups[number] = room.merge_group;
    }
    for (const std::uint32_t number : locked) seen_.erase(number);
    Box box;
    for (const auto& [at, count] : changed_tiles_) {
        // And the tiles beside it.
        const Cell low = first_cell_of({at.first - 1, at.second - 1});
        const Cell end = first_cell_of({at.first + 2, at.second + 2});
        box.include({low, {end.x - 1, end.y - 1}});
    }
    for (const std::uint32_t submap : seen_) {
        if (rooms_.count(submap) != 0) box.include(rooms_.at(submap).box);
    }
    box = whole_blocks(box, map_.root());
    SubmapWindow window{Raster<CellState>(box, CellState::unknown),
                        Raster<std::uint32_t>(box),
                        Raster<std::uint8_t>(box),
                        seen_,
                        merge_groups,
                        options_.resolution_m};
    for (std::size_t i = 0; i < window.states.values.size(); ++i) {
        const Cell cell = window.states.cell(i);
        window.submaps.values[i] = cells_.room(cell);
        const bool is_wall = locked.count(window.submaps.values[i]) != 0 ||
                             split_cells_.count({cell.y, cell.x}) != 0;
        window.states.values[i] = is_wall ? CellState::occupied : map_.state(cell);
        const Cell tile = tile_of(cell);
        window.updated.values[i] = changed_tiles_.count({tile.x, tile.y}) != 0 ? 1 : 0;
    }
    LocalCut cut = cut_submaps(window, options_.segment, executor_);
    const LocalWindow local{window.states, window.submaps, box, options_.resolution_m, {}, {}, {}};
    fill_split_lines(local, cut);
    outside_.clear();
    take_over(local, cut, update);
    seen_.clear();
}

}  // namespace quadcut
