// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/base/ids.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// The quadtree's leaves, and which of them are free: the nodes of the graph.
struct FreeLeaves {
    LeafTable table;
    std::vector<LeafId> nodes;
};

/// The leaves of a map's quadtree, whose lower left corner is that of the map. O(cells).
[[nodiscard]] FreeLeaves free_leaves(const GridMap& map);

/// Gives the cells of a leaf a label. @pre the leaf lies in the raster.
void paint_leaf(const Leaf& leaf, std::uint32_t label, Raster<std::uint32_t>& labels);

/// The area of each node's leaf, m2: what build_graph() wants beside the edges.
[[nodiscard]] std::vector<double> leaf_areas_m2(const LeafTable& table,
                                                std::span<const LeafId> nodes, double resolution_m);

}  // namespace quadcut
