// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/cut.hpp"

#include <algorithm>
#include <utility>

#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/k_means.hpp"
#include "quadcut/spectral/silhouette.hpp"

namespace quadcut {

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
    pieces.eigen.push_back({pairs.num_nodes, pairs.values, pairs.residuals});

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

}  // namespace quadcut
