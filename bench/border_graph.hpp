// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "quadcut/map/leaf.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut {

/// The pairs of free leaves that share a border, each once, with the weight shared length /
/// distance between the centres: the finite-volume discretisation of the free space.
inline std::vector<WeightedEdge> border_edges(const FreeLeaves& leaves) {
    std::vector<std::uint32_t> node_of_leaf(leaves.table.leaves().size());
    for (std::uint32_t node = 0; node < leaves.nodes.size(); ++node) {
        node_of_leaf[static_cast<std::uint32_t>(leaves.nodes[node])] = node;
    }
    std::vector<WeightedEdge> edges;
    for (std::uint32_t node = 0; node < leaves.nodes.size(); ++node) {
        const Leaf& leaf = leaves.table.leaf(leaves.nodes[node]);
        const std::int32_t side = leaf.side_cells();
        // Along the cells just beyond the right side, and just beyond the top.
        for (const Cell step : {Cell{0, 1}, Cell{1, 0}}) {
            for (std::int32_t i = 0; i < side;) {
                const Cell cell{leaf.lower_left.x + step.y * side + step.x * i,
                                leaf.lower_left.y + step.x * side + step.y * i};
                const std::optional<LeafId> id = leaves.table.find(cell);
                const Leaf* const other = id ? &leaves.table.leaf(*id) : nullptr;
                i += other != nullptr ? other->side_cells() : 1;
                if (other == nullptr || other->state != CellState::free) continue;
                const HalfCell a = centre(leaf);
                const HalfCell b = centre(*other);
                // Of two squares side by side in a quadtree one spans the other's side.
                const double shared = std::min(side, other->side_cells());
                edges.push_back({node, node_of_leaf[static_cast<std::uint32_t>(*id)],
                                 2.0 * shared /
                                     std::hypot(static_cast<double>(a.x - b.x),
                                                static_cast<double>(a.y - b.y))});
            }
        }
    }
    return edges;
}

/// The border graph of a map's free leaves; its largest component.
inline Graph border_graph(const GridMap& map) {
    const FreeLeaves leaves = free_leaves(map);
    const Graph graph = build_graph(border_edges(leaves),
                                    leaf_areas_m2(leaves.table, leaves.nodes, map.resolution_m));
    const auto component = connected_components(graph);
    std::vector<std::vector<std::uint32_t>> nodes;
    for (std::uint32_t i = 0; i < component.size(); ++i) {
        if (component[i] >= nodes.size()) nodes.resize(component[i] + std::size_t{1});
        nodes[component[i]].push_back(i);
    }
    const auto largest =
        std::max_element(nodes.begin(), nodes.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
    return induced_subgraph(graph, *largest);
}

}  // namespace quadcut
