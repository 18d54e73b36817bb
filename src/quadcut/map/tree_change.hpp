// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/leaf.hpp"
#include "quadcut/map/root.hpp"
#include "quadcut/map/state_pyramid.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// Brings the pyramid up to date after some tiles changed, and finds which nodes of the quadtree
/// came and went, from the changed tiles upwards: work stops where a block keeps its state.
class TreeChange {
public:
    /// `before` is the root at the last update; `root` is the same or has grown from it.
    TreeChange(StatePyramid& pyramid, const Root& before, const Root& root);

    /// A tile by its Morton code in the root. @pre codes ascend from call to call.
    void add_tile(std::uint64_t code, const TileStates& before, const TileStates& after);
    /// After the last tile.
    void finish();

    /// Leaves that came, fine before coarse.
    [[nodiscard]] std::vector<Leaf>& leaves_added() { return leaves_added_; }
    [[nodiscard]] std::size_t num_leaves_removed() const { return num_leaves_removed_; }
    [[nodiscard]] std::size_t num_inner_nodes_added() const { return num_inner_nodes_added_; }

private:
    struct Node {
        std::uint64_t code = 0;
        BlockState before = BlockState::absent;
        BlockState after = BlockState::absent;
    };

    void add_leaves_in_tile(std::uint64_t code, const TileStates& before, const TileStates& after);
    void insert_old_root();
    void update_parent(std::size_t first, std::size_t last);
    void account(const Node& node, BlockState parent_before, BlockState parent_after);
    [[nodiscard]] bool is_old_root(std::uint64_t code) const {
        return layer_ == old_layer_ && code == old_code_;
    }

    StatePyramid& pyramid_;
    Root root_;
    int old_layer_ = 0;
    std::uint64_t old_code_ = 0;
    int layer_ = 0;
    std::vector<Node> nodes_;    // of this layer, by code
    std::vector<Node> parents_;  // of the next
    std::vector<Leaf> leaves_added_;
    std::size_t num_leaves_removed_ = 0;
    std::size_t num_inner_nodes_added_ = 0;
};

}  // namespace quadcut
