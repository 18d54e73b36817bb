// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/spectral/embedding.hpp"

namespace quadcut {

struct KMeansOptions {
    /// Independent starts (k-means++, Arthur and Vassilvitskii 2007); the least inertia wins.
    std::size_t num_starts = 5;
    /// Lloyd steps of one start at most.
    std::size_t max_steps = 100;
    std::uint64_t seed = 1;
};

struct KMeansResult {
    Clustering clustering;
    /// Sum of squared distances of the samples to the means of their clusters.
    double inertia = 0.0;
    /// Lloyd steps of the start that won.
    std::size_t num_steps = 0;
};

/// k-means of the rows. Labels are numbered by first sample. There are fewer clusters than asked
/// for only if there are fewer distinct samples. Deterministic by seed, whatever the number of
/// threads. Cost: O(starts * steps * samples * clusters * dims) at worst, a small part of it in
/// practice (bounds of Hamerly 2010 skip most distances). Throws std::logic_error if num_clusters
/// is 0 while there are samples.
[[nodiscard]] KMeansResult cluster_k_means(const Embedding& samples, std::size_t num_clusters,
                                           const KMeansOptions& options = {},
                                           const Executor& executor = {});

/// At most `max_steps` Lloyd steps from the means of a given clustering; 0: the clustering as it
/// is. A cluster that runs empty gets the sample that is farthest from its mean. Throws
/// std::logic_error if labels and samples differ in number.
[[nodiscard]] KMeansResult refine_k_means(const Embedding& samples, const Clustering& start,
                                          std::size_t max_steps, const Executor& executor = {});

}  // namespace quadcut
