// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/occupancy_map.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "quadcut/base/error.hpp"
#include "quadcut/map/morton.hpp"
#include "quadcut/map/tree_change.hpp"

namespace quadcut {
namespace {

constexpr std::int32_t kMaxCoordinate = std::int32_t{1} << 28;
constexpr std::int64_t kMaxTiles = std::int64_t{1} << 25;
constexpr std::uint8_t kMaxLevel = 30;

std::int64_t num_tiles(const Box& tiles) { return std::int64_t{tiles.width()} * tiles.height(); }

Box tiles_of(const Root& root) {
    const std::int32_t reach = (root.side_cells() >> kTileBits) - 1;
    const Cell low = tile_of(root.lower_left);
    return {low, {low.x + reach, low.y + reach}};
}

// Doubles the root towards the side where the tiles lie until it holds them.
Root grown_root(Root root, const Box& tiles) {
    for (;; ++root.level) {
        const Box inside = tiles_of(root);
        if (inside.contains(tiles.low) && inside.contains(tiles.high)) return root;
        if (root.level == kMaxLevel) throw InputError("map: the extent passes 2^30 cells");
        const std::int32_t side = root.side_cells();
        if (tiles.low.x + tiles.high.x <= inside.low.x + inside.high.x) root.lower_left.x -= side;
        if (tiles.low.y + tiles.high.y <= inside.low.y + inside.high.y) root.lower_left.y -= side;
    }
}

// A side of `old` that `tiles` pass moves by an eighth of the extent at least, within `limit`, so
// that a robot that walks away does not copy the directory at each step.
Box with_spare(Box tiles, const Box& old, const Box& limit) {
    if (old.is_empty()) return tiles;
    const Cell spare{std::max(8, old.width() / 8), std::max(8, old.height() / 8)};
    const Cell low{std::max(limit.low.x, old.low.x - spare.x),
                   std::max(limit.low.y, old.low.y - spare.y)};
    const Cell high{std::min(limit.high.x, old.high.x + spare.x),
                    std::min(limit.high.y, old.high.y + spare.y)};
    if (tiles.low.x < old.low.x) tiles.low.x = std::min(tiles.low.x, low.x);
    if (tiles.low.y < old.low.y) tiles.low.y = std::min(tiles.low.y, low.y);
    if (tiles.high.x > old.high.x) tiles.high.x = std::max(tiles.high.x, high.x);
    if (tiles.high.y > old.high.y) tiles.high.y = std::max(tiles.high.y, high.y);
    return tiles;
}

}  // namespace

OccupancyMap::OccupancyMap(double resolution_m, const Pose& world_from_map)
    : resolution_m_(resolution_m),
      world_from_map_(world_from_map),
      map_from_world_(inverse(world_from_map)),
      pyramid_(root_, {}) {
    if (!(resolution_m > 0.0) || !std::isfinite(resolution_m)) {
        throw InputError("map: the resolution must be a positive number of metres a cell");
    }
    if (!std::isfinite(world_from_map.x) || !std::isfinite(world_from_map.y) ||
        !std::isfinite(world_from_map.yaw_rad)) {
        throw InputError("map: the pose of the map is not finite");
    }
}

OccupancyMap::OccupancyMap(double resolution_m, const Pose& world_from_map, const Root& root)
    : OccupancyMap(resolution_m, world_from_map) {
    const auto is_near = [&](std::int32_t low) {
        return low % kTileSide == 0 && low >= -4 * kMaxCoordinate && low / 4 < kMaxCoordinate;
    };
    if (root.level < kTileBits || root.level > kMaxLevel || !is_near(root.lower_left.x) ||
        !is_near(root.lower_left.y)) {
        throw InputError("map: the root is no block of 8 to 2^30 cells within 2^30");
    }
    root_ = root;
    committed_root_ = root;
    is_placed_ = true;
    pyramid_ = StatePyramid(root, {});
}

Cell OccupancyMap::cell_at(const Point& world) const {
    const Point point = transform(map_from_world_, world);
    const double x = std::floor(point.x / resolution_m_);
    const double y = std::floor(point.y / resolution_m_);
    // Written so that NaN fails too.
    if (!(std::abs(x) < kMaxCoordinate && std::abs(y) < kMaxCoordinate)) {
        throw InputError("map: the point (" + std::to_string(world.x) + ", " +
                         std::to_string(world.y) + ") m lies more than 2^28 cells away");
    }
    return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
}

std::size_t OccupancyMap::bytes() const {
    return sizeof(*this) + store_.bytes() + pyramid_.bytes() +
           pending_.capacity() * sizeof(Pending);
}

void OccupancyMap::reserve(Cell low, Cell high) {
    const Box tiles{tile_of(low), tile_of(high)};
    if (!store_.contains(tiles.low) || !store_.contains(tiles.high)) grow(tiles);
}

void OccupancyMap::grow(const Box& tiles) {
    constexpr std::int32_t kFar = kMaxCoordinate >> kTileBits;
    if (tiles.low.x < -kFar || tiles.low.y < -kFar || tiles.high.x >= kFar ||
        tiles.high.y >= kFar) {
        throw InputError("map: a cell lies more than 2^28 cells away");
    }
    const Box old = written_tiles();
    Box wanted = old;
    wanted.include(tiles);
    if (num_tiles(wanted) > kMaxTiles) throw InputError("map: the extent passes 2^31 cells");
    const Root from = is_placed_ ? root_ : Root{first_cell_of(tiles.low), kTileBits};
    // By the new tiles alone: where the directory has spare room is history, not content.
    const Root root = grown_root(from, tiles);
    Box range = with_spare(wanted, old, tiles_of(root));
    if (num_tiles(range) > kMaxTiles) range = wanted;

    StatePyramid pyramid(root, range);
    pyramid.take_tiles(pyramid_, root.position(kTileBits, root_.lower_left));
    pyramid.rebuild();
    store_.set_rectangle(range);
    pyramid_ = std::move(pyramid);
    if (!is_placed_) committed_root_ = from;
    is_placed_ = true;
    root_ = root;
}

void OccupancyMap::set_state(Cell cell, CellState state) {
    Tile values = tile(tile_of(cell));
    values.values[place_in_tile(cell)] = log_odds_of(state);
    set_tile(tile_of(cell), values);
}

void OccupancyMap::set_tile(Cell tile, const Tile& values) {
    // What does not change is not touched.
    if (store_.tile(tile).values == values.values) return;
    reserve(first_cell_of(tile), first_cell_of(tile));
    const Cell position = tile_position(tile);
    if (!pyramid_.is_marked(position)) {
        pending_.push_back({tile, states_of(store_.tile(tile))});
        pyramid_.mark(position);
    }
    store_.set_tile(tile, values);
}

MapUpdate OccupancyMap::commit() {
    MapUpdate update;
    if (pending_.empty() && committed_root_ == root_) return update;
    std::vector<WrittenTile> tiles;
    tiles.reserve(pending_.size());
    for (const Pending& pending : pending_) {
        const Cell position = tile_position(pending.tile);
        tiles.push_back({position, morton_code(position), pending.before,
                         states_of(store_.tile(pending.tile))});
    }
    std::sort(tiles.begin(), tiles.end(),
              [](const WrittenTile& a, const WrittenTile& b) { return a.code < b.code; });
    update.written.reserve(tiles.size());
    for (const WrittenTile& tile : tiles) {
        update.written.push_back(tile_of(root_.block(kTileBits, tile.position).lower_left));
    }
    const TreeChange change = update_tree(pyramid_, committed_root_, root_, tiles);
    store_.give_back();
    pending_ = std::vector<Pending>{};
    committed_root_ = root_;
    num_leaves_ += change.num_leaves_added;
    num_leaves_ -= change.num_leaves_removed;
    update.nodes_rebuilt = change.num_leaves_added + change.num_inner_nodes_added;
    update.nodes_touched = change.num_nodes_touched;
    if (!tiles.empty()) {
        const auto corner = [&](const WrittenTile& tile) {
            return root_.block(kTileBits, tile.position).lower_left;
        };
        update.covering = block_around(corner(tiles.front()), corner(tiles.back()));
    }
    return update;
}

}  // namespace quadcut
