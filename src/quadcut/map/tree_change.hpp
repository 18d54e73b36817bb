// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "quadcut/map/root.hpp"
#include "quadcut/map/state_pyramid.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// A tile that was written, by its position in the pyramid's layer 0.
struct WrittenTile {
    Cell position;
    std::uint64_t code = 0;  ///< morton_code(position)
    TileStates before;
    TileStates after;
};

/// Which nodes of the quadtree came and went.
struct TreeChange {
    std::size_t num_leaves_added = 0;
    std::size_t num_leaves_removed = 0;
    std::size_t num_inner_nodes_added = 0;
    /// Nodes that the tree has now in and above the written tiles.
    std::size_t num_nodes_touched = 0;
};

/// Brings the pyramid up to date after tiles were written. `before` is the root at the last update;
/// `root` is the same or has grown from it. O(layers) for each tile.
/// @pre the codes ascend.
[[nodiscard]] TreeChange update_tree(StatePyramid& pyramid, const Root& before, const Root& root,
                                     std::span<const WrittenTile> tiles);

}  // namespace quadcut
