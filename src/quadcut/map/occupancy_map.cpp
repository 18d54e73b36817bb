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

Cell tile_of(Cell cell) { return {cell.x >> kTileBits, cell.y >> kTileBits}; }

// An empty rectangle of tiles is low = (0, 0), high = (-1, -1).
struct TileRange {
    Cell low{0, 0};
    Cell high{-1, -1};

    [[nodiscard]] std::int64_t size() const {
        return (std::int64_t{high.x} - low.x + 1) * (std::int64_t{high.y} - low.y + 1);
    }
};

TileRange range_of(const Raster<std::uint32_t>& directory) {
    return {directory.origin,
            {directory.origin.x + directory.width - 1, directory.origin.y + directory.height - 1}};
}

// Doubles one side of a root of `side` tiles: where to, that low .. high come to lie inside.
bool grows_down(std::int32_t root_low, std::int32_t side, std::int32_t low, std::int32_t high) {
    if (low < root_low) return true;
    return high < root_low + side && low - root_low + high - root_low < side;
}

Root grown_root(Root root, const TileRange& tiles) {
    while (true) {
        const Cell first = tile_of(root.lower_left);
        const std::int32_t side = root.side_cells() >> kTileBits;
        if (tiles.low.x >= first.x && tiles.low.y >= first.y && tiles.high.x < first.x + side &&
            tiles.high.y < first.y + side) {
            return root;
        }
        if (root.level == kMaxLevel) throw InputError("map: the extent passes 2^30 cells");
        if (grows_down(first.x, side, tiles.low.x, tiles.high.x)) {
            root.lower_left.x -= root.side_cells();
        }
        if (grows_down(first.y, side, tiles.low.y, tiles.high.y)) {
            root.lower_left.y -= root.side_cells();
        }
        ++root.level;
    }
}

// The old rectangle with the new tiles. A side that is passed moves by an eighth of the extent at
// least, inside the root, so that a robot that walks away does not copy the directory at each step.
TileRange grown_range(const TileRange& old, const TileRange& tiles, const Root& root) {
    if (old.size() == 0) return tiles;
    const Cell first = tile_of(root.lower_left);
    const std::int32_t side = root.side_cells() >> kTileBits;
    const auto spare = [](std::int32_t low, std::int32_t high) {
        return std::max(8, (high - low + 1) / 8);
    };
    const auto down = [&](std::int32_t low, std::int32_t high, std::int32_t wanted,
                          std::int32_t limit) {
        return wanted >= low ? low : std::max(limit, std::min(wanted, low - spare(low, high)));
    };
    const auto up = [&](std::int32_t low, std::int32_t high, std::int32_t wanted,
                        std::int32_t limit) {
        return wanted <= high ? high : std::min(limit, std::max(wanted, high + spare(low, high)));
    };
    return {{down(old.low.x, old.high.x, tiles.low.x, first.x),
             down(old.low.y, old.high.y, tiles.low.y, first.y)},
            {up(old.low.x, old.high.x, tiles.high.x, first.x + side - 1),
             up(old.low.y, old.high.y, tiles.high.y, first.y + side - 1)}};
}

StatePyramid empty_pyramid(const Root& root, const TileRange& tiles) {
    const Cell first = tile_of(root.lower_left);
    return {root.level - kTileBits + 1,
            {tiles.low.x - first.x, tiles.low.y - first.y},
            {tiles.high.x - first.x, tiles.high.y - first.y}};
}

}  // namespace

OccupancyMap::OccupancyMap(double resolution_m, const Pose& world_from_map)
    : resolution_m_(resolution_m),
      world_from_map_(world_from_map),
      map_from_world_(inverse(world_from_map)),
      pyramid_(1, {0, 0}, {-1, -1}) {
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
    pyramid_ = empty_pyramid(root, {});
}

