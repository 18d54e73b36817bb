// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/over_cut.hpp"

#include <utility>
#include <vector>

#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/k_means.hpp"
#include "quadcut/spectral/multilevel.hpp"
#include "quadcut/spectral/pivoted_qr.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kRefineSteps = 10;
/// A larger part is first cut into parts of about kNodesPerPart, without an eigenproblem of its
/// size.
constexpr std::size_t kMaxSolvedNodes = 65536;
constexpr std::size_t kNodesPerPart = 16384;

/// The nodes of each part, ascending.
std::vector<std::vector<std::uint32_t>> group_by_part(const std::vector<std::uint32_t>& part) {
    std::vector<std::vector<std::uint32_t>> groups;
    for (std::uint32_t node = 0; node < part.size(); ++node) {
        if (part[node] >= groups.size()) groups.resize(part[node] + 1);
        groups[part[node]].push_back(node);
    }
    return groups;
}

/// Pivoted QR and a few k-means steps.
std::vector<std::uint32_t> cluster_rows(const Eigenpairs& pairs, const Executor& executor) {
    const Embedding samples = embed(pairs, pairs.size());
    const Clustering start = cluster_pivoted_qr(samples, executor);
    return refine_k_means(samples, start, kRefineSteps, executor).clustering.labels;
}

}  // namespace

Pieces over_cut(const Graph& region, const OverCutOptions& options, StageClock& clock,
                const Executor& executor) {
    Pieces pieces;
    pieces.piece_of_node.assign(region.num_nodes(), 0);
    EigenOptions eigen_options;
    eigen_options.seed = options.seed;
    /// A part of the region that may have to be cut: its own graph, and its nodes in the region's.
    struct Part {
        Graph graph;
        std::vector<std::uint32_t> nodes;
    };
    std::vector<Part> waiting;
    for (auto& nodes : group_by_part(connected_components(region))) {
        waiting.push_back({induced_subgraph(region, nodes), std::move(nodes)});
    }
    while (!waiting.empty()) {
        const Part part = std::move(waiting.back());
        waiting.pop_back();
        clock.begin("eigen");
        std::vector<std::uint32_t> labels(part.nodes.size(), 0);
        bool found_all = false;
        if (part.nodes.size() > kMaxSolvedNodes) {
            labels = cut_multilevel(part.graph, options.laplacian, labels.size() / kNodesPerPart);
        } else {
            const Eigenpairs pairs =
                eigenpairs_below(part.graph, options.laplacian, options.max_eigenvalue_per_m2,
                                 options.max_pairs, eigen_options, executor);
            pieces.eigen.push_back({pairs.num_nodes, pairs.values, pairs.residuals});
            found_all = pairs.size() < options.max_pairs;
            clock.begin("cluster");
            if (pairs.size() >= 2) labels = cluster_rows(pairs, executor);
        }
        for (const auto& group : group_by_part(connected_components(part.graph, labels))) {
            std::vector<std::uint32_t> nodes;
            nodes.reserve(group.size());
            for (const std::uint32_t node : group) nodes.push_back(part.nodes[node]);
            // A cut that made no progress would be tried for ever.
            if (!found_all && group.size() < part.nodes.size()) {
                waiting.push_back({induced_subgraph(part.graph, group), std::move(nodes)});
                continue;
            }
            for (const std::uint32_t node : nodes) pieces.piece_of_node[node] = pieces.count;
            ++pieces.count;
        }
    }
    return pieces;
}

}  // namespace quadcut
