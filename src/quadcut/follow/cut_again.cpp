// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/cut_again.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "quadcut/base/stage_clock.hpp"
#include "quadcut/follow/cut_submaps.hpp"
#include "quadcut/follow/cut_window.hpp"
#include "quadcut/follow/live_doors.hpp"
#include "quadcut/follow/take_over.hpp"
#include "quadcut/rooms/narrowing.hpp"

namespace quadcut {
namespace {

/// Changes within about this of each other are cut together.
constexpr double kPatchM = 4.0;
/// What lies farther than this from a cell plays next to no part in what is decided there.
constexpr double kContextM = 10.0;
/// A room is refined in blocks of this side; after each cut, when so much of it has come or gone.
constexpr double kBlockM = 20.0;
constexpr double kMuchStale = 0.1;

/// Patches of changes, by nearness.
std::vector<Box> patches(const FollowedMap& followed) {
    const auto block_tiles = static_cast<std::int32_t>(
        std::max(1.0, std::ceil(kPatchM / (followed.map.resolution_m() * kTileSide))));
    const auto block_of = [&](std::int32_t tile) {
        return static_cast<std::int32_t>(std::floor(static_cast<double>(tile) / block_tiles));
    };
    std::map<std::pair<std::int32_t, std::int32_t>, Box> blocks;
    for (const auto& [at, count] : followed.changed_tiles) {
        const Cell tile{at.first, at.second};
        blocks[{block_of(tile.x), block_of(tile.y)}].include(cells_of_tiles({tile, tile}));
    }
    std::vector<Box> result;
    while (!blocks.empty()) {
        std::vector<std::pair<std::int32_t, std::int32_t>> waiting{blocks.begin()->first};
        Box patch;
        while (!waiting.empty()) {
            const auto at = waiting.back();
            waiting.pop_back();
            const auto found = blocks.find(at);
            if (found == blocks.end()) continue;
            patch.include(found->second);
            blocks.erase(found);
            for (std::int32_t dy = -1; dy <= 1; ++dy) {
                for (std::int32_t dx = -1; dx <= 1; ++dx) {
                    waiting.emplace_back(at.first + dx, at.second + dy);
                }
            }
        }
        result.push_back(patch);
    }
    return result;
}

std::size_t num_changed_in(const FollowedMap& followed, const Box& box) {
    std::size_t count = 0;
    const Cell low = tile_of(box.low);
    const Cell high = tile_of(box.high);
    for (auto at = followed.changed_tiles.lower_bound({low.x, low.y});
         at != followed.changed_tiles.end() && at->first.first <= high.x; ++at) {
        if (at->first.second >= low.y && at->first.second <= high.y) count += at->second;
    }
    return count;
}

void cut_box(FollowedMap& followed, const Box& decided, const SegmentOptions& options,
             const Executor& executor, FollowUpdate& update) {
    // Nothing is known outside of what was written.
    const Box around =
        decided.grown(followed.in_cells(kContextM)).intersected(followed.written.grown(1));
    const Window window = read_window(followed, around, decided);
    WindowCut cut = cut_window(followed, window, options, executor);
    fill_split_lines(followed, cut);
    if (drops_uncrossed(options)) drop_uncrossed(followed.way, cut);
    const std::size_t num_before = std::max<std::size_t>(1, update.changes.tiles.size());
    take_over(followed, window, cut, update);
    update.cells_read += cut.cells_read;
    // Pieces that reach into what is decided are decided as a whole.
    Box changed = decided;
    for (std::size_t i = num_before - 1; i < update.changes.tiles.size(); ++i) {
        const Cell tile = update.changes.tiles[i];
        const Box cells = cells_of_tiles({tile, tile}).intersected(around);
        if (!cells.is_empty()) changed.include(cells);
    }
    update_doors(followed, changed, cut.all_cut, options.rooms, executor, update.changes);
    for (auto& [id, room] : followed.rooms) {
        if (!decided.contains(room.box.low) || !decided.contains(room.box.high)) continue;
        room.decided_cells = room.num_cells;
        room.next_block = 0;
    }
}

void cut_seen(FollowedMap& followed, const SegmentOptions& options, const Executor& executor,
              FollowUpdate& update) {
    if (followed.num_changed == 0) return;
    for (const auto& [id, room] : followed.rooms) {
        if (room.is_locked) followed.seen.erase(id);
    }
    const Window window = window_of_seen(followed);
    WindowCut cut = cut_submaps(followed, window, options, executor);
    fill_split_lines(followed, cut);
    if (drops_uncrossed(options)) drop_uncrossed(followed.way, cut);
    take_over(followed, window, cut, update);
    update.cells_read += cut.cells_read;
    update_doors(followed, window.decided, {}, options.rooms, executor, update.changes);
    followed.seen.clear();
    followed.seen_roomless = {};
}

void cut_patches(FollowedMap& followed, const FollowOptions& options, double min_patch_m2,
                 const Executor& executor, FollowUpdate& update) {
    bool is_cut = false;
    for (const Box& box : patches(followed)) {
        // A window before may have decided it already.
        const std::size_t count = num_changed_in(followed, box);
        if (count == 0 || static_cast<double>(count) * followed.cell_m2() < min_patch_m2) continue;
        cut_box(followed, cells_to_decide(followed, box), options.segment, executor, update);
        is_cut = true;
    }
    if (is_cut) refine_stalest(followed, options, kMuchStale, executor, update);
    followed.num_left_over = followed.num_changed;
}

double stale_share(const FollowedRoom& room) {
    const auto [smaller, larger] = std::minmax(room.num_cells, room.decided_cells);
    return 1.0 - static_cast<double>(smaller) / static_cast<double>(larger);
}

}  // namespace

bool note_way(FollowedMap& followed, const Point& at, const FollowOptions& options,
              Changes& changes) {
    const Cell cell = followed.map.cell_at(at);
    if (!followed.way.empty() && followed.way.back() == cell) return false;
    followed.way.push_back(cell);
    if (followed.rooms.empty() || !drops_uncrossed(options.segment)) return false;
    const Cell tile = tile_of(cell);
    const std::uint64_t cut_free = followed.cells.tile(tile).cut_free;
    const bool is_roomless = followed.cells.room(cell) == 0 &&
                             followed.map.state(cell) == CellState::free &&
                             (cut_free >> place_in_tile(cell) & 1) != 0;
    if (!is_roomless) return false;
    for_each_cell(cells_of_tiles({tile, tile}), [&](Cell free) {
        if (followed.cells.room(free) == 0) followed.cells.set_cut_free(free, false);
    });
    note_written(followed, {tile}, changes);
    return true;
}

bool is_cut_due(const FollowedMap& followed, const FollowOptions& options) {
    const std::size_t num_new =
        followed.num_changed - std::min(followed.num_left_over, followed.num_changed);
    const double changed_m2 = static_cast<double>(num_new) * followed.cell_m2();
    if (followed.rooms.empty()) return changed_m2 >= options.first_cut_m2;
    const auto waited = static_cast<double>(followed.num_scans - followed.cut_at);
    return changed_m2 >= options.min_change_m2 || changed_m2 * waited >= options.max_wait_m2_scans;
}

void cut_again(FollowedMap& followed, const FollowOptions& options, double min_patch_m2,
               const Executor& executor, FollowUpdate& update) {
    const auto start = std::chrono::steady_clock::now();
    followed.cut_at = followed.num_scans;
    if (options.segment.preset == Preset::paper) {
        cut_seen(followed, options.segment, executor, update);
    } else {
        cut_patches(followed, options, min_patch_m2, executor, update);
    }
    update.segment_ms = ms_since(start);
}

bool refine_stalest(FollowedMap& followed, const FollowOptions& options, double min_stale,
                    const Executor& executor, FollowUpdate& update) {
    std::uint32_t stalest = 0;
    for (const auto& [id, room] : followed.rooms) {
        const double stale = stale_share(room);
        if (room.is_locked || stale < min_stale) continue;
        min_stale = stale;
        stalest = id;
    }
    if (stalest == 0) return false;
    FollowedRoom& room = followed.rooms.at(stalest);
    const auto side = static_cast<std::int32_t>(kBlockM / followed.map.resolution_m());
    const std::int32_t columns = (room.box.width() + side - 1) / side;
    const std::int32_t rows = (room.box.height() + side - 1) / side;
    const auto num_blocks = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    const auto block = static_cast<std::int32_t>(room.next_block % num_blocks);
    const Cell low{room.box.low.x + block % columns * side,
                   room.box.low.y + block / columns * side};
    const Box part = Box{low, {low.x + side - 1, low.y + side - 1}}.intersected(room.box);
    const bool is_last = ++room.next_block >= num_blocks;
    cut_box(followed, part.grown(followed.in_cells(kNarrowingReachM)), options.segment, executor,
            update);
    const auto after = followed.rooms.find(stalest);
    if (is_last && after != followed.rooms.end()) {
        after->second.next_block = 0;
        after->second.decided_cells = after->second.num_cells;
    }
    return true;
}

void catch_up(FollowedMap& followed, const FollowOptions& options, std::uint32_t room,
              const Executor& executor, FollowUpdate& update) {
    std::set<std::pair<std::int32_t, std::int32_t>> tiles;
    // Cells that are not free, or free ones beside it that have no room, are changes since it was
    // cut.
    for_each_cell(followed.rooms.at(room).box.grown(1), [&](Cell cell) {
        const bool is_free = followed.map.state(cell) == CellState::free;
        const std::uint32_t own = followed.cells.room(cell);
        if (is_free ? own != 0 || !followed.cells.is_beside(cell, room) : own != room) return;
        // What is noted as a change already is cut in its time.
        const Cell tile = tile_of(cell);
        const std::uint64_t cut_free = followed.cells.tile(tile).cut_free;
        if (((cut_free >> place_in_tile(cell) & 1) != 0) != is_free) return;
        followed.cells.set_cut_free(cell, !is_free);
        tiles.emplace(tile.x, tile.y);
    });
    if (tiles.empty()) return;
    std::vector<Cell> written;
    for (const auto& [x, y] : tiles) written.push_back({x, y});
    note_written(followed, written, update.changes);
    cut_again(followed, options, 0.0, executor, update);
}

}  // namespace quadcut
