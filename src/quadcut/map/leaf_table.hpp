// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/ids.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/leaf.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/root.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// A list of leaves that can be asked which leaf holds a cell, and which leaves meet a rectangle.
///
/// Only free and occupied leaves are found: a cell of an unknown leaf, a cell that no leaf of the
/// list covers and a cell outside the root all give nothing, since none of them lets sight or a
/// robot pass. Unknown leaves keep their place in `leaves()`, so a LeafId stays the index in the
/// list that the map returned.
///
/// Inside: a rectangle of 8 x 8-cell tiles around the free and occupied leaves; an entry is a leaf
/// that covers the whole tile, or a table of 64 bytes that says which leaf holds which cell.
class LeafTable {
public:
    /// `leaves` in depth-first (Z) order as OccupancyMap::leaves() gives them, or a part of that
    /// list in the same order. O(leaves + tiles of their bounding box).
    /// @pre they are blocks of the root.
    LeafTable(std::vector<Leaf> leaves, const Root& root);

    [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }
    [[nodiscard]] const Leaf& leaf(LeafId id) const { return leaves_[index(id)]; }
    [[nodiscard]] const Root& root() const { return root_; }

    /// The free or occupied leaf that holds the cell, or nothing. Any cell may be asked. O(1).
    [[nodiscard]] std::optional<LeafId> find(Cell cell) const {
        const std::uint32_t entry = entry_at(tile_of(cell));
        if ((entry & kMixed) == 0) {
            return LeafId{entry};
        }
        if (entry == kNothing) return std::nullopt;
        const Tile& tile = tiles_[entry & ~kMixed];
        const std::uint8_t offset = tile.offsets[place_in_tile(cell)];
        if (offset == kNoLeaf) return std::nullopt;
        return LeafId{tile.first_leaf + offset};
    }

    /// Calls `visit(LeafId)` once for each free or occupied leaf that shares a cell with the
    /// rectangle low .. high (both corners included), tile row by tile row from the lower left.
    /// O(leaves met + tiles of the rectangle).
    template <typename Visitor>
    void for_each_leaf_in(Cell low, Cell high, Visitor&& visit) const {
        if (low.x > high.x || low.y > high.y) return;
        const Box tiles = directory_.box();
        const Cell first{std::max(tile_of(low).x, tiles.low.x),
                         std::max(tile_of(low).y, tiles.low.y)};
        const Cell last{std::min(tile_of(high).x, tiles.high.x),
                        std::min(tile_of(high).y, tiles.high.y)};
        for (std::int32_t y = first.y; y <= last.y; ++y) {
            for (std::int32_t x = first.x; x <= last.x; ++x) {
                const std::uint32_t entry = directory_.at({x, y});
                if ((entry & kMixed) == 0) {
                    const Leaf& large = leaves_[entry];
                    // A leaf of many tiles is visited at the first of them in the rectangle only.
                    if (y == std::max(large.lower_left.y >> kTileBits, first.y)) {
                        visit(LeafId{entry});
                    }
                    x = (large.lower_left.x + large.side_cells() - 1) >> kTileBits;
                } else if (entry != kNothing) {
                    visit_tile(tiles_[entry & ~kMixed], low, high, visit);
                }
            }
        }
    }

    // What is inside, for a device that reads it with its own code.
    static constexpr std::uint32_t kMixed = 0x8000'0000U;
    static constexpr std::uint32_t kNothing = 0xFFFF'FFFFU;
    static constexpr std::uint8_t kNoLeaf = 0xFF;
    /// A tile that several leaves share. Cell (x, y) lies in leaf first_leaf + offsets[8 y + x],
    /// or in none where that is kNoLeaf.
    struct Tile {
        std::uint32_t first_leaf = 0;
        std::uint32_t num_leaves = 0;
        std::array<std::uint8_t, kTileCells> offsets{};
    };
    /// For each tile the leaf that covers it, or kMixed plus its place in tiles(), or kNothing.
    [[nodiscard]] const Raster<std::uint32_t>& directory() const { return directory_; }
    [[nodiscard]] const std::vector<Tile>& tiles() const { return tiles_; }

private:
    [[nodiscard]] std::uint32_t entry_at(Cell tile) const {
        return directory_.contains(tile) ? directory_.at(tile) : kNothing;
    }

    template <typename Visitor>
    void visit_tile(const Tile& tile, Cell low, Cell high, Visitor& visit) const {
        for (std::uint32_t i = tile.first_leaf; i < tile.first_leaf + tile.num_leaves; ++i) {
            const Leaf& small = leaves_[i];
            if (small.state != CellState::unknown && small.lower_left.x <= high.x &&
                small.lower_left.y <= high.y && small.lower_left.x + small.side_cells() > low.x &&
                small.lower_left.y + small.side_cells() > low.y) {
                visit(LeafId{i});
            }
        }
    }

    void add_small_leaf(std::uint32_t id);

    Root root_;
    std::vector<Leaf> leaves_;
    Raster<std::uint32_t> directory_;
    std::vector<Tile> tiles_;
};

/// The quadtree's leaves, and which of them are free: the nodes of the graph.
struct FreeLeaves {
    LeafTable table;
    std::vector<LeafId> nodes;
};

/// The leaves of a map's quadtree, its blocks aligned to cell (0, 0). O(cells).
[[nodiscard]] FreeLeaves free_leaves(const GridMap& map);

/// Gives the cells of a leaf a label. @pre the leaf lies in the raster.
inline void paint_leaf(const Leaf& leaf, std::uint32_t label, Raster<std::uint32_t>& labels) {
    for_each_cell(leaf.box(), [&](Cell cell) { labels.at(cell) = label; });
}

/// The area of each node's leaf, m2: what build_graph() wants beside the edges.
[[nodiscard]] std::vector<double> leaf_areas_m2(const LeafTable& table,
                                                std::span<const LeafId> nodes, double resolution_m);

}  // namespace quadcut
