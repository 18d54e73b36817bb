// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// The tree that OccupancyMap's tiles and pyramid stand for: building it from a raster, reading it.
#include <algorithm>
#include <stdexcept>

#include "quadcut/map/occupancy_map.hpp"

namespace quadcut {
namespace {

Box box_of_known(const Raster<CellState>& states) {
    Box box;
    const auto known = [](CellState state) { return state != CellState::unknown; };
    for (std::int32_t y = 0; y < states.height; ++y) {
        const auto row = states.values.begin() + std::ptrdiff_t{y} * states.width;
        const auto first = std::find_if(row, row + states.width, known);
        if (first == row + states.width) continue;
        auto last = row + states.width - 1;
        while (!known(*last)) --last;
        box.include({states.cell(static_cast<std::size_t>(first - states.values.begin())),
                     states.cell(static_cast<std::size_t>(last - states.values.begin()))});
    }
    return box;
}

// Makes `known` hold the known cells of a tile.
void include_known(const Tile& values, Cell tile, Box& known) {
    const Box cells = cells_of_tiles({tile, tile});
    if (known.contains(cells.low) && known.contains(cells.high)) return;
    for_each_cell(cells, [&](Cell cell) {
        if (values.values[place_in_tile(cell)] != 0) known.include({cell, cell});
    });
}

// Writes the cells of a tile that lie in the raster.
void put_tile(const Tile& values, Cell tile, Raster<CellState>& states) {
    const Box cells = cells_of_tiles({tile, tile}).intersected(states.box());
    if (cells.is_empty()) return;
    for (std::int32_t y = cells.low.y; y <= cells.high.y; ++y) {
        const std::int8_t* row = &values.values[place_in_tile({cells.low.x, y})];
        std::transform(row, row + cells.width(), &states.at({cells.low.x, y}), state_of);
    }
}

// Blocks of up to this side are the same whatever part of a map the raster holds.
constexpr std::int32_t kLargestBlock = 1024;

// The smallest root for a raster, its lower left moved down to the next such block.
Root root_around(const Raster<CellState>& states) {
    const auto down = [](std::int32_t at) { return at - (at & (kLargestBlock - 1)); };
    const Cell corner{down(states.origin.x), down(states.origin.y)};
    const std::int64_t extent = std::max(std::int64_t{states.width} + states.origin.x - corner.x,
                                         std::int64_t{states.height} + states.origin.y - corner.y);
    int level = kTileBits;
    while (std::int64_t{1} << level < extent) ++level;
    return {corner, static_cast<std::uint8_t>(level)};
}

// The cells of a tile, unknown beyond the raster.
Tile tile_from(const Raster<CellState>& states, Cell tile) {
    Tile result;
    const Box cells = cells_of_tiles({tile, tile}).intersected(states.box());
    for (std::int32_t y = cells.low.y; y <= cells.high.y; ++y) {
        const CellState* row = &states.values[states.offset({cells.low.x, y})];
        std::transform(row, row + cells.width(), &result.values[place_in_tile({cells.low.x, y})],
                       log_odds_of);
    }
    return result;
}

}  // namespace

OccupancyMap OccupancyMap::from_grid(const GridMap& grid) {
    const Raster<CellState>& states = grid.states;
    if (states.values.empty()) return OccupancyMap(grid.resolution_m, grid.map_from_image);
    OccupancyMap map(grid.resolution_m, grid.map_from_image, root_around(states));
    const Box known = box_of_known(states);
    if (known.is_empty()) return map;
    map.reserve(known.low, known.high);
    const Box tiles = map.written_tiles();
    for (Cell tile = tiles.low; tile.y <= tiles.high.y; ++tile.y) {
        for (tile.x = tiles.low.x; tile.x <= tiles.high.x; ++tile.x) {
            const Tile values = tile_from(states, tile);
            map.store_.set_tile(tile, values);
            map.pyramid_.set_tile(map.tile_position(tile), states_of(values));
        }
    }
    map.store_.compact();
    map.pyramid_.rebuild();
    map.num_leaves_ = map.pyramid_.num_leaves_in(map.pyramid_.num_layers() - 1, {0, 0});
    return map;
}

Raster<CellState> OccupancyMap::to_raster() const {
    const Box tiles = written_tiles();
    Box known;
    for_each_cell(tiles, [&](Cell tile) {
        if (store_.shared_log_odds(tile) != 0) include_known(store_.tile(tile), tile, known);
    });
    Raster<CellState> states(known);
    // Most of the box may never have been seen.
    for_each_cell(tiles, [&](Cell tile) {
        if (store_.shared_log_odds(tile) != 0) put_tile(store_.tile(tile), tile, states);
    });
    return states;
}

GridMap OccupancyMap::to_grid() const {
    GridMap grid{resolution_m_, world_from_map_, to_raster()};
    const Point corner{grid.states.origin.x * resolution_m_, grid.states.origin.y * resolution_m_};
    grid.map_from_image = compose(world_from_map_, {corner.x, corner.y, 0.0});
    grid.states.origin = {0, 0};
    return grid;
}

void OccupancyMap::require_committed() const {
    if (!pending_.empty() || committed_root_ != root_) {
        throw std::logic_error("OccupancyMap: commit() comes before the tree is read");
    }
}

std::size_t OccupancyMap::num_leaves() const {
    require_committed();
    return num_leaves_;
}

std::size_t OccupancyMap::num_nodes_in(const Root& block) const {
    require_committed();
    const Cell position = root_.position(block.level, block.lower_left);
    return (4 * pyramid_.num_leaves_in(block.level - kTileBits, position) - 1) / 3;
}

Root OccupancyMap::block_around(Cell low, Cell high) const {
    int level = kTileBits;
    while (root_.position(level, low) != root_.position(level, high)) ++level;
    return root_.block(level, root_.position(level, low));
}

std::vector<Leaf> OccupancyMap::leaves() const {
    require_committed();
    std::vector<Leaf> leaves;
    leaves.reserve(num_leaves_);
    pyramid_.for_each_block(pyramid_.num_layers() - 1, {0, 0}, [&](int layer, Cell position) {
        const Root block = root_.block(layer + kTileBits, position);
        const BlockState state = pyramid_.at(layer, position);
        if (is_uniform(state)) {
            leaves.push_back({block.lower_left, block.level, cell_state(state)});
        } else {
            const TileStates states = states_of(store_.tile(tile_of(block.lower_left)));
            append_leaves(leaves_of(states), states, block.lower_left, leaves);
        }
    });
    return leaves;
}

}  // namespace quadcut
