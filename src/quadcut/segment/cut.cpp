// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/cut.hpp"

#include <algorithm>
#include <utility>

#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/k_means.hpp"
#include "quadcut/spectral/multilevel.hpp"
#include "quadcut/spectral/pivoted_qr.hpp"
#include "quadcut/spectral/silhouette.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kRefineSteps = 10;
/// A larger part is first cut into parts of about kNodesPerPart, without an eigenproblem of its
/// size.
constexpr std::size_t kMaxSolvedNodes = 65536;
constexpr std::size_t kNodesPerPart = 16384;

EigenReport report_of(const Eigenpairs& pairs) {
    return {pairs.num_nodes, pairs.values, pairs.residuals};
}

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

Pieces cut(const Graph& region, const CutOptions& options, StageClock& clock,
           const Executor& executor) {
    Pieces pieces;
    if (region.num_nodes() == 0) return pieces;
    const std::size_t num_pairs = options.num_pieces != 0 ? options.num_pieces : options.max_pieces;
    EigenOptions eigen_options;
    eigen_options.seed = options.seed;
    clock.begin("eigen");
    const Eigenpairs pairs =
        smallest_eigenpairs(region, options.laplacian, num_pairs, eigen_options, executor);
    pieces.eigen.push_back(report_of(pairs));

    clock.begin("cluster");
    Clustering clusters;
    if (options.num_pieces != 0) {
        KMeansOptions k_means;
        k_means.seed = options.seed;
        clusters = cluster_k_means(embed(pairs, options.num_pieces, options.row_scaling),
                                   options.num_pieces, k_means, executor)
                       .clustering;
    } else {
        ChooseOptions choose;
        choose.max_clusters = options.max_pieces;
        choose.scaling = options.row_scaling;
        choose.accept_score = options.min_silhouette;
        choose.max_attempts = 2;
        choose.k_means.num_starts = 3;
        choose.k_means.seed = options.seed;
        clusters = choose_num_clusters(pairs, choose, executor).clustering;
    }
    pieces.piece_of_node = connected_components(region, clusters.labels);
    pieces.count = 1 + *std::max_element(pieces.piece_of_node.begin(), pieces.piece_of_node.end());
    return pieces;
}

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
            pieces.eigen.push_back(report_of(pairs));
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
