// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/position_clusters.hpp"

#include <algorithm>

#include "quadcut/paper/line_of_sight.hpp"
#include "quadcut/spectral/k_means.hpp"

namespace quadcut::reproduce {

std::vector<std::uint32_t> cluster_positions(const LeafTable& table, std::span<const LeafId> nodes,
                                             std::size_t num_clusters, std::uint64_t seed) {
    if (nodes.empty()) return {};
    Embedding centres;
    centres.num_samples = nodes.size();
    centres.num_dims = 2;
    for (const LeafId id : nodes) {
        const HalfCell at = centre(table.leaf(id));
        centres.values.push_back(static_cast<double>(at.x));
        centres.values.push_back(static_cast<double>(at.y));
    }
    KMeansOptions options;
    options.seed = seed;
    return cluster_k_means(centres, std::max<std::size_t>(1, num_clusters), options)
        .clustering.labels;
}

}  // namespace quadcut::reproduce
