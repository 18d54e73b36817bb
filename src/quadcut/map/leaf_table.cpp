// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/leaf_table.hpp"

#include <algorithm>
#include <utility>

#include "quadcut/map/occupancy_map.hpp"

namespace quadcut {
LeafTable::LeafTable(std::vector<Leaf> leaves, const Root& root)
    : root_(root), leaves_(std::move(leaves)) {
    Box tiles;
    for (const Leaf& leaf : leaves_) {
        if (leaf.state == CellState::unknown) continue;
        tiles.include({tile_of(leaf.lower_left), tile_of(leaf.box().high)});
    }
    directory_ = Raster<std::uint32_t>(tiles, kNothing);
    for (std::uint32_t id = 0; id < leaves_.size(); ++id) {
        const Leaf& leaf = leaves_[id];
        if (leaf.state == CellState::unknown) continue;
        if (leaf.level < kTileBits) {
            add_small_leaf(id);
            continue;
        }
        const std::int32_t side = leaf.side_cells() >> kTileBits;
        const Cell first = tile_of(leaf.lower_left);
        for (std::int32_t y = first.y; y < first.y + side; ++y) {
            std::fill_n(&directory_.at({first.x, y}), side, id);
        }
    }
}

void LeafTable::add_small_leaf(std::uint32_t id) {
    const Leaf& leaf = leaves_[id];
    std::uint32_t& entry = directory_.at(tile_of(leaf.lower_left));
    if (entry == kNothing) {
        entry = kMixed | static_cast<std::uint32_t>(tiles_.size());
        tiles_.push_back({id, 0, {}});
        tiles_.back().offsets.fill(kNoLeaf);
    }
    // In depth-first order the leaves of a tile follow each other, and there are 64 at most.
    Tile& tile = tiles_[entry & ~kMixed];
    const auto side = static_cast<std::size_t>(leaf.side_cells());
    for (std::size_t row = 0; row < side; ++row) {
        std::fill_n(&tile.offsets[place_in_tile(leaf.lower_left) + row * kTileSide], side,
                    static_cast<std::uint8_t>(id - tile.first_leaf));
    }
    tile.num_leaves = id - tile.first_leaf + 1;
}

FreeLeaves free_leaves(const GridMap& map) {
    const OccupancyMap tree = OccupancyMap::from_grid(map);
    FreeLeaves leaves{LeafTable(tree.leaves(), tree.root()), {}};
    for (std::uint32_t i = 0; i < leaves.table.leaves().size(); ++i) {
        if (leaves.table.leaves()[i].state == CellState::free) leaves.nodes.push_back(LeafId{i});
    }
    return leaves;
}

std::vector<double> leaf_areas_m2(const LeafTable& table, std::span<const LeafId> nodes,
                                  double resolution_m) {
    std::vector<double> areas_m2;
    areas_m2.reserve(nodes.size());
    for (const LeafId id : nodes) {
        const double side_m = table.leaf(id).side_cells() * resolution_m;
        areas_m2.push_back(side_m * side_m);
    }
    return areas_m2;
}

}  // namespace quadcut
