// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/coarsen.hpp"

#include <limits>
#include <utility>

namespace quadcut {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr int kMaxMembers = 4;

}  // namespace

Coarsening coarsen(const Graph& graph, std::span<const double> volumes, double max_volume) {
    Coarsening coarse;
    coarse.coarse_of_node.assign(graph.num_nodes(), kNone);
    auto& coarse_of = coarse.coarse_of_node;
    std::vector<double> coarse_volumes;
    std::vector<int> num_members;
    for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
        if (coarse_of[node] != kNone) continue;
        const auto neighbours = graph.neighbours(node);
        const auto weights = graph.neighbour_weights(node);
        std::uint32_t chosen = node;
        double strongest = 0.0;
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            const std::uint32_t other = coarse_of[neighbours[k]];
            const double volume = other == kNone ? volumes[neighbours[k]] : coarse_volumes[other];
            if (neighbours[k] == node || volume + volumes[node] > max_volume) continue;
            if (other != kNone && num_members[other] == kMaxMembers) continue;
            const double strength = weights[k] * (1.0 / volumes[node] + 1.0 / volume);
            if (strength <= strongest) continue;
            strongest = strength;
            chosen = neighbours[k];
        }
        if (coarse_of[chosen] == kNone) {
            coarse_of[chosen] = static_cast<std::uint32_t>(coarse_volumes.size());
            coarse_volumes.push_back(volumes[chosen]);
            num_members.push_back(1);
        }
        if (chosen == node) continue;
        coarse_of[node] = coarse_of[chosen];
        coarse_volumes[coarse_of[node]] += volumes[node];
        ++num_members[coarse_of[node]];
    }

    std::vector<WeightedEdge> edges;
    edges.reserve(graph.columns.size() / 2);
    for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
        const auto neighbours = graph.neighbours(node);
        const auto weights = graph.neighbour_weights(node);
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            const std::uint32_t other = coarse_of[neighbours[k]];
            if (other > coarse_of[node]) edges.push_back({coarse_of[node], other, weights[k]});
        }
    }
    coarse.graph = build_graph(edges, std::move(coarse_volumes));
    return coarse;
}

}  // namespace quadcut
