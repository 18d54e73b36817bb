// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/local_submaps.hpp"

#include <utility>
#include <vector>

#include "quadcut/graph/visibility.hpp"
#include "quadcut/segment/find_submaps.hpp"
#include "quadcut/segment/free_leaves.hpp"

namespace quadcut {
namespace {

/// The old submaps that go to the temporary list.
std::set<std::uint32_t> relevant_submaps(const SubmapWindow& window,
                                         const std::vector<WeightedEdge>& edges,
                                         const std::vector<std::uint32_t>& submap_of_node,
                                         const std::vector<bool>& is_new) {
    std::set<std::uint32_t> relevant;
    for (const WeightedEdge& edge : edges) {
        for (const auto& [a, b] : {std::pair{edge.a, edge.b}, std::pair{edge.b, edge.a}}) {
            const std::uint32_t submap = submap_of_node[b];
            if (is_new[a] && window.seen.count(submap) != 0) relevant.insert(submap);
            // A leaf that is new where a submap was takes that submap along.
            if (is_new[a] && window.seen.count(submap_of_node[a]) != 0) {
                relevant.insert(submap_of_node[a]);
            }
        }
    }
    return relevant;
}

}  // namespace

LocalCut cut_submaps(const SubmapWindow& window, const SegmentOptions& options,
                     const Executor& executor) {
    GridMap map;
    map.resolution_m = window.resolution_m;
    map.states = window.states;
    FreeLeaves leaves = free_leaves(map);
    std::vector<LeafId> nodes;
    std::vector<std::uint32_t> submap_of_node;
    std::vector<bool> is_new;
    for (const LeafId id : leaves.nodes) {
        const Leaf& leaf = leaves.table.leaf(id);
        const std::int32_t half = leaf.side_cells() / 2;
        const Cell centre{leaf.lower_left.x + half, leaf.lower_left.y + half};
        const std::uint32_t submap = window.submaps.at(centre);
        bool is_updated = submap == 0;
        for (std::int32_t y = 0; y < leaf.side_cells() && !is_updated; ++y) {
            for (std::int32_t x = 0; x < leaf.side_cells() && !is_updated; ++x) {
                is_updated = window.updated.at({leaf.lower_left.x + x, leaf.lower_left.y + y}) != 0;
            }
        }
        if (!is_updated && window.seen.count(submap) == 0) continue;
        nodes.push_back(id);
        submap_of_node.push_back(submap);
        is_new.push_back(is_updated);
    }
    const std::vector<WeightedEdge> edges =
        sight_edges(leaves.table, nodes, window.resolution_m, options.paper.self_loops, executor);
    const std::set<std::uint32_t> taken = relevant_submaps(window, edges, submap_of_node, is_new);
    std::vector<std::uint32_t> in_list;
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        const bool is_taken = taken.count(submap_of_node[node]) != 0;
        // What is new in a submap that is not taken stays with it.
        if (is_taken || (is_new[node] && submap_of_node[node] == 0)) in_list.push_back(node);
    }
    const Graph auxiliary = induced_subgraph(
        build_graph(edges, leaf_areas_m2(leaves.table, nodes, window.resolution_m)), in_list);
    StageClock clock;
    const Submaps submaps = find_submaps(auxiliary, options.paper, options.seed, clock, executor);

    LocalCut cut;
    cut.num_nodes = in_list.size();
    cut.num_regions = submaps.pieces.count;
    cut.regions = Raster<std::uint32_t>(window.states.origin, window.states.width,
                                        window.states.height, kNotCut);
    for (std::size_t i = 0; i < cut.regions.values.size(); ++i) {
        if (taken.count(window.submaps.values[i]) != 0) cut.regions.values[i] = 0;
    }
    for (std::size_t i = 0; i < submaps.nodes.size(); ++i) {
        paint_leaf(leaves.table.leaf(nodes[in_list[submaps.nodes[i]]]),
                   submaps.pieces.piece_of_node[i] + 1, cut.regions);
    }
    return cut;
}

}  // namespace quadcut
