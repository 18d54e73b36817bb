// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/silhouette.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kSamplesPerChunk = 512;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The means of clusters, one row a cluster, and what the mean squared distance of a sample to the
/// members of a cluster needs besides its distance to the mean.
struct Spread {
    Embedding means;
    std::vector<double> sizes;
    /// Mean squared distances of the members to their mean.
    std::vector<double> variances;
};

double squared_distance(std::span<const double> a, std::span<const double> b) {
    double sum = 0.0;
    for (std::size_t d = 0; d < a.size(); ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
    return sum;
}

Spread spread_of(const Embedding& samples, const Clustering& clusters) {
    const std::size_t dims = samples.num_dims;
    const std::size_t count = clusters.num_clusters;
    Spread spread{{count, dims, std::vector<double>(count * dims, 0.0)},
                  std::vector<double>(count, 0.0),
                  std::vector<double>(count, 0.0)};
    for (std::size_t i = 0; i < samples.num_samples; ++i) {
        const std::uint32_t own = clusters.labels[i];
        const auto row = samples.row(i);
        for (std::size_t d = 0; d < dims; ++d) spread.means.values[own * dims + d] += row[d];
        spread.sizes[own] += 1.0;
    }
    for (std::size_t k = 0; k < spread.means.values.size(); ++k) {
        spread.means.values[k] /= std::max(1.0, spread.sizes[k / dims]);
    }
    for (std::size_t i = 0; i < samples.num_samples; ++i) {
        const std::uint32_t own = clusters.labels[i];
        spread.variances[own] +=
            squared_distance(samples.row(i), spread.means.row(own)) / spread.sizes[own];
    }
    return spread;
}

/// The mean squared distance of a sample to the members of a cluster is its squared distance to
/// their mean and their variance.
double silhouette(std::span<const double> sample, std::uint32_t own, const Spread& spread) {
    if (spread.sizes[own] < 2.0) return 0.0;
    double a = 0.0;
    double b = kInfinity;
    for (std::size_t cluster = 0; cluster < spread.sizes.size(); ++cluster) {
        if (spread.sizes[cluster] == 0.0) continue;
        const double distance =
            squared_distance(sample, spread.means.row(cluster)) + spread.variances[cluster];
        // Eq. (7): a = mean distance to the other samples of the own cluster
        if (cluster == own) a = distance * spread.sizes[own] / (spread.sizes[own] - 1.0);
        // Eq. (8): b = the least mean distance to another cluster
        if (cluster != own) b = std::min(b, distance);
    }
    if (b == kInfinity) return 0.0;
    // Eq. (9): s = (b - a) / max(a, b)
    const double larger = std::max(a, b);
    return larger > 0.0 ? (b - a) / larger : 0.0;
}

double mean_of(const std::vector<double>& values) {
    if (values.empty()) return 0.0;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// `count` of the numbers below `num_samples`, ascending; all of them if there are no more.
std::vector<std::size_t> draw_samples(std::size_t num_samples, std::size_t count,
                                      std::uint64_t seed) {
    std::vector<std::size_t> chosen(num_samples);
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    if (num_samples <= count) return chosen;
    Random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        std::swap(chosen[i], chosen[i + random.below(num_samples - i)]);
    }
    chosen.resize(count);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

Embedding rows_of(const Embedding& samples, const std::vector<std::size_t>& chosen) {
    Embedding rows{chosen.size(), samples.num_dims, {}};
    rows.values.reserve(chosen.size() * samples.num_dims);
    for (const std::size_t i : chosen) {
        const auto row = samples.row(i);
        rows.values.insert(rows.values.end(), row.begin(), row.end());
    }
    return rows;
}

/// The mean silhouette of k-means for each number of clusters, on a sample of the nodes.
std::vector<double> score_numbers(const Eigenpairs& pairs, std::size_t max_clusters,
                                  const ChooseOptions& options, const Executor& executor) {
    const std::vector<std::size_t> chosen =
        draw_samples(pairs.num_nodes, options.max_samples, options.k_means.seed);
    std::vector<double> scores(max_clusters + 1 - options.min_clusters);
    parallel_for(executor, scores.size(), 1, [&](std::size_t i, std::size_t) {
        const std::size_t k = options.min_clusters + i;
        const Embedding part = rows_of(embed(pairs, k, options.scaling), chosen);
        scores[i] = mean_silhouette(part, cluster_k_means(part, k, options.k_means).clustering);
    });
    return scores;
}

}  // namespace

std::vector<double> silhouettes(const Embedding& samples, const Clustering& clusters,
                                const Executor& executor) {
    if (clusters.labels.size() != samples.num_samples) {
        throw std::logic_error("silhouettes: labels and samples differ in number");
    }
    const Spread spread = spread_of(samples, clusters);
    std::vector<double> result(samples.num_samples);
    parallel_for(executor, result.size(), kSamplesPerChunk,
                 [&](std::size_t first, std::size_t last) {
                     for (std::size_t i = first; i < last; ++i) {
                         result[i] = silhouette(samples.row(i), clusters.labels[i], spread);
                     }
                 });
    return result;
}

double mean_silhouette(const Embedding& samples, const Clustering& clusters,
                       const Executor& executor) {
    return mean_of(silhouettes(samples, clusters, executor));
}

ChosenClustering choose_num_clusters(const Eigenpairs& pairs, const ChooseOptions& options,
                                     const Executor& executor) {
    ChosenClustering best;
    best.clustering = {std::vector<std::uint32_t>(pairs.num_nodes, 0),
                       std::min<std::size_t>(1, pairs.num_nodes)};
    const std::size_t max_clusters =
        std::min({options.max_clusters, pairs.size(), pairs.num_nodes});
    if (max_clusters < options.min_clusters) return best;
    best.scores = score_numbers(pairs, max_clusters, options, executor);
    const auto highest = std::max_element(best.scores.begin(), best.scores.end());
    const std::size_t num_clusters =
        options.min_clusters + static_cast<std::size_t>(highest - best.scores.begin());
    const Embedding samples = embed(pairs, num_clusters, options.scaling);
    KMeansOptions k_means = options.k_means;
    while (!best.accepted && best.num_attempts < std::max<std::size_t>(1, options.max_attempts)) {
        k_means.seed = options.k_means.seed + best.num_attempts;
        Clustering clusters = cluster_k_means(samples, num_clusters, k_means, executor).clustering;
        const double score = mean_silhouette(samples, clusters, executor);
        if (best.num_attempts == 0 || score > best.score) {
            best.clustering = std::move(clusters);
            best.score = score;
        }
        ++best.num_attempts;
        best.accepted = best.score >= options.accept_score;
    }
    return best;
}

}  // namespace quadcut
