// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/tree_change.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "quadcut/map/morton.hpp"

namespace quadcut {
namespace {

BlockState block_state(const TileStates& states) {
    for (const CellState state : {CellState::unknown, CellState::free, CellState::occupied}) {
        if (states.of(state) == kWholeTile) return quadcut::block_state(state);
    }
    return BlockState::mixed;
}

// The cells whose state is the same.
TileMask agreement(const TileStates& a, const TileStates& b) {
    return (a.free & b.free) | (a.occupied & b.occupied) |
           (a.of(CellState::unknown) & b.of(CellState::unknown));
}

}  // namespace

TreeChange::TreeChange(StatePyramid& pyramid, const Root& before, const Root& root)
    : pyramid_(pyramid), root_(root), old_layer_(before.level - kTileBits) {
    old_code_ = morton_code({(before.lower_left.x - root.lower_left.x) >> before.level,
                             (before.lower_left.y - root.lower_left.y) >> before.level});
}

void TreeChange::add_tile(std::uint64_t code, const TileStates& before, const TileStates& after) {
    pyramid_.set_tile(morton_position(code), after);
    if (before == after) return;
    add_leaves_in_tile(code, before, after);
    const Node node{code, block_state(before), block_state(after)};
    if (node.before != BlockState::mixed && node.after == BlockState::mixed) {
        ++num_inner_nodes_added_;
    }
    if (node.before != node.after) nodes_.push_back(node);
}

void TreeChange::finish() {
    const int top = pyramid_.num_layers() - 1;
    std::stable_sort(leaves_added_.begin(), leaves_added_.end(),
                     [](const Leaf& a, const Leaf& b) { return a.level < b.level; });
    for (;; ++layer_) {
        if (layer_ == old_layer_ && old_layer_ < top) insert_old_root();
        if (layer_ == top) break;
        for (std::size_t first = 0; first < nodes_.size();) {
            std::size_t last = first + 1;
            while (last < nodes_.size() && nodes_[last].code >> 2 == nodes_[first].code >> 2) {
                ++last;
            }
            update_parent(first, last);
            first = last;
        }
        nodes_.swap(parents_);
        parents_.clear();
    }
    for (const Node& node : nodes_) account(node, BlockState::absent, BlockState::mixed);
}

void TreeChange::add_leaves_in_tile(std::uint64_t code, const TileStates& before,
                                    const TileStates& after) {
    const TileLeaves old_leaves = leaves_of(before);
    const TileLeaves new_leaves = leaves_of(after);
    const TileMask same = agreement(before, after);
    const Cell tile = morton_position(code);
    for (std::size_t level = 0; level < kTileBits; ++level) {
        const TileMask kept = old_leaves.by_level[level] & new_leaves.by_level[level] & same;
        num_leaves_removed_ +=
            static_cast<std::size_t>(std::popcount(old_leaves.by_level[level] & ~kept));
        TileMask added = new_leaves.by_level[level] & ~kept;
        for (; added != 0; added &= added - 1) {
            const int position = std::countr_zero(added);
            const Cell cell = morton_position(static_cast<std::uint64_t>(position));
            leaves_added_.push_back({{root_.lower_left.x + tile.x * kTileSide + cell.x,
                                      root_.lower_left.y + tile.y * kTileSide + cell.y},
                                     static_cast<std::uint8_t>(level),
                                     after.at(position)});
        }
    }
    // The tile itself, index 2, is counted with the blocks of tile size and up.
    const auto old_inner = old_leaves.inner_nodes();
    const auto new_inner = new_leaves.inner_nodes();
    for (std::size_t i = 0; i < 2; ++i) {
        num_inner_nodes_added_ +=
            static_cast<std::size_t>(std::popcount(new_inner[i] & ~old_inner[i]));
    }
}

// A root that grew has new siblings and parents even where no tile of it changed.
void TreeChange::insert_old_root() {
    const auto place =
        std::lower_bound(nodes_.begin(), nodes_.end(), old_code_,
                         [](const Node& node, std::uint64_t code) { return node.code < code; });
    if (place == nodes_.end() || place->code != old_code_) {
        const BlockState state = pyramid_.at(layer_, morton_position(old_code_));
        nodes_.insert(place, {old_code_, state, state});
    }
}

// `first` .. `last` are the changed children of one block.
void TreeChange::update_parent(std::size_t first, std::size_t last) {
    const std::uint64_t code = nodes_[first].code >> 2;
    const Cell position = morton_position(code);
    const int layer = layer_ + 1;
    const Node parent{code, layer > old_layer_ ? BlockState::absent : pyramid_.at(layer, position),
                      pyramid_.from_children(layer, position)};
    for (std::uint64_t child = code * 4; child < code * 4 + 4; ++child) {
        if (first < last && nodes_[first].code == child) {
            account(nodes_[first], parent.before, parent.after);
            ++first;
        } else {
            const BlockState state = pyramid_.at(layer_, morton_position(child));
            account({child, state, state}, parent.before, parent.after);
        }
    }
    pyramid_.set(layer, position, parent.after);
    if (parent.before != BlockState::mixed && parent.after == BlockState::mixed) {
        ++num_inner_nodes_added_;
    }
    if (parent.before != parent.after) parents_.push_back(parent);
}

// A uniform block is a leaf when its parent is divided, or when it is the root.
void TreeChange::account(const Node& node, BlockState parent_before, BlockState parent_after) {
    const bool was_leaf =
        is_uniform(node.before) && (parent_before == BlockState::mixed || is_old_root(node.code));
    const bool is_leaf = is_uniform(node.after) && parent_after == BlockState::mixed;
    if (was_leaf && is_leaf && node.before == node.after) return;
    if (was_leaf) ++num_leaves_removed_;
    if (is_leaf) {
        const Cell position = morton_position(node.code);
        const int level = layer_ + kTileBits;
        leaves_added_.push_back({{root_.lower_left.x + (position.x << level),
                                  root_.lower_left.y + (position.y << level)},
                                 static_cast<std::uint8_t>(level),
                                 cell_state(node.after)});
    }
}

}  // namespace quadcut
