// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/k_means.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kSamplesPerChunk = 2048;
/// Fewer samples are one thread's work: a step takes less time than threads take to meet.
constexpr std::size_t kMinSharedSamples = 16384;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t num_chunks(const Embedding& samples) {
    return (samples.num_samples + kSamplesPerChunk - 1) / kSamplesPerChunk;
}

/// Four sums side by side: as one sum, each addition would wait for the one before.
double squared_distance(std::span<const double> a, std::span<const double> b) {
    std::array<double, 4> sums{};
    const std::size_t even = a.size() / 4 * 4;
    for (std::size_t d = 0; d < even; d += 4) {
        for (std::size_t lane = 0; lane < 4; ++lane) {
            const double difference = a[d + lane] - b[d + lane];
            sums[lane] += difference * difference;
        }
    }
    double sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    for (std::size_t d = even; d < a.size(); ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
    return sum;
}

/// Means of clusters, one row a cluster, and the number of samples in each.
struct Means {
    std::size_t num_dims = 0;
    std::vector<double> values;
    std::vector<std::size_t> sizes;

    [[nodiscard]] std::span<const double> row(std::size_t cluster) const {
        return std::span(values).subspan(cluster * num_dims, num_dims);
    }
};

/// Sums chunk by chunk, in order. A cluster without samples has its mean in the origin.
Means means_of(const Embedding& samples, std::span<const std::uint32_t> labels,
               std::size_t num_clusters, const Executor& executor) {
    const std::size_t dims = samples.num_dims;
    std::vector<Means> parts(num_chunks(samples));
    const auto add_up = [&](std::size_t first, std::size_t last) {
        Means part{dims, std::vector<double>(num_clusters * dims, 0.0),
                   std::vector<std::size_t>(num_clusters, 0)};
        for (std::size_t i = first; i < last; ++i) {
            const auto row = samples.row(i);
            double* sum = part.values.data() + labels[i] * dims;
            for (std::size_t d = 0; d < dims; ++d) sum[d] += row[d];
            ++part.sizes[labels[i]];
        }
        parts[first / kSamplesPerChunk] = std::move(part);
    };
    parallel_for(executor, samples.num_samples, kSamplesPerChunk, add_up);
    Means means{dims, std::vector<double>(num_clusters * dims, 0.0),
                std::vector<std::size_t>(num_clusters, 0)};
    for (const Means& part : parts) {
        for (std::size_t k = 0; k < part.values.size(); ++k) means.values[k] += part.values[k];
        for (std::size_t c = 0; c < num_clusters; ++c) means.sizes[c] += part.sizes[c];
    }
    for (std::size_t c = 0; c < num_clusters; ++c) {
        const double size = static_cast<double>(std::max<std::size_t>(1, means.sizes[c]));
        for (std::size_t d = 0; d < dims; ++d) means.values[c * dims + d] /= size;
    }
    return means;
}

Executor executor_for(const Embedding& samples, const Executor& executor) {
    return samples.num_samples < kMinSharedSamples ? Executor{1} : executor;
}

double inertia_of(const Embedding& samples, std::span<const std::uint32_t> labels,
                  const Means& means) {
    double sum = 0.0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        sum += squared_distance(samples.row(i), means.row(labels[i]));
    }
    return sum;
}

/// Lloyd's steps with Hamerly's bounds: a sample whose own mean is surely nearer than any other, by
/// bounds that are kept from step to step, is not compared again.
class Lloyd {
public:
    Lloyd(const Embedding& samples, Means means, const Executor& executor)
        : samples_(samples),
          executor_(executor_for(samples, executor)),
          means_(std::move(means)),
          labels_(samples.num_samples, 0),
          upper_(samples.num_samples, kInfinity),
          lower_(samples.num_samples, 0.0) {}

    KMeansResult run(std::size_t max_steps) {
        bool changed = assign();
        KMeansResult result;
        while (changed && result.num_steps < max_steps) {
            ++result.num_steps;
            move_means();
            changed = assign();
        }
        fill_empty_clusters();
        result.clustering = numbered_by_first_sample(labels_, num_clusters());
        result.inertia = inertia_of(samples_, labels_, means_);
        return result;
    }

private:
    [[nodiscard]] std::size_t num_clusters() const { return means_.sizes.size(); }

    /// Half the distance from each mean to the nearest other one: a sample that close to a mean is
    /// in its cluster.
    [[nodiscard]] std::vector<double> safe_radii() const {
        std::vector<double> radii(num_clusters(), kInfinity);
        for (std::size_t a = 0; a < num_clusters(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                const double half = 0.5 * std::sqrt(squared_distance(means_.row(a), means_.row(b)));
                radii[a] = std::min(radii[a], half);
                radii[b] = std::min(radii[b], half);
            }
        }
        return radii;
    }

