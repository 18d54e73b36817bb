// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/find_submaps.hpp"

#include <algorithm>
#include <utility>

#include "quadcut/paper/submaps.hpp"

namespace quadcut {
namespace {

/// Components of the paper's graph with at least the given area; nodes ascending.
std::vector<std::uint32_t> nodes_of_large_components(const Graph& graph,
                                                     const PaperOptions& options) {
    const std::vector<std::uint32_t> component = connected_components(graph);
    const std::size_t count =
        component.empty() ? 0 : 1 + *std::max_element(component.begin(), component.end());
    std::vector<double> area_m2(count, 0.0);
    std::vector<double> largest_leaf_m2(count, 0.0);
    for (std::size_t node = 0; node < component.size(); ++node) {
        area_m2[component[node]] += graph.area_m2[node];
        double& largest = largest_leaf_m2[component[node]];
        largest = std::max(largest, graph.area_m2[node]);
    }
    // Departs from the paper: a long thin sliver, as scans leave along walls, is large enough but
    // no place. Each would take one of the smallest eigenvectors away from the building.
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t node = 0; node < component.size(); ++node) {
        if (area_m2[component[node]] >= options.min_component_m2 &&
            largest_leaf_m2[component[node]] >= options.min_leaf_m * options.min_leaf_m) {
            nodes.push_back(node);
        }
    }
    return nodes;
}

}  // namespace

Submaps find_submaps(const Graph& graph, const PaperOptions& options, std::uint64_t seed,
                     StageClock& clock, const Executor& executor) {
    Submaps submaps;
    submaps.nodes = nodes_of_large_components(graph, options);
    const Graph region = induced_subgraph(graph, submaps.nodes);
    Pieces& pieces = submaps.pieces;
    if (options.num_submaps != 0) {
        pieces = cut_into(region, options.num_submaps, options, seed, clock, executor);
    } else {
        pieces = cut(region, options, seed, clock, executor);
        pieces = divide_submaps(region, std::move(pieces), options, seed, clock, executor);
        clock.begin("fuse");
        pieces = fuse_submaps(region, std::move(pieces), options);
    }
    return submaps;
}

}  // namespace quadcut
