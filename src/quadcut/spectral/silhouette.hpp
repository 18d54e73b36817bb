// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/k_means.hpp"

namespace quadcut {

/// Silhouettes (Rousseeuw 1987) of all samples by squared Euclidean distance, in [-1, 1]; 0 in a
/// cluster of one, and 0 when there is only one cluster. Eqs. (7), (8), (9). With squared distances
/// the mean distance to a cluster's members follows from their mean and variance, so that the cost
/// is O(samples * clusters * dims) and not O(samples^2 * dims). Throws std::logic_error if labels
/// and samples differ in number.
[[nodiscard]] std::vector<double> silhouettes(const Embedding& samples, const Clustering& clusters,
                                              const Executor& executor = {});

/// Their mean. 0 without samples.
[[nodiscard]] double mean_silhouette(const Embedding& samples, const Clustering& clusters,
                                     const Executor& executor = {});

struct ChooseOptions {
    /// Numbers of clusters that are tried; no more than there are eigenpairs.
    std::size_t min_clusters = 2;
    std::size_t max_clusters = 30;
    /// A clustering is accepted when its mean silhouette reaches this.
    double accept_score = 0.5;
    /// Sets of k-means starts for the chosen number in all; the best is kept if none is accepted.
    std::size_t max_attempts = 3;
    RowScaling scaling = RowScaling::none;
    KMeansOptions k_means;
    /// Of more nodes than this the number is chosen on a seeded sample of so many.
    std::size_t max_samples = 4000;
};

struct ChosenClustering {
    /// Of all nodes.
    Clustering clustering;
    /// Mean silhouette of it.
    double score = 0.0;
    /// Whether the score reached the threshold.
    bool accepted = false;
    std::size_t num_attempts = 0;
    /// Mean silhouette by number of clusters: scores[i] belongs to min_clusters + i.
    std::vector<double> scores;
};

/// Chooses the number of clusters k by the best mean silhouette of k-means in the first k
/// eigenvectors (the least such k), then clusters all nodes with it; starts k-means again while the
/// score stays below the threshold. Fewer pairs or nodes than min_clusters: one cluster, score 0.
/// Cost: k-means of the sample for each number.
[[nodiscard]] ChosenClustering choose_num_clusters(const Eigenpairs& pairs,
                                                   const ChooseOptions& options = {},
                                                   const Executor& executor = {});

}  // namespace quadcut
