// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/root.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// The state all cells of a block share, or `mixed`. `absent`: the tree has no such node.
enum class BlockState : std::uint8_t { unknown = 0, free = 1, occupied = 2, mixed = 3, absent = 4 };

/// @pre `state` is neither mixed nor absent.
[[nodiscard]] constexpr CellState cell_state(BlockState state) {
    return static_cast<CellState>(state);
}
[[nodiscard]] constexpr bool is_uniform(BlockState state) { return state < BlockState::mixed; }

/// Position of a child in its layer; quadrants 0 .. 3 are in depth-first order.
[[nodiscard]] constexpr Cell child_of(Cell position, int quadrant) {
    return {position.x * 2 + (quadrant & 1), position.y * 2 + (quadrant >> 1)};
}

/// One byte for each block of 8 x 8 cells and more, up to the root: the upper part of the quadtree.
/// Layer 0 holds the tiles, layer h the blocks of 2^h x 2^h tiles. Positions count blocks of the
/// layer's own size from the root's lower left. Blocks beyond the rectangle are unknown.
class StatePyramid {
public:
    /// All unknown. `tiles` lie inside the root.
    StatePyramid(const Root& root, const Box& tiles);

    [[nodiscard]] int num_layers() const { return static_cast<int>(layers_.size()); }

    [[nodiscard]] BlockState at(int layer, Cell position) const {
        const Raster<std::uint8_t>& nodes = layers_[static_cast<std::size_t>(layer)];
        if (!nodes.contains(position)) return BlockState::unknown;
        const std::uint8_t node = nodes.at(position) & ~kMark;
        return static_cast<BlockState>(node < kMixed ? node : kMixed);
    }
    /// @pre layer > 0; beyond the rectangle the state is unknown.
    void set(int layer, Cell position, BlockState state) {
        Raster<std::uint8_t>& nodes = layers_[static_cast<std::size_t>(layer)];
        if (nodes.contains(position)) nodes.at(position) = static_cast<std::uint8_t>(state);
    }

    /// Leaves in a tile, 1 when it has one state.
    [[nodiscard]] int num_leaves_in_tile(Cell position) const {
        const Raster<std::uint8_t>& tiles = layers_.front();
        const int node = tiles.contains(position) ? tiles.at(position) & ~kMark : 0;
        return node < kMixed ? 1 : node;
    }
    /// Takes the mark off as well. @pre the position lies in the rectangle.
    void set_tile(Cell position, const TileStates& states);

    /// A mark on a tile, for those who must remember it. @pre the position lies in the rectangle.
    [[nodiscard]] bool is_marked(Cell position) const {
        return (layers_.front().at(position) & kMark) != 0;
    }
    void mark(Cell position) { layers_.front().at(position) |= kMark; }
    /// Layer 0 of `smaller`, marks and all, whose root lies at `position` in this one's.
    /// The layers above are not set: rebuild().
    void take_tiles(const StatePyramid& smaller, Cell position);

    /// The state of a block of layer > 0 from its four children.
    [[nodiscard]] BlockState from_children(int layer, Cell position) const;
    /// Sets all layers from layer 0. O(tiles).
    void rebuild();

    /// Calls `visit(layer, position)` for each block of one state in a block, and for each of its
    /// mixed tiles, in depth-first order.
    template <typename Visitor>
    void for_each_block(int layer, Cell position, const Visitor& visit) const {
        if (layer == 0 || is_uniform(at(layer, position))) {
            visit(layer, position);
            return;
        }
        for (int quadrant = 0; quadrant < 4; ++quadrant) {
            for_each_block(layer - 1, child_of(position, quadrant), visit);
        }
    }
    /// Leaves in a block. O(its nodes of tile size and up).
    [[nodiscard]] std::size_t num_leaves_in(int layer, Cell position) const;

    [[nodiscard]] std::size_t bytes() const;

private:
    // In layer 0 a mixed tile is stored as its number of leaves, which is 4 at least.
    static constexpr std::uint8_t kMixed = static_cast<std::uint8_t>(BlockState::mixed);
    static constexpr std::uint8_t kMark = 0x80;

    std::vector<Raster<std::uint8_t>> layers_;
};

}  // namespace quadcut
