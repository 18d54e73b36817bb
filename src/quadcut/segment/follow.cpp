// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/follow.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

/// Changes within about this of each other are cut together.
constexpr double kPatchM = 4.0;
/// Of the labels' raster: 820 m a side at 5 cm, five bytes each.
constexpr double kMaxCells = 268435456.0;
/// The labels' raster grows by at least this at a time, cells.
constexpr std::int32_t kSlackCells = 256;

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

template <typename T>
void enlarge(Raster<T>& raster, const Box& box) {
    Raster<T> larger(box);
    for (std::int32_t y = 0; y < raster.height; ++y) {
        const auto from = raster.values.begin() + static_cast<std::ptrdiff_t>(y) *
                                                      static_cast<std::ptrdiff_t>(raster.width);
        const Cell to{raster.origin.x, raster.origin.y + y};
        std::copy(from, from + raster.width,
                  larger.values.begin() + static_cast<std::ptrdiff_t>(larger.offset(to)));
    }
    raster = std::move(larger);
}

/// Patches of changes: the tiles of each, by nearness.
std::vector<std::pair<Box, std::size_t>> patches(
    const std::map<std::pair<std::int32_t, std::int32_t>, std::size_t>& tiles,
    double resolution_m) {
    const auto block_tiles =
        static_cast<std::int32_t>(std::max(1.0, std::ceil(kPatchM / (resolution_m * kTileSide))));
    const auto block_of = [&](std::int32_t tile) {
        return static_cast<std::int32_t>(std::floor(static_cast<double>(tile) / block_tiles));
    };
    std::map<std::pair<std::int32_t, std::int32_t>, std::pair<Box, std::size_t>> blocks;
    for (const auto& [at, count] : tiles) {
        const Cell low = first_cell_of({at.first, at.second});
        auto& [box, sum] = blocks[{block_of(at.first), block_of(at.second)}];
        box.include({low, {low.x + kTileSide - 1, low.y + kTileSide - 1}});
        sum += count;
    }
    std::vector<std::pair<Box, std::size_t>> result;
    while (!blocks.empty()) {
        std::vector<std::pair<std::int32_t, std::int32_t>> waiting{blocks.begin()->first};
        std::pair<Box, std::size_t> patch{{}, 0};
        while (!waiting.empty()) {
            const auto at = waiting.back();
            waiting.pop_back();
            const auto found = blocks.find(at);
            if (found == blocks.end()) continue;
            patch.first.include(found->second.first);
            patch.second += found->second.second;
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

Follower::Follower(const FollowOptions& options) : options_(options), map_(options.resolution_m) {}

FollowUpdate Follower::add_scan(const Scan& scan) {
    FollowUpdate update;
    const auto start = std::chrono::steady_clock::now();
    const Cell at = map_.cell_at({scan.world_from_sensor.x, scan.world_from_sensor.y});
    const double reach = std::min(options_.integrate.usable_range_m / options_.resolution_m, 1e4);
    const auto cells = static_cast<std::int32_t>(std::ceil(reach));
    require_room_for({{at.x - cells, at.y - cells}, {at.x + cells, at.y + cells}});
    const MapUpdate change = integrate_scan(map_, scan, options_.integrate);
    update.integrate_ms = ms_since(start);
    update.scan = num_scans_++;
    update.nodes_touched = change.nodes_touched;
    update.nodes_rebuilt = change.nodes_rebuilt;
    if (change.covering) {
        update.ps = static_cast<double>(map_.num_nodes_in(*change.covering)) /
                    static_cast<double>(map_.num_nodes());
    }
    note_changes(change);
    const double changed_m2 =
        static_cast<double>(num_changed_) * options_.resolution_m * options_.resolution_m;
    if (changed_m2 >= (rooms_.empty() ? options_.first_cut_m2 : options_.min_change_m2)) {
        cut_again(options_.min_patch_m2, update);
    }
    update.num_leaves = map_.num_leaves();
    update.num_rooms = rooms_.size();
    return update;
}

FollowUpdate Follower::update_cells(const Raster<CellState>& patch) {
    FollowUpdate update;
    const auto start = std::chrono::steady_clock::now();
    if (!patch.values.empty()) require_room_for(patch.box());
    if (!patch.values.empty()) map_.reserve(patch.box().low, patch.box().high);
    for (std::size_t i = 0; i < patch.values.size(); ++i) {
        map_.set_state(patch.cell(i), patch.values[i]);
    }
    const MapUpdate change = map_.commit();
    update.integrate_ms = ms_since(start);
    update.scan = num_scans_;
    update.nodes_touched = change.nodes_touched;
    update.nodes_rebuilt = change.nodes_rebuilt;
    note_changes(change);
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

bool Follower::refine() {
    if (rooms_.empty()) return false;
    const auto oldest = std::min_element(
        rooms_.begin(), rooms_.end(),
        [](const auto& p, const auto& q) { return p.second.refined_at < q.second.refined_at; });
    oldest->second.refined_at = ++num_cuts_;
    FollowUpdate update;
    cut_window(oldest->second.box, update);
    return true;
}

/// Compares what is free now with what was when rooms were last cut there.
void Follower::note_changes(const MapUpdate& update) {
    if (update.rebuilt.empty()) return;
    Box all;
    std::set<std::pair<std::int32_t, std::int32_t>> tiles;
    for (const Leaf& leaf : update.rebuilt) {
        if (leaf.state == CellState::unknown && leaf.level > kTileBits) continue;
        const Cell low = tile_of(leaf.box().low);
        const Cell high = tile_of(leaf.box().high);
        for (std::int32_t y = low.y; y <= high.y; ++y) {
            for (std::int32_t x = low.x; x <= high.x; ++x) tiles.emplace(x, y);
        }
        all.include(leaf.box());
    }
    if (tiles.empty()) return;
    make_room_for(all);
    for (const auto& [x, y] : tiles) {
        const Tile& tile = map_.tile({x, y});
        const Cell low = first_cell_of({x, y});
        std::size_t count = 0;
        for (std::int32_t dy = 0; dy < kTileSide; ++dy) {
            const std::size_t row = cut_free_.offset({low.x, low.y + dy});
            for (std::int32_t dx = 0; dx < kTileSide; ++dx) {
                const bool is_free = tile.values[static_cast<std::size_t>(8 * dy + dx)] < 0;
                const bool was_free = cut_free_.values[row + static_cast<std::size_t>(dx)] != 0;
                if (is_free != was_free) ++count;
            }
        }
        const auto found = changed_tiles_.find({x, y});
        if (found != changed_tiles_.end()) {
            num_changed_ -= found->second;
            changed_tiles_.erase(found);
        }
        if (count == 0) continue;
        changed_tiles_[{x, y}] = count;
        num_changed_ += count;
    }
}

void Follower::require_room_for(Box cells) const {
    if (!labels_.values.empty()) cells.include(labels_.box());
    const double num_cells = static_cast<double>(cells.width()) * cells.height();
    if (num_cells <= kMaxCells) return;
    throw InputError("the followed map would span " + std::to_string(cells.width()) + " x " +
                     std::to_string(cells.height()) + " cells: expected at most " +
                     std::to_string(static_cast<long>(kMaxCells)) + "; is a pose wrong?");
}

void Follower::make_room_for(const Box& cells) {
    // Whole tiles, so that one look is enough for each.
    const Cell low = first_cell_of(tile_of(cells.low));
    const Cell high = first_cell_of(tile_of(cells.high));
    const Box tiles{low, {high.x + kTileSide - 1, high.y + kTileSide - 1}};
    const Box before = labels_.box();
    if (!labels_.values.empty() && before.contains(tiles.low) && before.contains(tiles.high)) {
        return;
    }
    Box box = labels_.values.empty() ? tiles : before;
    box.include(tiles);
    if (box.low.x < before.low.x || before.is_empty()) box.low.x -= kSlackCells;
    if (box.low.y < before.low.y || before.is_empty()) box.low.y -= kSlackCells;
    if (box.high.x > before.high.x || before.is_empty()) box.high.x += kSlackCells;
    if (box.high.y > before.high.y || before.is_empty()) box.high.y += kSlackCells;
    enlarge(labels_, box);
    enlarge(cut_free_, box);
}

void Follower::cut_again(double min_patch_m2, FollowUpdate& update) {
    const auto start = std::chrono::steady_clock::now();
    const double cell_m2 = options_.resolution_m * options_.resolution_m;
    for (const auto& [box, count] : patches(changed_tiles_, options_.resolution_m)) {
        if (static_cast<double>(count) * cell_m2 >= min_patch_m2) cut_window(box, update);
    }
    update.segment_ms = ms_since(start);
}

}  // namespace quadcut
