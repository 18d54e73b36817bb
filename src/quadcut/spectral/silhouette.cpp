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

constexpr std::size_t kSamplesPerChunk = 32;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A clustering of the samples by their first `num_dims` dimensions.
struct Level {
    std::size_t num_dims = 0;
    Clustering clusters;
    std::vector<std::size_t> sizes;
};

Level make_level(const Embedding& samples, Clustering clusters) {
    Level level{samples.num_dims, std::move(clusters), {}};
    level.sizes.assign(level.clusters.num_clusters, 0);
    for (const std::uint32_t label : level.clusters.labels) ++level.sizes[label];
    return level;
}

double silhouette(std::uint32_t own, const std::vector<double>& sums,
                  const std::vector<std::size_t>& sizes) {
    if (sizes[own] < 2) return 0.0;
    // Eq. (7): a = mean distance to the other samples of the own cluster
    const double a = sums[own] / static_cast<double>(sizes[own] - 1);
    // Eq. (8): b = the least mean distance to another cluster
    double b = kInfinity;
    for (std::size_t cluster = 0; cluster < sums.size(); ++cluster) {
        if (cluster == own || sizes[cluster] == 0) continue;
        b = std::min(b, sums[cluster] / static_cast<double>(sizes[cluster]));
    }
    if (b == kInfinity) return 0.0;
    // Eq. (9): s = (b - a) / max(a, b)
    const double larger = std::max(a, b);
    return larger > 0.0 ? (b - a) / larger : 0.0;
}

/// Silhouettes of all samples at several levels, dimensions ascending. The distances of a sample to
/// all others grow from level to level by the dimensions that are added: so all levels together
/// cost little more than the last, and no matrix of distances is ever stored.
class LevelSilhouettes {
public:
    explicit LevelSilhouettes(const Embedding& samples)
        : num_samples_(samples.num_samples), columns_(samples.values.size()) {
        // Column by column, so that loops over samples are loops over memory.
        for (std::size_t i = 0; i < num_samples_; ++i) {
            const auto row = samples.row(i);
            for (std::size_t d = 0; d < row.size(); ++d) columns_[d * num_samples_ + i] = row[d];
        }
    }

    /// One list a level.
    [[nodiscard]] std::vector<std::vector<double>> compute(const std::vector<Level>& levels,
                                                           const Executor& executor) const {
        std::vector<std::vector<double>> result(levels.size());
        for (auto& list : result) list.resize(num_samples_);
        const auto work = [&](std::size_t first, std::size_t last) {
            std::vector<double> grown(num_samples_);
            std::vector<double> distances(num_samples_);
            std::vector<double> sums;
            for (std::size_t i = first; i < last; ++i) {
                std::fill(grown.begin(), grown.end(), 0.0);
                std::size_t num_dims = 0;
                for (std::size_t l = 0; l < levels.size(); ++l) {
                    const Level& level = levels[l];
                    for (; num_dims < level.num_dims; ++num_dims) {
                        add_dimension(num_dims, i, grown);
                    }
                    for (std::size_t j = 0; j < num_samples_; ++j) {
                        distances[j] = std::sqrt(grown[j]);
                    }
                    add_up(level, distances, sums);
                    result[l][i] = silhouette(level.clusters.labels[i], sums, level.sizes);
                }
            }
        };
        parallel_for(executor, num_samples_, kSamplesPerChunk, work);
        return result;
    }

private:
    /// Adds to squared distances from sample i.
    void add_dimension(std::size_t dim, std::size_t i, std::vector<double>& grown) const {
        const auto column = std::span(columns_).subspan(dim * num_samples_, num_samples_);
        const double own = column[i];
        for (std::size_t j = 0; j < num_samples_; ++j) {
            grown[j] += (column[j] - own) * (column[j] - own);
        }
    }

    /// Sums of distances by cluster. In lanes: neighbours tend to be in one cluster, and each sum
    /// would wait for the one before.
    static void add_up(const Level& level, const std::vector<double>& distances,
                       std::vector<double>& sums) {
        constexpr std::size_t kLanes = 4;
        const std::size_t num_clusters = level.sizes.size();
        sums.assign(kLanes * num_clusters, 0.0);
        for (std::size_t j = 0; j < distances.size(); ++j) {
            sums[kLanes * level.clusters.labels[j] + j % kLanes] += distances[j];
        }
        for (std::size_t c = 0; c < num_clusters; ++c) {
            const double* lane = &sums[kLanes * c];
            sums[c] = (lane[0] + lane[1]) + (lane[2] + lane[3]);
        }
        sums.resize(num_clusters);
    }

    std::size_t num_samples_;
    std::vector<double> columns_;
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
        draw_samples(pairs.num_nodes, options.silhouette.max_samples, options.silhouette.seed);
    std::vector<Level> levels(max_clusters + 1 - options.min_clusters);
    std::vector<double> scores(levels.size());
    // Scaled rows have other distances at each level.
    const bool is_scaled = options.scaling != RowScaling::none;
    parallel_for(executor, levels.size(), 1, [&](std::size_t i, std::size_t) {
        const std::size_t k = options.min_clusters + i;
        const Embedding part = rows_of(embed(pairs, k, options.scaling), chosen);
        levels[i] = make_level(part, cluster_k_means(part, k, options.k_means).clustering);
        if (is_scaled) scores[i] = mean_of(silhouettes(part, levels[i].clusters, executor));
    });
    if (is_scaled) return scores;
    const LevelSilhouettes all(rows_of(embed(pairs, max_clusters), chosen));
    const auto values = all.compute(levels, executor);
    std::transform(values.begin(), values.end(), scores.begin(), mean_of);
    return scores;
}

void check(const Embedding& samples, const Clustering& clusters) {
    if (clusters.labels.size() != samples.num_samples) {
        throw std::logic_error("silhouettes: labels and samples differ in number");
    }
}

}  // namespace

std::vector<double> silhouettes(const Embedding& samples, const Clustering& clusters,
                                const Executor& executor) {
    check(samples, clusters);
    return LevelSilhouettes(samples).compute({make_level(samples, clusters)}, executor)[0];
}

double mean_silhouette(const Embedding& samples, const Clustering& clusters,
                       const SilhouetteOptions& options, const Executor& executor) {
    check(samples, clusters);
    const std::vector<std::size_t> chosen =
        draw_samples(samples.num_samples, options.max_samples, options.seed);
    Clustering of_chosen{{}, clusters.num_clusters};
    for (const std::size_t i : chosen) of_chosen.labels.push_back(clusters.labels[i]);
    return mean_of(silhouettes(rows_of(samples, chosen), of_chosen, executor));
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
        const double score = mean_silhouette(samples, clusters, options.silhouette, executor);
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
