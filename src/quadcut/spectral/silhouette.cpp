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

constexpr std::size_t kRowsPerChunk = 64;

/// Squared Euclidean distances between all pairs of samples, one dimension added at a time: what
/// the next number of clusters needs is the last one's and one eigenvector more.
class SquaredDistances {
public:
    SquaredDistances(std::size_t num_samples, const Executor& executor)
        : num_samples_(num_samples),
          executor_(executor),
          squared_(num_samples * num_samples, 0.0F) {}

    void add_dimension(const Embedding& samples, std::size_t dim) {
        std::vector<float> values(num_samples_);
        for (std::size_t i = 0; i < num_samples_; ++i) {
            values[i] = static_cast<float>(samples.row(i)[dim]);
        }
        parallel_for(executor_, num_samples_, kRowsPerChunk,
                     [&](std::size_t first, std::size_t last) {
                         for (std::size_t i = first; i < last; ++i) {
                             float* row = &squared_[i * num_samples_];
                             for (std::size_t j = 0; j < num_samples_; ++j) {
                                 const float difference = values[i] - values[j];
                                 row[j] += difference * difference;
                             }
                         }
                     });
    }

    [[nodiscard]] std::vector<double> silhouettes(const Clustering& clusters,
                                                  SampleDistance distance) const {
        std::vector<std::size_t> sizes(clusters.num_clusters, 0);
        for (const std::uint32_t label : clusters.labels) ++sizes[label];
        std::vector<double> out(num_samples_, 0.0);
        if (clusters.num_clusters < 2) return out;
        const double scale =
            distance == SampleDistance::gaussian ? -0.5 / mean_squared_distance() : 0.0;
        parallel_for(
            executor_, num_samples_, kRowsPerChunk, [&](std::size_t first, std::size_t last) {
                std::vector<double> sums(clusters.num_clusters);
                for (std::size_t i = first; i < last; ++i) {
                    std::fill(sums.begin(), sums.end(), 0.0);
                    const float* row = &squared_[i * num_samples_];
                    for (std::size_t j = 0; j < num_samples_; ++j) {
                        const auto squared = static_cast<double>(row[j]);
                        sums[clusters.labels[j]] +=
                            scale == 0.0 ? std::sqrt(squared) : 1.0 - std::exp(scale * squared);
                    }
                    out[i] = silhouette(clusters.labels[i], sums, sizes);
                }
            });
        return out;
    }

private:
    static double silhouette(std::uint32_t own, const std::vector<double>& sums,
                             const std::vector<std::size_t>& sizes) {
        if (sizes[own] < 2) return 0.0;
        // Eq. (7): a = mean distance to the other samples of the own cluster.
        const double a = sums[own] / static_cast<double>(sizes[own] - 1);
        // Eq. (8): b = the least mean distance to another cluster.
        double b = std::numeric_limits<double>::max();
        for (std::size_t cluster = 0; cluster < sums.size(); ++cluster) {
            if (cluster == own || sizes[cluster] == 0) continue;
            b = std::min(b, sums[cluster] / static_cast<double>(sizes[cluster]));
        }
        // Eq. (9): s = (b - a) / max(a, b)
        const double larger = std::max(a, b);
        return larger > 0.0 && larger < std::numeric_limits<double>::max() ? (b - a) / larger : 0.0;
    }

    [[nodiscard]] double mean_squared_distance() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < num_samples_; ++i) {
            const auto row = squared_.begin() + static_cast<std::ptrdiff_t>(i * num_samples_);
            sum += std::accumulate(row, row + static_cast<std::ptrdiff_t>(num_samples_), 0.0);
        }
        const auto n = static_cast<double>(num_samples_);
        return std::max(sum / std::max(1.0, n * (n - 1.0)), std::numeric_limits<double>::min());
    }

    std::size_t num_samples_;
    const Executor& executor_;
    std::vector<float> squared_;
};

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
    Embedding out{chosen.size(), samples.num_dims, {}};
    out.values.reserve(chosen.size() * samples.num_dims);
    for (const std::size_t i : chosen) {
        const auto row = samples.row(i);
        out.values.insert(out.values.end(), row.begin(), row.end());
    }
    return out;
}

Embedding first_dims(const Embedding& samples, std::size_t num_dims) {
    Embedding out{samples.num_samples, num_dims, {}};
    out.values.reserve(samples.num_samples * num_dims);
    for (std::size_t i = 0; i < samples.num_samples; ++i) {
        const auto row = samples.row(i).first(num_dims);
        out.values.insert(out.values.end(), row.begin(), row.end());
    }
    return out;
}

