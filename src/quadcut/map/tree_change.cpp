// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/tree_change.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "quadcut/map/morton.hpp"

namespace quadcut {
namespace {

// The block `num_layers` above that holds one.
Cell ancestor(Cell position, int num_layers) {
    return {position.x >> num_layers, position.y >> num_layers};
}

/// Goes down to the written tiles, and sets the blocks around them on the way back.
class TreeUpdate {
public:
    TreeUpdate(StatePyramid& pyramid, const Root& before, const Root& root)
        : pyramid_(pyramid),
          old_layer_(before.level - kTileBits),
          old_position_(root.position(before.level, before.lower_left)) {}

    TreeChange run(std::span<const WrittenTile> tiles) {
        const int top = pyramid_.num_layers() - 1;
        account(top, {0, 0}, visit(top, {0, 0}, tiles), BlockState::absent, BlockState::mixed);
        return change_;
    }

private:
    struct Block {
        BlockState before = BlockState::absent;
        BlockState after = BlockState::absent;
        bool is_touched = false;
    };

    // `tiles` are the written ones in the block.
    Block visit(int layer, Cell position, std::span<const WrittenTile> tiles) {
        // A root that grew has new siblings and parents even where no tile was written.
        const bool has_old_root =
            layer > old_layer_ && ancestor(old_position_, layer - old_layer_) == position;
        if (tiles.empty() && !has_old_root) {
            const BlockState state = pyramid_.at(layer, position);
            return {state, state};
        }
        if (layer == 0) return visit_tile(tiles.front());
        Block block{layer > old_layer_ ? BlockState::absent : pyramid_.at(layer, position),
                    BlockState::absent, !tiles.empty()};
        std::array<Block, 4> children;
        for (std::size_t i = 0; i < 4; ++i) {
            const Cell child = child_of(position, static_cast<int>(i));
            // In the order of their codes, those of one block follow each other.
            const std::uint64_t beyond = (morton_code(child) + 1) << (2 * (layer - 1));
            const auto next =
                std::find_if(tiles.begin(), tiles.end(),
                             [&](const WrittenTile& tile) { return tile.code >= beyond; });
            children[i] = visit(layer - 1, child, {tiles.begin(), next});
            tiles = {next, tiles.end()};
        }
        block.after = pyramid_.from_children(layer, position);
        pyramid_.set(layer, position, block.after);
        for (std::size_t i = 0; i < 4; ++i) {
            account(layer - 1, child_of(position, static_cast<int>(i)), children[i], block.before,
                    block.after);
        }
        return block;
    }

    Block visit_tile(const WrittenTile& tile) {
        const Cell position = tile.position;
        Block block{pyramid_.at(0, position), BlockState::absent, true};
        pyramid_.set_tile(position, tile.after);
        block.after = pyramid_.at(0, position);
        // Divided blocks have four children each; account() counts the tile itself.
        change_.num_nodes_touched +=
            static_cast<std::size_t>(4 * (pyramid_.num_leaves_in_tile(position) - 1) / 3);
        if (tile.before != tile.after) compare_leaves(tile);
        return block;
    }

    void compare_leaves(const WrittenTile& tile) {
        const TileLeaves old_leaves = leaves_of(tile.before);
        const TileLeaves leaves = leaves_of(tile.after);
        const auto old_inner = old_leaves.inner_nodes();
        const auto inner = leaves.inner_nodes();
        const auto count = [](TileMask mask) {
            return static_cast<std::size_t>(std::popcount(mask));
        };
        for (std::size_t i = 0; i < 2; ++i) {
            change_.num_inner_nodes_added += count(inner[i] & ~old_inner[i]);
        }
        const TileMask differing =
            (tile.before.free ^ tile.after.free) | (tile.before.occupied ^ tile.after.occupied);
        for (std::size_t level = 0; level < kTileBits; ++level) {
            const TileMask kept = leaves.by_level[level] & old_leaves.by_level[level] & ~differing;
            change_.num_leaves_removed += count(old_leaves.by_level[level] & ~kept);
            change_.num_leaves_added += count(leaves.by_level[level] & ~kept);
        }
    }

    // Counts a block whose parent is known. It is a node when its parent is divided, or when it is
    // the root.
    void account(int layer, Cell position, const Block& block, BlockState parent_before,
                 BlockState parent_after) {
        const bool was_node = parent_before == BlockState::mixed ||
                              (layer == old_layer_ && position == old_position_);
        const bool is_node = parent_after == BlockState::mixed;
        if (is_node && block.is_touched) ++change_.num_nodes_touched;
        if (block.before != BlockState::mixed && block.after == BlockState::mixed) {
            ++change_.num_inner_nodes_added;
        }
        const bool was_leaf = was_node && is_uniform(block.before);
        const bool is_leaf = is_node && is_uniform(block.after);
        if (was_leaf && is_leaf && block.before == block.after) return;
        if (was_leaf) ++change_.num_leaves_removed;
        if (is_leaf) ++change_.num_leaves_added;
    }

    StatePyramid& pyramid_;
    int old_layer_;
    Cell old_position_;
    TreeChange change_;
};

}  // namespace

TreeChange update_tree(StatePyramid& pyramid, const Root& before, const Root& root,
                       std::span<const WrittenTile> tiles) {
    return TreeUpdate(pyramid, before, root).run(tiles);
}

}  // namespace quadcut
