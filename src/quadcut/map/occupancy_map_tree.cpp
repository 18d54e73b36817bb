// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// The tree that OccupancyMap's tiles and pyramid stand for: building it from a raster, reading it.
#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>
#include <utility>

#include "quadcut/base/error.hpp"
#include "quadcut/map/morton.hpp"
#include "quadcut/map/occupancy_map.hpp"

namespace quadcut {
namespace {

Cell child_of(Cell position, int quadrant) {
    return {position.x * 2 + (quadrant & 1), position.y * 2 + (quadrant >> 1)};
}

// Lowest and highest coordinates of the known cells; low.x > high.x when there are none.
std::pair<Cell, Cell> bounds_of_known(const Raster<CellState>& states) {
    Cell low{states.width, states.height};
    Cell high{-1, -1};
    const auto known = [](CellState state) { return state != CellState::unknown; };
    for (std::int32_t y = 0; y < states.height; ++y) {
        const auto row = states.values.begin() + std::ptrdiff_t{y} * states.width;
        const auto first = std::find_if(row, row + states.width, known);
        if (first == row + states.width) continue;
        auto last = row + states.width - 1;
        while (!known(*last)) --last;
        low = {std::min(low.x, static_cast<std::int32_t>(first - row)), std::min(low.y, y)};
        high = {std::max(high.x, static_cast<std::int32_t>(last - row)), y};
    }
    return {{low.x + states.origin.x, low.y + states.origin.y},
            {high.x + states.origin.x, high.y + states.origin.y}};
}

// The smallest root for a raster, its lower left moved down to the next tile.
Root root_around(const Raster<CellState>& states) {
    const Cell corner{states.origin.x & ~(kTileSide - 1), states.origin.y & ~(kTileSide - 1)};
    const std::int64_t extent = std::max(std::int64_t{states.width} + states.origin.x - corner.x,
                                         std::int64_t{states.height} + states.origin.y - corner.y);
    int level = kTileBits;
    while (std::int64_t{1} << level < extent) ++level;
    return {corner, static_cast<std::uint8_t>(level)};
}

// Bit 8 y + x for every cell (x, y) that is known.
std::uint64_t known_cells(const Tile& tile) {
    std::uint64_t rows = 0;
    for (std::size_t i = 0; i < kTileCells; ++i) {
        rows |= std::uint64_t{tile.values[i] != 0} << i;
    }
    return rows;
}

// The cells of a tile, unknown beyond the raster.
Tile tile_from(const Raster<CellState>& states, Cell tile) {
    Tile result;
    const Cell corner{tile.x * kTileSide, tile.y * kTileSide};
    const std::int32_t first = std::max(corner.x, states.origin.x);
    const std::int32_t end = std::min(corner.x + kTileSide, states.origin.x + states.width);
    for (std::int32_t y = std::max(corner.y, states.origin.y);
         y < std::min(corner.y + kTileSide, states.origin.y + states.height); ++y) {
        for (std::int32_t x = first; x < end; ++x) {
            const CellState state = states.at({x, y});
            result.values[static_cast<std::size_t>((y - corner.y) * kTileSide + x - corner.x)] =
                state == CellState::unknown ? std::int8_t{0}
                : state == CellState::free  ? std::int8_t{kMinLogOdds}
                                            : std::int8_t{kMaxLogOdds};
        }
    }
    return result;
}

}  // namespace

OccupancyMap OccupancyMap::from_grid(const GridMap& grid) {
    const Raster<CellState>& states = grid.states;
    if (states.values.empty()) return OccupancyMap(grid.resolution_m, grid.map_from_image);
    OccupancyMap map(grid.resolution_m, grid.map_from_image, root_around(states));
    const auto [low, high] = bounds_of_known(states);
    if (low.x <= high.x) map.fill_from(states, low, high);
    return map;
}

void OccupancyMap::fill_from(const Raster<CellState>& states, Cell low, Cell high) {
    reserve(low, high);
    const Raster<std::uint32_t>& directory = store_.directory();
    for (std::size_t i = 0; i < directory.values.size(); ++i) {
        const Cell tile = directory.cell(i);
        const Tile values = tile_from(states, tile);
        store_.set_tile(tile, values);
        pyramid_.set_tile(tile_position(tile), states_of(values));
    }
    store_.compact();
    pyramid_.rebuild();
    num_leaves_ = count_leaves(pyramid_.num_layers() - 1, {0, 0});
}

Raster<CellState> OccupancyMap::to_raster() const {
    const Raster<std::uint32_t>& directory = store_.directory();
    Cell low{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max()};
    Cell high{std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min()};
    for (std::size_t i = 0; i < directory.values.size(); ++i) {
        const Cell tile = directory.cell(i);
        const std::uint64_t rows = known_cells(store_.tile(tile));
        if (rows == 0) continue;
        std::uint64_t columns = rows | rows >> 32;
        columns |= columns >> 16;
        columns = (columns | columns >> 8) & 0xFF;
        const Cell corner{tile.x * kTileSide, tile.y * kTileSide};
        low = {std::min(low.x, corner.x + std::countr_zero(columns)),
               std::min(low.y, corner.y + std::countr_zero(rows) / kTileSide)};
        high = {std::max(high.x, corner.x + 63 - std::countl_zero(columns)),
                std::max(high.y, corner.y + (63 - std::countl_zero(rows)) / kTileSide)};
    }
    if (low.x > high.x) {
        return {};
    }
    Raster<CellState> states(low, high.x - low.x + 1, high.y - low.y + 1);
    for (std::size_t i = 0; i < states.values.size(); ++i) states.values[i] = state(states.cell(i));
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
    const Cell position{(block.lower_left.x - root_.lower_left.x) >> block.level,
                        (block.lower_left.y - root_.lower_left.y) >> block.level};
    return (4 * count_leaves(block.level - kTileBits, position) - 1) / 3;
}

Root OccupancyMap::block_around(Cell low, Cell high) const {
    const auto code = [&](Cell cell) {
        return morton_code(tile_position({cell.x >> kTileBits, cell.y >> kTileBits}));
    };
    return block_of(code(low), code(high));
}

Root OccupancyMap::block_of(std::uint64_t first_tile_code, std::uint64_t last_tile_code) const {
    int layer = 0;
    while (first_tile_code != last_tile_code) {
        first_tile_code >>= 2;
        last_tile_code >>= 2;
        ++layer;
    }
    const int level = layer + kTileBits;
    const Cell position = morton_position(first_tile_code);
    return {
        {root_.lower_left.x + (position.x << level), root_.lower_left.y + (position.y << level)},
        static_cast<std::uint8_t>(level)};
}

std::vector<Leaf> OccupancyMap::leaves() const {
    require_committed();
    std::vector<Leaf> leaves;
    leaves.reserve(num_leaves_);
    append_leaves(pyramid_.num_layers() - 1, {0, 0}, leaves);
    return leaves;
}

void OccupancyMap::append_leaves(int layer, Cell position, std::vector<Leaf>& leaves) const {
    const BlockState state = pyramid_.at(layer, position);
    if (is_uniform(state)) {
        const int level = layer + kTileBits;
        leaves.push_back({{root_.lower_left.x + (position.x << level),
                           root_.lower_left.y + (position.y << level)},
                          static_cast<std::uint8_t>(level),
                          cell_state(state)});
    } else if (layer == 0) {
        append_tile_leaves(position, leaves);
    } else {
        for (int quadrant = 0; quadrant < 4; ++quadrant) {
            append_leaves(layer - 1, child_of(position, quadrant), leaves);
        }
    }
}

void OccupancyMap::append_tile_leaves(Cell position, std::vector<Leaf>& leaves) const {
    const Cell tile{position.x + root_tile().x, position.y + root_tile().y};
    const TileStates states = states_of(store_.tile(tile));
    const TileLeaves in_tile = leaves_of(states);
    TileMask corners = in_tile.by_level[0] | in_tile.by_level[1] | in_tile.by_level[2];
    for (; corners != 0; corners &= corners - 1) {
        const int corner = std::countr_zero(corners);
        const Cell cell = morton_position(static_cast<std::uint64_t>(corner));
        const TileMask bit = TileMask{1} << corner;
        const int level = (in_tile.by_level[0] & bit) != 0   ? 0
                          : (in_tile.by_level[1] & bit) != 0 ? 1
                                                             : 2;
        leaves.push_back({{tile.x * kTileSide + cell.x, tile.y * kTileSide + cell.y},
                          static_cast<std::uint8_t>(level),
                          states.at(corner)});
    }
}

std::size_t OccupancyMap::count_leaves(int layer, Cell position) const {
    if (is_uniform(pyramid_.at(layer, position))) return 1;
    if (layer == 0) return static_cast<std::size_t>(pyramid_.num_leaves_in_tile(position));
    std::size_t sum = 0;
    for (int quadrant = 0; quadrant < 4; ++quadrant) {
        sum += count_leaves(layer - 1, child_of(position, quadrant));
    }
    return sum;
}

// Nodes of the tree in the tiles of these codes, which ascend, and above them.
std::size_t OccupancyMap::count_nodes_above(std::vector<std::uint64_t> tile_codes) const {
    const int top = pyramid_.num_layers() - 1;
    std::size_t sum = 0;
    for (int layer = 0; layer <= top; ++layer) {
        for (const std::uint64_t code : tile_codes) {
            // A block is a node when its parent is divided.
            if (layer < top &&
                pyramid_.at(layer + 1, morton_position(code >> 2)) != BlockState::mixed) {
                continue;
            }
            sum += layer > 0 ? 1 : (4 * count_leaves(0, morton_position(code)) - 1) / 3;
        }
        for (std::uint64_t& code : tile_codes) code >>= 2;
        tile_codes.erase(std::unique(tile_codes.begin(), tile_codes.end()), tile_codes.end());
    }
    return sum;
}

}  // namespace quadcut
