// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/follower.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

/// Changes within about this of each other are cut together.
constexpr double kPatchM = 4.0;
/// A room is refined when so much of it has come or gone since it was decided as a whole: while
/// there is nothing else to do, and once after each cut.
constexpr double kMinStale = 0.02;
constexpr double kMuchStale = 0.1;
double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// Patches of changes: the tiles of each, by nearness.
std::vector<Box> patches(const std::map<std::pair<std::int32_t, std::int32_t>, std::size_t>& tiles,
                         double resolution_m) {
    const auto block_tiles =
        static_cast<std::int32_t>(std::max(1.0, std::ceil(kPatchM / (resolution_m * kTileSide))));
    const auto block_of = [&](std::int32_t tile) {
        return static_cast<std::int32_t>(std::floor(static_cast<double>(tile) / block_tiles));
    };
    std::map<std::pair<std::int32_t, std::int32_t>, Box> blocks;
    for (const auto& [at, count] : tiles) {
        const Cell low = first_cell_of({at.first, at.second});
        blocks[{block_of(at.first), block_of(at.second)}].include(
            {low, {low.x + kTileSide - 1, low.y + kTileSide - 1}});
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

}  // namespace

std::uint64_t free_rows(const Tile& tile) { return rows_below_zero(tile); }

Follower::Follower(const FollowOptions& options, const RunOptions& run)
    : options_(with_preset(options)), executor_(run.executor()), map_(options.resolution_m) {}

FollowUpdate Follower::add_scan(const Scan& scan) {
    FollowUpdate update;
    const auto start = std::chrono::steady_clock::now();
    require_room_for(cells_in_reach(map_, scan, options_.integrate));
    const MapUpdate change = integrate_scan(map_, scan, options_.integrate);
    update.integrate_ms = ms_since(start);
    sum_up(change, update);
    ++num_scans_;
    note_changes(change);
    if (!change.written.empty()) note_seen(change.observed);
    if (is_cut_due()) cut_again(options_.min_patch_m2, update);
    update.num_leaves = map_.num_leaves();
    update.num_rooms = rooms_.size();
    return update;
}

void Follower::sum_up(const MapUpdate& change, FollowUpdate& update) const {
    update.scan = num_scans_;
    update.nodes_touched = change.nodes_touched;
    update.nodes_rebuilt = change.nodes_rebuilt;
    if (!change.covering) return;
    update.ps = static_cast<double>(map_.num_nodes_in(*change.covering)) /
                static_cast<double>(map_.num_nodes());
}

std::uint32_t Follower::new_id() {
    if (next_id_ > kMaxRoomId) {
        throw InputError("the map has had " + std::to_string(next_id_ - 1) +
                         " rooms: expected at most 65535, the range of a label");
    }
    return next_id_++;
}

bool Follower::is_cut_due() const {
    const std::size_t num_new = num_changed_ - std::min(num_left_over_, num_changed_);
    const double changed_m2 =
        static_cast<double>(num_new) * options_.resolution_m * options_.resolution_m;
    if (rooms_.empty()) return changed_m2 >= options_.first_cut_m2;
    const auto waited = static_cast<double>(num_scans_ - cut_at_);
    return changed_m2 >= options_.min_change_m2 ||
           changed_m2 * waited >= options_.max_wait_m2_scans;
}

FollowUpdate Follower::update_cells(const Raster<CellState>& patch) {
    FollowUpdate update;
    const auto start = std::chrono::steady_clock::now();
    if (!patch.values.empty()) {
        require_room_for(patch.box());
        map_.reserve(patch.box().low, patch.box().high);
    }
    for (std::size_t i = 0; i < patch.values.size(); ++i) {
        map_.set_state(patch.cell(i), patch.values[i]);
    }
    const MapUpdate change = map_.commit();
    update.integrate_ms = ms_since(start);
    sum_up(change, update);
    note_changes(change);
    note_seen(change.written);
    cut_again(options_.min_patch_m2, update);
    update.num_leaves = map_.num_leaves();
    update.num_rooms = rooms_.size();
    return update;
}

FollowUpdate Follower::finish() {
    FollowUpdate update;
    update.scan = num_scans_;
    cut_again(0.0, update);
    update.num_leaves = map_.num_leaves();
    update.num_rooms = rooms_.size();
    return update;
}

std::optional<FollowUpdate> Follower::refine() {
    FollowUpdate update;
    if (!refine_stalest(kMinStale, update)) return std::nullopt;
    update.scan = num_scans_;
    update.num_leaves = map_.num_leaves();
    update.num_rooms = rooms_.size();
    return update;
}

/// Compares what is free now with what was when rooms were last cut there.
void Follower::note_changes(const MapUpdate& update) {
    if (update.written.empty()) return;
    for (const Cell tile : update.written) {
        cells_.mark(tile);
        written_.include(cells_of_tiles({tile, tile}));
        const std::uint64_t free = free_rows(map_.tile(tile));
        cells_.note_free(tile, std::popcount(free));
        const std::uint64_t changed = free ^ cells_.tile(tile).cut_free;
        const auto count = static_cast<std::size_t>(std::popcount(changed));
        const auto found = changed_tiles_.find({tile.x, tile.y});
        if (found != changed_tiles_.end()) {
            num_changed_ -= found->second;
            changed_tiles_.erase(found);
        }
        if (count == 0) continue;
        changed_tiles_[{tile.x, tile.y}] = count;
        num_changed_ += count;
    }
}

void Follower::require_room_for(Box cells) const {
    if (cells.is_empty()) return;
    cells = cells_of_tiles({tile_of(cells.low), tile_of(cells.high)});
    if (!written_.is_empty()) cells.include(written_);
    if (std::int64_t{cells.width()} * cells.height() <= kMaxCellsOfScans) return;
    throw InputError("the followed map would span " + std::to_string(cells.width()) + " x " +
                     std::to_string(cells.height()) + " cells: expected at most " +
                     std::to_string(kMaxCellsOfScans) + "; is a pose wrong?");
}

void Follower::cut_again(double min_patch_m2, FollowUpdate& update) {
    const auto start = std::chrono::steady_clock::now();
    cut_at_ = num_scans_;
    const double cell_m2 = options_.resolution_m * options_.resolution_m;
    if (options_.segment.preset == Preset::paper) {
        if (num_changed_ > 0) cut_seen_submaps(update);
        update.segment_ms = ms_since(start);
        return;
    }
    bool is_cut = false;
    for (const Box& box : patches(changed_tiles_, options_.resolution_m)) {
        // A window before may have decided it already.
        const std::size_t count = num_changed_in(box);
        if (count == 0 || static_cast<double>(count) * cell_m2 < min_patch_m2) continue;
        cut_window(cells_to_decide(box), update);
        is_cut = true;
    }
    if (is_cut) refine_stalest(kMuchStale, update);
    num_left_over_ = num_changed_;
    update.segment_ms = ms_since(start);
}

std::size_t Follower::num_changed_in(const Box& box) const {
    std::size_t count = 0;
    const Cell low = tile_of(box.low);
    const Cell high = tile_of(box.high);
    for (auto at = changed_tiles_.lower_bound({low.x, low.y});
         at != changed_tiles_.end() && at->first.first <= high.x; ++at) {
        if (at->first.second >= low.y && at->first.second <= high.y) count += at->second;
    }
    return count;
}

std::int32_t Follower::in_cells(double length_m) const {
    return static_cast<std::int32_t>(std::ceil(length_m / options_.resolution_m));
}

RoomId Follower::room_at(const Point& point) const {
    const double x = point.x / options_.resolution_m;
    const double y = point.y / options_.resolution_m;
    // Beyond it no cell has an address. Written so that NaN is nowhere, too.
    constexpr double kFar = 268435456.0;
    if (!(std::abs(x) < kFar && std::abs(y) < kFar)) return RoomId{};
    return RoomId{cells_.room(map_.cell_at(point))};
}

std::size_t Follower::bytes() const {
    return map_.bytes() + cells_.bytes() + openings_.capacity() * sizeof(LocalOpening);
}

}  // namespace quadcut