std::pair<Cell, Cell> OccupancyMap::written_tiles() const {
    const TileRange range = range_of(store_.directory());
    return {range.low, range.high};
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

Point OccupancyMap::center_of(Cell cell) const {
    return transform(world_from_map_,
                     {(cell.x + 0.5) * resolution_m_, (cell.y + 0.5) * resolution_m_});
}

std::size_t OccupancyMap::bytes() const {
    return sizeof(*this) + store_.bytes() + pyramid_.bytes() +
           pending_.capacity() * sizeof(Pending);
}

void OccupancyMap::reserve(Cell low, Cell high) {
    if (low.x <= -kMaxCoordinate || low.y <= -kMaxCoordinate || high.x >= kMaxCoordinate ||
        high.y >= kMaxCoordinate) {
        throw InputError("map: a cell lies more than 2^28 cells away");
    }
    if (!store_.contains(tile_of(low)) || !store_.contains(tile_of(high))) {
        grow(tile_of(low), tile_of(high));
    }
}

void OccupancyMap::grow(Cell low_tile, Cell high_tile) {
    const TileRange old = range_of(store_.directory());
    TileRange wanted{low_tile, high_tile};
    if (old.size() > 0) {
        wanted = {{std::min(low_tile.x, old.low.x), std::min(low_tile.y, old.low.y)},
                  {std::max(high_tile.x, old.high.x), std::max(high_tile.y, old.high.y)}};
    }
    if (wanted.size() > kMaxTiles) throw InputError("map: the extent passes 2^31 cells");
    Root from = root_;
    if (!is_placed_) {
        from = {{low_tile.x * kTileSide, low_tile.y * kTileSide}, kTileBits};
    }
    const Root root = grown_root(from, wanted);
    const TileRange with_spare = grown_range(old, wanted, root);
    const TileRange& range = with_spare.size() > kMaxTiles ? wanted : with_spare;

    StatePyramid pyramid = empty_pyramid(root, range);
    if (old.size() > 0) {
        pyramid.take_tiles(pyramid_, {(root_.lower_left.x - root.lower_left.x) >> kTileBits,
                                      (root_.lower_left.y - root.lower_left.y) >> kTileBits});
        pyramid.rebuild();
    }
    store_.set_rectangle(range.low, range.high);
    pyramid_ = std::move(pyramid);
    if (!is_placed_) {
        committed_root_ = from;
        is_placed_ = true;
    }
    root_ = root;
}

void OccupancyMap::set_state(Cell cell, CellState state) {
    write(cell, state == CellState::unknown ? 0
                : state == CellState::free  ? kMinLogOdds
                                            : kMaxLogOdds);
}

void OccupancyMap::add_log_odds(Cell cell, int delta) {
    write(cell, bounded_sum(log_odds(cell), delta));
}

void OccupancyMap::write(Cell cell, int log_odds) {
    // What does not change is not touched: a saturated block stays collapsed.
    if (store_.log_odds(cell) == log_odds) return;
    reserve(cell, cell);
    const Cell tile = tile_of(cell);
    remember(tile);
    store_.writable_tile(tile).values[TileStore::cell_in_tile(cell)] =
        static_cast<std::int8_t>(log_odds);
}

void OccupancyMap::set_tile(Cell tile, const Tile& values) {
    if (store_.tile(tile).values == values.values) return;
    const Cell corner{tile.x * kTileSide, tile.y * kTileSide};
    reserve(corner, corner);
    remember(tile);
    store_.set_tile(tile, values);
}

void OccupancyMap::remember(Cell tile) {
    const Cell position = tile_position(tile);
    if (!pyramid_.is_marked(position)) {
        pending_.push_back({tile, states_of(store_.tile(tile))});
        pyramid_.mark(position);
    }
}

MapUpdate OccupancyMap::commit() {
    MapUpdate update;
    if (pending_.empty() && committed_root_ == root_) return update;
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    order.reserve(pending_.size());
    for (const Pending& pending : pending_) {
        order.emplace_back(morton_code(tile_position(pending.tile)), order.size());
    }
    std::sort(order.begin(), order.end());

    TreeChange change(pyramid_, committed_root_, root_);
    std::vector<std::uint64_t> codes;
    codes.reserve(order.size());
    for (const auto& [code, i] : order) {
        const Pending& pending = pending_[i];
        store_.collapse(pending.tile);
        change.add_tile(code, pending.before, states_of(store_.tile(pending.tile)));
        codes.push_back(code);
    }
    change.finish();
    store_.give_back();
    pending_ = std::vector<Pending>{};
    committed_root_ = root_;
    num_leaves_ += change.leaves_added().size();
    num_leaves_ -= change.num_leaves_removed();
    update.nodes_rebuilt = change.leaves_added().size() + change.num_inner_nodes_added();
    update.rebuilt = std::move(change.leaves_added());
    update.nodes_touched = count_nodes_above(std::move(codes));
    if (!order.empty()) update.covering = block_of(order.front().first, order.back().first);
    return update;
}

}  // namespace quadcut
