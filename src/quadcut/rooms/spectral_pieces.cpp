// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/spectral_pieces.hpp"

#include <cstddef>
#include <cstdlib>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "quadcut/base/error.hpp"
#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/pivoted_qr.hpp"

namespace quadcut {
namespace {

/// A square of 3.1 m has its second eigenvalue here.
const double kMaxEigenvaluePerM2 = std::getenv("EM") ? std::atof(std::getenv("EM")) : 1.0;
/// Of one solve. Fewer make more solves, more make larger ones.
constexpr std::size_t kMaxPairs = 8;

/// A part of the graph that may have to be cut: its own graph, and its nodes in the whole one.
struct Part {
    Graph graph;
    std::vector<std::uint32_t> nodes;
};

/// The connected parts of a part whose nodes have labels.
std::vector<Part> connected_parts(const Part& whole, std::span<const std::uint32_t> labels) {
    const std::vector<std::uint32_t> part_of_node = connected_components(whole.graph, labels);
    std::vector<std::vector<std::uint32_t>> members;
    for (std::uint32_t node = 0; node < part_of_node.size(); ++node) {
        if (part_of_node[node] >= members.size()) members.resize(part_of_node[node] + 1);
        members[part_of_node[node]].push_back(node);
    }
    std::vector<Part> parts;
    for (std::vector<std::uint32_t>& nodes : members) {
        Graph graph = induced_subgraph(whole.graph, nodes);
        for (std::uint32_t& node : nodes) node = whole.nodes[node];
        parts.push_back({std::move(graph), std::move(nodes)});
    }
    return parts;
}

double area_m2(const Graph& graph) {
    return std::accumulate(graph.area_m2.begin(), graph.area_m2.end(), 0.0);
}

/// Eigenpairs below the limit. None where the eigensolver fails its checks: rooms are to be had of
/// basins alone.
Eigenpairs smooth_pairs(const Graph& graph, const Executor& executor) {
    try {
        // Eq. (4): L, normalised by area: so eigenvalues have a unit, and their limit is a size.
        return eigenpairs_below(graph, LaplacianKind::area, kMaxEigenvaluePerM2, kMaxPairs, {},
                                executor);
    } catch (const NumericalError&) {
        return {};
    }
}

void add_piece(const Part& part, Pieces& pieces) {
    for (const std::uint32_t node : part.nodes) pieces.piece_of_node[node] = pieces.count;
    ++pieces.count;
}

}  // namespace

Pieces cut_spectrally(const Graph& graph, double min_area_m2, const Executor& executor) {
    Pieces pieces;
    pieces.piece_of_node.assign(graph.num_nodes(), 0);
    Part whole{graph, std::vector<std::uint32_t>(graph.num_nodes())};
    std::iota(whole.nodes.begin(), whole.nodes.end(), 0U);
    std::vector<Part> waiting = connected_parts(whole, {});
    while (!waiting.empty()) {
        const Part part = std::move(waiting.back());
        waiting.pop_back();
        if (part.nodes.size() == 1 || area_m2(part.graph) < min_area_m2) {
            add_piece(part, pieces);
            continue;
        }
        const Eigenpairs pairs = smooth_pairs(part.graph, executor);
        if (pairs.size() == 0) {
            for (const std::uint32_t node : part.nodes) add_piece({{}, {node}}, pieces);
            continue;
        }
        pieces.eigen.push_back({pairs.num_nodes, pairs.values, pairs.residuals});
        // Eq. (5): they are the columns of P.
        // Eq. (6): its rows are clustered.
        const Clustering clusters =
            cluster_pivoted_qr(embed(pairs, pairs.size(), RowScaling::none), executor);
        for (Part& cluster : connected_parts(part, clusters.labels)) {
            // A cut that made no progress would be tried for ever.
            if (pairs.size() == kMaxPairs && cluster.nodes.size() < part.nodes.size()) {
                waiting.push_back(std::move(cluster));
            } else {
                add_piece(cluster, pieces);
            }
        }
    }
    return pieces;
}

}  // namespace quadcut
