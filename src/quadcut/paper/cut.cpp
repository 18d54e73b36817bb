// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/cut.hpp"

#include <algorithm>
#include <utility>

#include "quadcut/spectral/contract.hpp"
#include "quadcut/spectral/eigengap.hpp"
#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/k_means.hpp"
#include "quadcut/spectral/silhouette.hpp"

namespace quadcut {
namespace {

/// Of the graph's basins, whose eigenvalues are those of the cuts between them.
std::size_t number_by_eigengap(const Graph& region, const PaperOptions& options,
                               const EigenOptions& eigen_options, const Executor& executor) {
    const Graph basins = contract(region, degree_basins(region));
    const Eigenpairs pairs =
        eigenpairs_below(basins, options.laplacian, 2.0 * options.max_eigenvalue,
                         basins.num_nodes(), eigen_options, executor);
    const auto num_below = [&](double limit) {
        return static_cast<std::size_t>(
            std::lower_bound(pairs.values.begin(), pairs.values.end(), limit) -
            pairs.values.begin());
    };
    const std::size_t least = std::max<std::size_t>(1, num_below(options.min_eigenvalue));
    return std::max(
        least, num_clusters_by_eigengap(pairs.values, least, num_below(options.max_eigenvalue)));
}

/// 0: to be chosen by silhouette.
std::size_t number_wanted(const Graph& region, const PaperOptions& options,
                          const EigenOptions& eigen_options, const Executor& executor) {
    if (options.num_submaps != 0 || options.number_by == NumberBy::silhouette) {
        return options.num_submaps;
    }
    return number_by_eigengap(region, options, eigen_options, executor);
}

}  // namespace

Pieces cut(const Graph& region, const PaperOptions& options, std::uint64_t seed, StageClock& clock,
           const Executor& executor) {
    Pieces pieces;
    if (region.num_nodes() == 0) return pieces;
    EigenOptions eigen_options;
    eigen_options.seed = seed;
    clock.begin("eigen");
    const std::size_t num_wanted = number_wanted(region, options, eigen_options, executor);
    const Eigenpairs pairs = smallest_eigenpairs(region, options.laplacian,
                                                 num_wanted != 0 ? num_wanted : options.max_submaps,
                                                 eigen_options, executor);
    pieces.eigen.push_back({pairs.num_nodes, pairs.values, pairs.residuals});

    clock.begin("cluster");
    Clustering clusters;
    if (num_wanted != 0) {
        KMeansOptions k_means;
        k_means.seed = seed;
        clusters = cluster_k_means(embed(pairs, num_wanted, options.row_scaling), num_wanted,
                                   k_means, executor)
                       .clustering;
    } else {
        ChooseOptions choose;
        choose.max_clusters = options.max_submaps;
        choose.scaling = options.row_scaling;
        choose.accept_score = options.min_silhouette;
        choose.max_attempts = 2;
        choose.k_means.num_starts = 3;
        choose.k_means.seed = seed;
        clusters = choose_num_clusters(pairs, choose, executor).clustering;
    }
    pieces.piece_of_node = connected_components(region, clusters.labels);
    pieces.count = 1 + *std::max_element(pieces.piece_of_node.begin(), pieces.piece_of_node.end());
    return pieces;
}

}  // namespace quadcut
