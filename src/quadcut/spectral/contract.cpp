// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/contract.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "quadcut/spectral/embedding.hpp"

namespace quadcut {

std::vector<std::uint32_t> degree_basins(const Graph& graph) {
    const std::size_t num_nodes = graph.num_nodes();
    std::vector<double> degree(num_nodes);
    for (std::size_t i = 0; i < num_nodes; ++i) {
        const auto weights = graph.neighbour_weights(i);
        degree[i] = std::accumulate(weights.begin(), weights.end(), 0.0);
    }
    std::vector<std::uint32_t> leads_to(num_nodes);
    for (std::uint32_t i = 0; i < num_nodes; ++i) {
        leads_to[i] = i;
        for (const std::uint32_t next : graph.neighbours(i)) {
            const std::uint32_t best = leads_to[i];
            const bool is_higher = degree[next] > degree[best];
            if (is_higher || (degree[next] == degree[best] && next < best)) leads_to[i] = next;
        }
    }
    // A way climbs, or goes to an earlier node of the same height: it ends.
    const auto summit_of = [&](std::uint32_t node) {
        while (leads_to[node] != node) {
            leads_to[node] = leads_to[leads_to[node]];
            node = leads_to[node];
        }
        return node;
    };
    std::vector<std::uint32_t> summits(num_nodes);
    for (std::uint32_t i = 0; i < num_nodes; ++i) summits[i] = summit_of(i);
    return numbered_by_first_sample(summits, num_nodes).labels;
}

Graph contract(const Graph& graph, std::span<const std::uint32_t> group_of_node) {
    std::vector<double> area_m2;
    std::vector<WeightedEdge> edges;
    edges.reserve(graph.columns.size());
    for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
        const std::uint32_t own = group_of_node[node];
        if (own >= area_m2.size()) area_m2.resize(own + std::size_t{1}, 0.0);
        area_m2[own] += graph.area_m2[node];
        const auto neighbours = graph.neighbours(node);
        const auto weights = graph.neighbour_weights(node);
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            const std::uint32_t other = group_of_node[neighbours[k]];
            // An edge between groups stands in two rows, and is one edge.
            if (own <= other) edges.push_back({own, other, weights[k]});
        }
    }
    return build_graph(edges, std::move(area_m2));
}

}  // namespace quadcut
