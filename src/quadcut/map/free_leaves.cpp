// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/free_leaves.hpp"

#include "quadcut/map/occupancy_map.hpp"

namespace quadcut {

FreeLeaves free_leaves(const GridMap& map) {
    const OccupancyMap tree = OccupancyMap::from_grid(map);
    FreeLeaves leaves{LeafTable(tree.leaves(), tree.root()), {}};
    for (std::size_t i = 0; i < leaves.table.leaves().size(); ++i) {
        if (leaves.table.leaves()[i].state == CellState::free) {
            leaves.nodes.push_back(LeafId{static_cast<std::uint32_t>(i)});
        }
    }
    return leaves;
}

void paint_leaf(const Leaf& leaf, std::uint32_t label, Raster<std::uint32_t>& labels) {
    for (std::int32_t y = 0; y < leaf.side_cells(); ++y) {
        for (std::int32_t x = 0; x < leaf.side_cells(); ++x) {
            labels.at({leaf.lower_left.x + x, leaf.lower_left.y + y}) = label;
        }
    }
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
