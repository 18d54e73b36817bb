// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/halves.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "quadcut/spectral/eigensolver.hpp"

namespace quadcut {
namespace {

/// With the constant one. The second alone says where a cut is best on average over the region;
/// the next ones find, of several good places, the same in a region and in a part of it.
constexpr std::size_t kNumVectors = 4;

/// The best splitting point so far.
struct Split {
    double ncut = std::numeric_limits<double>::infinity();
    double cut_weight = 0.0;
    std::vector<std::uint32_t> side_of_node;
};

/// The nodes of a region, their degrees, and what all of them have.
struct Measures {
    std::vector<double> degree;
    double volume = 0.0;
    double area_m2 = 0.0;
};

Measures measure(const Graph& region) {
    Measures all;
    for (std::size_t node = 0; node < region.num_nodes(); ++node) {
        const auto weights = region.neighbour_weights(node);
        all.degree.push_back(std::accumulate(weights.begin(), weights.end(), 0.0));
    }
    all.volume = std::accumulate(all.degree.begin(), all.degree.end(), 0.0);
    all.area_m2 = std::accumulate(region.area_m2.begin(), region.area_m2.end(), 0.0);
    return all;
}

/// The weight that a node adds to the cut when it joins the side where `side` is 1.
double weight_added(const Graph& region, std::uint32_t node,
                    const std::vector<std::uint32_t>& side) {
    const auto neighbours = region.neighbours(node);
    const auto weights = region.neighbour_weights(node);
    double added = 0.0;
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
        if (neighbours[k] == node) continue;
        added += side[neighbours[k]] == 0 ? weights[k] : -weights[k];
    }
    return added;
}

/// Tries each splitting point of the nodes in an order.
void try_order(const Graph& region, const Measures& all, const std::vector<std::uint32_t>& order,
               double min_area_m2, Split& best) {
    std::vector<std::uint32_t> side(order.size(), 0);
    double volume = 0.0;
    double area_m2 = 0.0;
    double cut_weight = 0.0;
    std::size_t num_taken = 0;
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
        const std::uint32_t node = order[i];
        cut_weight += weight_added(region, node, side);
        side[node] = 1;
        volume += all.degree[node];
        area_m2 += region.area_m2[node];
        if (std::min(area_m2, all.area_m2 - area_m2) < min_area_m2) continue;
        const double ncut = cut_weight / volume + cut_weight / (all.volume - volume);
        if (ncut >= best.ncut) continue;
        best.ncut = ncut;
        best.cut_weight = cut_weight;
        num_taken = i + 1;
    }
    if (num_taken == 0) return;
    best.side_of_node.assign(order.size(), 0);
    for (std::size_t i = 0; i < num_taken; ++i) best.side_of_node[order[i]] = 1;
}

/// By the entries of an eigenvector, divided as rows of the embedding are.
std::vector<std::uint32_t> order_along(const Eigenpairs& pairs, std::size_t j) {
    const auto vector = pairs.vector(j);
    std::vector<double> entry(vector.size());
    for (std::size_t i = 0; i < entry.size(); ++i) {
        const double scale = pairs.null_vector[i];
        entry[i] = scale > 0.0 ? vector[i] / scale : 0.0;
    }
    std::vector<std::uint32_t> order(entry.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return entry[a] < entry[b]; });
    return order;
}

}  // namespace

Halves cut_in_half(const Graph& region, const PaperOptions& options, std::uint64_t seed,
                   StageClock& clock, const Executor& executor) {
    Halves halves;
    halves.pieces.piece_of_node.assign(region.num_nodes(), 0);
    halves.pieces.count = region.num_nodes() == 0 ? 0 : 1;
    const Measures all = measure(region);
    if (all.area_m2 < 2.0 * options.min_submap_m2 || region.num_nodes() < 3) return halves;
    clock.begin("eigen");
    EigenOptions eigen_options;
    eigen_options.seed = seed;
    const Eigenpairs pairs =
        smallest_eigenpairs(region, options.laplacian, kNumVectors, eigen_options, executor);
    halves.pieces.eigen.push_back({pairs.num_nodes, pairs.values, pairs.residuals});
    clock.begin("cluster");
    Split best;
    for (std::size_t j = 1; j < pairs.size(); ++j) {
        try_order(region, all, order_along(pairs, j), options.min_submap_m2, best);
    }
    if (best.side_of_node.empty()) return halves;
    halves.pieces.piece_of_node = connected_components(region, best.side_of_node);
    halves.pieces.count = 1 + *std::max_element(halves.pieces.piece_of_node.begin(),
                                                halves.pieces.piece_of_node.end());
    // As relation_per_m() of submaps.
    halves.relation_per_m = best.cut_weight / all.area_m2;
    return halves;
}

}  // namespace quadcut
