// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/zones.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "quadcut/base/error.hpp"
#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/zones/conductance.hpp"
#include "quadcut/zones/zone_joiner.hpp"

namespace quadcut {
namespace {

// Where the number is to be found: zones have so many rooms on average,
constexpr std::size_t kMeanRooms = 8;
/// an eigenvalue from here on is of no cut between parts (that of a corridor's rooms is 1),
constexpr double kMaxEigenvalue = 0.15;
/// and there are so many cuts at most.
constexpr std::size_t kMaxCuts = 60;
/// Of gaps that are about alike, that of more zones counts.
constexpr double kFinerPower = 0.1;

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

/// By number of zones k, less 1: how much farther up the next frequency, the root of an eigenvalue,
/// is than in an even chain of zones, where they rise step by step: the largest gap between
/// eigenvalues themselves, relative or not, nearly always comes after the first or last of them.
/// The graph's zeros, one a component, are the beginning of the chain and tell nothing.
std::vector<double> gaps_of(std::span<const double> eigenvalues, std::size_t num_components) {
    std::vector<double> gaps(std::min(num_components, eigenvalues.size()), 0.0);
    for (std::size_t k = num_components + 1; k < eigenvalues.size(); ++k) {
        const auto cuts = static_cast<double>(k - num_components);
        gaps.push_back(std::sqrt(eigenvalues[k] / eigenvalues[k - 1]) * cuts / (cuts + 1.0) *
                       std::pow(cuts + 1.0, kFinerPower));
    }
    return gaps;
}

/// The number of zones with the largest gap, among those that are cuts of something.
std::size_t number_by_gap(const Zones& zones, std::size_t num_rooms, std::size_t num_components) {
    const std::size_t most =
        std::min(zones.gaps.size(), num_components + (num_rooms - num_components) / kMeanRooms);
    std::size_t best = num_components;
    for (std::size_t k = num_components + 1; k <= most; ++k) {
        if (zones.eigenvalues[k - 1] >= kMaxEigenvalue) break;
        if (best == num_components || zones.gaps[k - 1] > zones.gaps[best - 1]) best = k;
    }
    return best;
}

/// None where the eigensolver fails its checks: rooms are to be had without zones.
std::optional<Eigenpairs> checked_pairs(const Graph& graph, std::size_t count) {
    try {
        return smallest_eigenpairs(graph, LaplacianKind::degree, count);
    } catch (const NumericalError&) {
        return std::nullopt;
    }
}

}  // namespace

Zones find_zones(const Graph& rooms, const ZoneOptions& options) {
    Zones zones;
    if (options.count == kNoZones || rooms.num_nodes() == 0) return zones;
    const std::vector<std::uint32_t> order = order_by_content(rooms);
    const Graph graph = in_order(rooms, order);
    const std::size_t least = num_components(graph);
    const std::size_t most = std::max(options.count, least + kMaxCuts);
    // Eq. (4) of the graph of rooms.
    const std::optional<Eigenpairs> solved = checked_pairs(graph, most + 1);
    if (!solved) return zones;
    const Eigenpairs& pairs = *solved;
    zones.weights = options.weights;
    zones.eigenvalues = pairs.values;
    zones.gaps = gaps_of(pairs.values, least);
    const std::size_t wanted =
        options.count != 0 ? options.count : number_by_gap(zones, graph.num_nodes(), least);
    const std::size_t count = std::clamp(wanted, least, graph.num_nodes());
    // Eqs. (5) and (6): rows of the eigenvectors, divided by sqrt(d).
    const Clustering clusters =
        join_into_zones(graph, embed(pairs, count, RowScaling::degree), count);

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
    const Graph rooms =
        is_by_scans ? covisibility_graph(seen, segmentation) : conductance_graph(segmentation);
    return find_zones(
        joined_by_nearness(rooms, segmentation.rooms),
        {options.count, is_by_scans ? ZoneWeights::covisibility : ZoneWeights::conductance});
}

Zones find_zones(const Segmentation& segmentation, const ZoneOptions& options) {
    return find_zones(segmentation, {}, options);
}

}  // namespace quadcut