SquaredDistances distances_of(const Embedding& samples, const Executor& executor) {
    SquaredDistances distances(samples.num_samples, executor);
    for (std::size_t dim = 0; dim < samples.num_dims; ++dim) distances.add_dimension(samples, dim);
    return distances;
}

/// The mean silhouette for every number of clusters, on a sample of the nodes.
std::vector<double> score_numbers(const Eigenpairs& pairs, std::size_t max_clusters,
                                  const ChooseOptions& options, std::uint64_t seed,
                                  const Executor& executor) {
    const std::vector<std::size_t> chosen =
        draw_samples(pairs.num_nodes, options.silhouette.max_samples, options.silhouette.seed);
    const Embedding unscaled = rows_of(embed(pairs, max_clusters), chosen);
    const bool is_scaled = options.scaling != RowScaling::none;
    SquaredDistances distances(chosen.size(), executor);
    KMeansOptions k_means = options.k_means;
    k_means.seed = seed;
    std::vector<double> scores;
    std::size_t dims_added = 0;
    for (std::size_t k = options.min_clusters; k <= max_clusters; ++k) {
        const Embedding samples =
            is_scaled ? rows_of(embed(pairs, k, options.scaling), chosen) : first_dims(unscaled, k);
        const Clustering clusters = cluster_k_means(samples, k, k_means, executor).clustering;
        if (is_scaled) {
            // Scaled rows change with every dimension: nothing carries over.
            scores.push_back(mean_of(distances_of(samples, executor)
                                         .silhouettes(clusters, options.silhouette.distance)));
            continue;
        }
        for (; dims_added < k; ++dims_added) distances.add_dimension(unscaled, dims_added);
        scores.push_back(mean_of(distances.silhouettes(clusters, options.silhouette.distance)));
    }
    return scores;
}

}  // namespace

std::vector<double> silhouettes(const Embedding& samples, const Clustering& clusters,
                                SampleDistance distance, const Executor& executor) {
    if (clusters.labels.size() != samples.num_samples) {
        throw std::logic_error("silhouettes: labels and samples differ in number");
    }
    return distances_of(samples, executor).silhouettes(clusters, distance);
}

double mean_silhouette(const Embedding& samples, const Clustering& clusters,
                       const SilhouetteOptions& options, const Executor& executor) {
    if (clusters.labels.size() != samples.num_samples) {
        throw std::logic_error("mean_silhouette: labels and samples differ in number");
    }
    const std::vector<std::size_t> chosen =
        draw_samples(samples.num_samples, options.max_samples, options.seed);
    Clustering chosen_clusters{{}, clusters.num_clusters};
    for (const std::size_t i : chosen) chosen_clusters.labels.push_back(clusters.labels[i]);
    return mean_of(
        silhouettes(rows_of(samples, chosen), chosen_clusters, options.distance, executor));
}

ChosenClustering choose_num_clusters(const Eigenpairs& pairs, const ChooseOptions& options,
                                     const Executor& executor) {
    ChosenClustering best;
    best.clustering = {std::vector<std::uint32_t>(pairs.num_nodes, 0),
                       pairs.num_nodes == 0 ? std::size_t{0} : std::size_t{1}};
    const std::size_t max_clusters =
        std::min({options.max_clusters, pairs.size(), pairs.num_nodes});
    if (max_clusters < options.min_clusters) return best;
    best.score = -2.0;
    for (std::size_t attempt = 0; attempt < std::max<std::size_t>(1, options.max_attempts);
         ++attempt) {
        KMeansOptions k_means = options.k_means;
        k_means.seed = options.k_means.seed + attempt;
        const std::vector<double> scores =
            score_numbers(pairs, max_clusters, options, k_means.seed, executor);
        const auto highest = std::max_element(scores.begin(), scores.end());
        const std::size_t k =
            options.min_clusters + static_cast<std::size_t>(highest - scores.begin());
        const Embedding samples = embed(pairs, k, options.scaling);
        Clustering clusters = cluster_k_means(samples, k, k_means, executor).clustering;
        const double score = mean_silhouette(samples, clusters, options.silhouette, executor);
        if (score > best.score) {
            best.clustering = std::move(clusters);
            best.score = score;
            best.scores = scores;
        }
        best.num_attempts = attempt + 1;
        best.accepted = best.score >= options.accept_score;
        if (best.accepted) break;
    }
    return best;
}

}  // namespace quadcut
