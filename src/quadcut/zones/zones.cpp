// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/zones.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/laplacian.hpp"
#include "quadcut/zones/conductance.hpp"
#include "quadcut/zones/zone_joiner.hpp"

namespace quadcut {
namespace {

/// An eigengap is looked for up to so many zones more than there are components.
constexpr std::size_t kMaxCutsByEigengap = 30;

/// The nodes in an order that does not depend on how they are numbered, as far as areas and weights
/// tell them apart.
std::vector<std::uint32_t> order_by_content(const Graph& graph) {
    const auto content = [&](std::uint32_t node) {
        const auto weights = graph.neighbour_weights(node);
        const double most =
            weights.empty() ? 0.0 : *std::max_element(weights.begin(), weights.end());
        return std::tuple(graph.area_m2[node], weights.size(), most);
    };
    std::vector<std::uint32_t> order(graph.num_nodes());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t p, std::uint32_t q) { return content(p) < content(q); });
    return order;
}

/// The graph whose node i is node order[i].
Graph in_order(const Graph& graph, std::span<const std::uint32_t> order) {
    std::vector<std::uint32_t> place(order.size());
    std::vector<double> area_m2;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        place[order[i]] = i;
        area_m2.push_back(graph.area_m2[order[i]]);
    }
    std::vector<WeightedEdge> edges;
    for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
        const auto neighbours = graph.neighbours(node);
        for (std::size_t k = 0; k < neighbours.size() && neighbours[k] <= node; ++k) {
            edges.push_back({place[node], place[neighbours[k]], graph.neighbour_weights(node)[k]});
        }
    }
    return build_graph(edges, std::move(area_m2));
}

std::size_t num_components(const Graph& graph) {
    const std::vector<std::uint32_t> component = connected_components(graph);
    return component.empty() ? 0 : 1 + *std::max_element(component.begin(), component.end());
}

/// (lambda_(k+1) - lambda_k) / lambda_(k+1) by k - 1.
std::vector<double> relative_gaps(std::span<const double> eigenvalues) {
    std::vector<double> gaps;
    for (std::size_t k = 1; k < eigenvalues.size(); ++k) {
        const double next = eigenvalues[k];
        gaps.push_back(next > 0.0 ? std::clamp((next - eigenvalues[k - 1]) / next, 0.0, 1.0) : 0.0);
    }
    return gaps;
}

/// The number of zones after which the largest gap comes; not the one after the zeros, which is
/// always there. One zone each where nothing is left to be cut.
std::size_t number_by_eigengap(std::span<const double> gaps, std::size_t num_components) {
    if (gaps.size() <= num_components) return num_components;
    const auto first = gaps.begin() + static_cast<std::ptrdiff_t>(num_components);
    return static_cast<std::size_t>(std::max_element(first, gaps.end()) - gaps.begin()) + 1;
}

/// Eqs. (5) and (6): the first eigenvectors as columns, each row divided by sqrt(d).
Embedding embed_rooms(const Graph& graph, const Eigenpairs& pairs, std::size_t num_dims) {
    Embedding samples = embed(pairs, num_dims, RowScaling::none);
    const Laplacian laplacian(graph, LaplacianKind::degree);
    for (std::size_t i = 0; i < samples.num_samples; ++i) {
        const double root = laplacian.null_vector()[i];
        if (root == 0.0) continue;
        for (std::size_t j = 0; j < samples.num_dims; ++j) {
            samples.values[i * samples.num_dims + j] /= root;
        }
    }
    return samples;
}

}  // namespace

Zones find_zones(const Graph& rooms, const ZoneOptions& options) {
    Zones zones;
    if (options.count == kNoZones || rooms.num_nodes() == 0) return zones;
    const std::vector<std::uint32_t> order = order_by_content(rooms);
    const Graph graph = in_order(rooms, order);
    const std::size_t least = num_components(graph);
    const std::size_t most = std::max(options.count, least + kMaxCutsByEigengap);
    // Eq. (4) of the graph of rooms.
    const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::degree, most + 1);
    zones.eigenvalues = pairs.values;
    zones.gaps = relative_gaps(pairs.values);
    const std::size_t wanted =
        options.count != 0 ? options.count : number_by_eigengap(zones.gaps, least);
    const std::size_t count = std::clamp(wanted, least, graph.num_nodes());
    const Clustering clusters = join_into_zones(graph, embed_rooms(graph, pairs, count), count);

    std::vector<std::uint32_t> cluster_of_room(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) cluster_of_room[order[i]] = clusters.labels[i];
    const Clustering numbered = numbered_by_first_sample(cluster_of_room, clusters.num_clusters);
    zones.count = static_cast<std::uint32_t>(numbered.num_clusters);
    for (const std::uint32_t zone : numbered.labels) zones.zone_of_room.push_back(zone + 1);
    return zones;
}

Zones find_zones(const Segmentation& segmentation, const Covisibility& seen,
                 const ZoneOptions& options) {
    if (options.count == kNoZones) return {};
    const bool is_by_scans = options.weights == ZoneWeights::covisibility && !seen.scans.empty();
    return find_zones(
        is_by_scans ? covisibility_graph(seen, segmentation) : conductance_graph(segmentation),
        options);
}

Zones find_zones(const Segmentation& segmentation, const ZoneOptions& options) {
    if (options.count == kNoZones) return {};
    return find_zones(conductance_graph(segmentation), options);
}

}  // namespace quadcut