    /// Puts each sample into the cluster of its nearest mean, the first of equals. Whether any
    /// changed.
    bool assign() {
        const std::vector<double> safe = safe_radii();
        std::vector<std::uint8_t> changed(num_chunks(samples_), 0);
        const auto assign_chunk = [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                if (assign_sample(i, safe)) changed[first / kSamplesPerChunk] = 1;
            }
        };
        parallel_for(executor_, samples_.num_samples, kSamplesPerChunk, assign_chunk);
        return std::find(changed.begin(), changed.end(), 1) != changed.end();
    }

    bool assign_sample(std::size_t i, const std::vector<double>& safe) {
        const double bound = std::max(safe[labels_[i]], lower_[i]);
        const auto row = samples_.row(i);
        if (upper_[i] < bound) return false;
        if (upper_[i] < kInfinity) {
            upper_[i] = std::sqrt(squared_distance(row, means_.row(labels_[i])));
            if (upper_[i] < bound) return false;
        }
        double nearest = kInfinity;
        double second = kInfinity;
        std::uint32_t best = 0;
        for (std::uint32_t cluster = 0; cluster < num_clusters(); ++cluster) {
            const double squared = squared_distance(row, means_.row(cluster));
            if (squared < nearest) {
                second = nearest;
                nearest = squared;
                best = cluster;
            } else if (squared < second) {
                second = squared;
            }
        }
        const bool is_new = upper_[i] == kInfinity;
        upper_[i] = std::sqrt(nearest);
        lower_[i] = std::sqrt(second);
        return std::exchange(labels_[i], best) != best || is_new;
    }

    /// The bounds follow the moves of the means.
    void move_means() {
        Means moved = means_of(samples_, labels_, num_clusters(), executor_);
        if (std::find(moved.sizes.begin(), moved.sizes.end(), std::size_t{0}) !=
            moved.sizes.end()) {
            means_ = std::move(moved);
            fill_empty_clusters();
            std::fill(upper_.begin(), upper_.end(), kInfinity);
            return;
        }
        std::vector<double> distance(num_clusters());
        for (std::size_t c = 0; c < num_clusters(); ++c) {
            distance[c] = std::sqrt(squared_distance(means_.row(c), moved.row(c)));
        }
        const double farthest = *std::max_element(distance.begin(), distance.end());
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            upper_[i] += distance[labels_[i]];
            lower_[i] -= farthest;
        }
        means_ = std::move(moved);
    }

    /// Gives each empty cluster the sample that is farthest from its mean, unless every sample lies
    /// on its mean, and leaves the means those of the labels.
    void fill_empty_clusters() {
        means_ = means_of(samples_, labels_, num_clusters(), executor_);
        for (std::size_t c = 0; c < num_clusters(); ++c) {
            if (means_.sizes[c] > 0) continue;
            std::size_t farthest = 0;
            double largest = 0.0;
            for (std::size_t i = 0; i < labels_.size(); ++i) {
                if (means_.sizes[labels_[i]] < 2) continue;
                const double squared = squared_distance(samples_.row(i), means_.row(labels_[i]));
                if (squared > largest) {
                    largest = squared;
                    farthest = i;
                }
            }
            if (largest == 0.0) return;
            labels_[farthest] = static_cast<std::uint32_t>(c);
            means_ = means_of(samples_, labels_, num_clusters(), executor_);
        }
    }

    const Embedding& samples_;
    Executor executor_;
    Means means_;
    std::vector<std::uint32_t> labels_;
    /// Bounds of the distances to the own mean (above) and to the nearest other one (below); the
    /// upper one is infinite where nothing is known.
    std::vector<double> upper_;
    std::vector<double> lower_;
};

/// k-means++: each next mean is a sample drawn by its squared distance to the means so far. Fewer
/// means than asked for when every sample lies on one.
Means draw_means(const Embedding& samples, std::size_t num_clusters, Random& random,
                 const Executor& executor) {
    Means means{samples.num_dims, {}, {}};
    std::vector<double> nearest(samples.num_samples, kInfinity);
    std::vector<double> chunk_sums(num_chunks(samples));
    std::size_t chosen = random.below(samples.num_samples);
    while (means.sizes.size() < num_clusters) {
        const auto mean = samples.row(chosen);
        means.values.insert(means.values.end(), mean.begin(), mean.end());
        means.sizes.push_back(1);
        const auto measure = [&](std::size_t first, std::size_t last) {
            double sum = 0.0;
            for (std::size_t i = first; i < last; ++i) {
                nearest[i] = std::min(nearest[i], squared_distance(samples.row(i), mean));
                sum += nearest[i];
            }
            chunk_sums[first / kSamplesPerChunk] = sum;
        };
        parallel_for(executor, samples.num_samples, kSamplesPerChunk, measure);
        double total = 0.0;
        for (const double sum : chunk_sums) total += sum;
        if (!(total > 0.0)) break;
        double at = random.uniform() * total;
        for (std::size_t i = 0; i < samples.num_samples; ++i) {
            if (nearest[i] > 0.0) chosen = i;
            at -= nearest[i];
            if (at < 0.0) break;
        }
    }
    return means;
}

}  // namespace

KMeansResult cluster_k_means(const Embedding& samples, std::size_t num_clusters,
                             const KMeansOptions& options, const Executor& executor) {
    if (samples.num_samples == 0) return {};
    if (num_clusters == 0) throw std::logic_error("cluster_k_means: no clusters asked for");
    const Random streams(options.seed);
    KMeansResult best;
    for (std::size_t start = 0; start < std::max<std::size_t>(1, options.num_starts); ++start) {
        Random random = streams.fork(start);
        Means means = draw_means(samples, num_clusters, random, executor_for(samples, executor));
        KMeansResult result = Lloyd(samples, std::move(means), executor).run(options.max_steps);
        if (start == 0 || result.inertia < best.inertia) best = std::move(result);
    }
    return best;
}

KMeansResult refine_k_means(const Embedding& samples, const Clustering& start,
                            std::size_t max_steps, const Executor& executor) {
    if (start.labels.size() != samples.num_samples) {
        throw std::logic_error("refine_k_means: labels and samples differ in number");
    }
    if (samples.num_samples == 0) return {};
    Means means = means_of(samples, start.labels, start.num_clusters, executor);
    if (max_steps > 0) return Lloyd(samples, std::move(means), executor).run(max_steps);
    return {start, inertia_of(samples, start.labels, means), 0};
}

}  // namespace quadcut
