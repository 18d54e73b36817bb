// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/leaf_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "quadcut/map/morton.hpp"

namespace quadcut {
namespace {

// In depth-first order each leaf is the next run of Morton codes or a later one, which leaves no
// room for leaves that overlap or are not aligned.
void require_depth_first(const std::vector<Leaf>& leaves, const Root& root) {
    const std::uint64_t end = std::uint64_t{1} << (2 * root.level);
    std::uint64_t next = 0;
    for (const Leaf& leaf : leaves) {
        const std::uint64_t code = morton_code(root.position(0, leaf.lower_left));
        const std::uint64_t size = std::uint64_t{1} << (2 * std::min(leaf.level, root.level));
        if (leaf.level > root.level || code < next || code >= end || code % size != 0) {
            throw std::logic_error("LeafTable: a leaf is no block of the root or out of order");
        }
        next = code + size;
    }
}

}  // namespace

LeafTable::LeafTable(std::vector<Leaf> leaves, const Root& root)
    : root_(root), leaves_(std::move(leaves)) {
    require_depth_first(leaves_, root);
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

}  // namespace quadcut
