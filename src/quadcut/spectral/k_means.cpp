// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/k_means.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kSamplesPerChunk = 2048;

double squared_distance(std::span<const double> a, const double* b) {
    double sum = 0.0;
    for (std::size_t d = 0; d < a.size(); ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
    return sum;
}

/// Lloyd's steps with Hamerly's bounds: a sample whose own mean is nearer than any other can be
/// (by the bounds that are kept from step to step) is not compared again.
class Lloyd {
public:
    Lloyd(const Embedding& samples, std::vector<double> means, const Executor& executor)
        : samples_(samples),
          executor_(executor),
          num_clusters_(means.size() / std::max<std::size_t>(1, samples.num_dims)),
          means_(std::move(means)),
          labels_(samples.num_samples, 0),
          upper_(samples.num_samples, std::numeric_limits<double>::max()),
          lower_(samples.num_samples, 0.0) {}

    /// Returns the steps taken: until no sample changes its cluster, or `max_steps`.
    std::size_t run(std::size_t max_steps) {
        assign();
        std::size_t step = 0;
        while (step < max_steps) {
            ++step;
            move_means();
            if (!assign()) break;
        }
        return step;
    }

    KMeansResult result(std::size_t num_steps) const {
        KMeansResult out;
        out.num_steps = num_steps;
        std::vector<std::uint32_t> number(num_clusters_, kUnseen);
        out.clustering.labels.resize(labels_.size());
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            std::uint32_t& own = number[labels_[i]];
            if (own == kUnseen) own = static_cast<std::uint32_t>(out.clustering.num_clusters++);
            out.clustering.labels[i] = own;
            out.inertia += squared_distance(samples_.row(i), mean(labels_[i]));
        }
        return out;
    }

private:
    static constexpr std::uint32_t kUnseen = static_cast<std::uint32_t>(-1);

    [[nodiscard]] const double* mean(std::size_t cluster) const {
        return &means_[cluster * samples_.num_dims];
    }

    /// Half the distance from each mean to the nearest other one: within it, a mean is the nearest.
    [[nodiscard]] std::vector<double> safe_radii() const {
        std::vector<double> radii(num_clusters_, std::numeric_limits<double>::max());
        for (std::size_t a = 0; a < num_clusters_; ++a) {
            for (std::size_t b = 0; b < num_clusters_; ++b) {
                if (a == b) continue;
                const double d =
                    std::sqrt(squared_distance(std::span(mean(a), samples_.num_dims), mean(b)));
                radii[a] = std::min(radii[a], 0.5 * d);
            }
        }
        return radii;
    }

    /// Puts each sample into the cluster of its nearest mean, the first of equals. Whether any
    /// changed.
    bool assign() {
        const std::vector<double> safe = safe_radii();
        const std::size_t num_chunks =
            (samples_.num_samples + kSamplesPerChunk - 1) / kSamplesPerChunk;
        std::vector<std::uint8_t> changed(num_chunks, 0);
        parallel_for(executor_, samples_.num_samples, kSamplesPerChunk,
                     [&](std::size_t first, std::size_t last) {
                         for (std::size_t i = first; i < last; ++i) {
                             if (assign_sample(i, safe)) changed[first / kSamplesPerChunk] = 1;
                         }
                     });
        return std::find(changed.begin(), changed.end(), 1) != changed.end();
    }

    bool assign_sample(std::size_t i, const std::vector<double>& safe) {
        const double bound = std::max(safe[labels_[i]], lower_[i]);
        if (upper_[i] < bound) return false;
        const auto row = samples_.row(i);
        upper_[i] = std::sqrt(squared_distance(row, mean(labels_[i])));
        if (upper_[i] < bound) return false;
        double nearest = std::numeric_limits<double>::max();
        double second = std::numeric_limits<double>::max();
        std::uint32_t best = 0;
        for (std::uint32_t cluster = 0; cluster < num_clusters_; ++cluster) {
            const double d = squared_distance(row, mean(cluster));
            if (d < nearest) {
                second = nearest;
                nearest = d;
                best = cluster;
            } else if (d < second) {
                second = d;
            }
        }
        upper_[i] = std::sqrt(nearest);
        lower_[i] = std::sqrt(second);
        return std::exchange(labels_[i], best) != best;
    }

    /// Means of the clusters, summed chunk by chunk in order; bounds follow the moves.
    void move_means() {
        const std::size_t dims = samples_.num_dims;
        const std::size_t num_chunks =
            (samples_.num_samples + kSamplesPerChunk - 1) / kSamplesPerChunk;
        std::vector<std::vector<double>> sums(num_chunks);
        parallel_for(executor_, samples_.num_samples, kSamplesPerChunk,
                     [&](std::size_t first, std::size_t last) {
                         std::vector<double>& sum = sums[first / kSamplesPerChunk];
                         sum.assign(num_clusters_ * (dims + 1), 0.0);
                         for (std::size_t i = first; i < last; ++i) {
                             double* own = &sum[labels_[i] * (dims + 1)];
                             const auto row = samples_.row(i);
                             for (std::size_t d = 0; d < dims; ++d) own[d] += row[d];
                             own[dims] += 1.0;
                         }
                     });
        std::vector<double> total(num_clusters_ * (dims + 1), 0.0);
        for (const auto& sum : sums) {
            for (std::size_t k = 0; k < total.size(); ++k) total[k] += sum[k];
        }
        std::vector<double> moved(num_clusters_, 0.0);
        for (std::size_t cluster = 0; cluster < num_clusters_; ++cluster) {
            const double* sum = &total[cluster * (dims + 1)];
            if (sum[dims] == 0.0) {
                restart_at_farthest_sample(cluster);
                return;
            }
            double squared = 0.0;
            for (std::size_t d = 0; d < dims; ++d) {
                double& value = means_[cluster * dims + d];
                const double next = sum[d] / sum[dims];
                squared += (next - value) * (next - value);
                value = next;
            }
            moved[cluster] = std::sqrt(squared);
        }
        const double farthest = *std::max_element(moved.begin(), moved.end());
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            upper_[i] += moved[labels_[i]];
            lower_[i] -= farthest;
        }
    }

    void restart_at_farthest_sample(std::size_t cluster) {
        std::size_t farthest = 0;
        double largest = -1.0;
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            const double d = squared_distance(samples_.row(i), mean(labels_[i]));
            if (d > largest) {
                largest = d;
                farthest = i;
            }
        }
        const auto row = samples_.row(farthest);
        std::copy(row.begin(), row.end(), &means_[cluster * samples_.num_dims]);
        // A mean has jumped: no bound holds any more.
        std::fill(upper_.begin(), upper_.end(), std::numeric_limits<double>::max());
        std::fill(lower_.begin(), lower_.end(), 0.0);
    }

    const Embedding& samples_;
    const Executor& executor_;
    std::size_t num_clusters_;
    std::vector<double> means_;
    std::vector<std::uint32_t> labels_;
    /// Bounds of the distances to the own mean (above) and to the nearest other one (below).
    std::vector<double> upper_;
    std::vector<double> lower_;
};

/// k-means++: each next mean is a sample drawn by its squared distance to the means so far. Fewer
/// means than asked for when all samples are means.
std::vector<double> draw_means(const Embedding& samples, std::size_t num_clusters, Random& random) {
    std::vector<double> means;
    std::vector<double> nearest(samples.num_samples, std::numeric_limits<double>::max());
    std::size_t chosen = random.below(samples.num_samples);
    for (std::size_t count = 0; count < num_clusters; ++count) {
        const auto row = samples.row(chosen);
        means.insert(means.end(), row.begin(), row.end());
        const double* mean = &means[count * samples.num_dims];
        double total = 0.0;
        for (std::size_t i = 0; i < samples.num_samples; ++i) {
            nearest[i] = std::min(nearest[i], squared_distance(samples.row(i), mean));
            total += nearest[i];
        }
        if (total == 0.0) break;
        double at = random.uniform() * total;
        for (chosen = 0; chosen + 1 < samples.num_samples; ++chosen) {
            at -= nearest[chosen];
            if (at < 0.0 && nearest[chosen] > 0.0) break;
        }
    }
    return means;
}

}  // namespace

KMeansResult cluster_k_means(const Embedding& samples, std::size_t num_clusters,
                             const KMeansOptions& options, const Executor& executor) {
    if (samples.num_samples == 0) return {};
    if (num_clusters == 0) throw std::logic_error("cluster_k_means: no clusters asked for");
    if (samples.num_dims == 0)
        return {{std::vector<std::uint32_t>(samples.num_samples, 0), 1}, 0.0, 0};
    KMeansResult best;
    best.inertia = std::numeric_limits<double>::max();
    const Random base(options.seed);
    for (std::size_t start = 0; start < std::max<std::size_t>(1, options.num_starts); ++start) {
        Random random = base.fork(start);
        Lloyd lloyd(samples, draw_means(samples, num_clusters, random), executor);
        const std::size_t num_steps = lloyd.run(options.max_steps);
        KMeansResult result = lloyd.result(num_steps);
        if (result.inertia < best.inertia) best = std::move(result);
    }
    return best;
}

KMeansResult refine_k_means(const Embedding& samples, const Clustering& start,
                            std::size_t max_steps, const Executor& executor) {
    if (start.labels.size() != samples.num_samples) {
        throw std::logic_error("refine_k_means: labels and samples differ in number");
    }
    if (samples.num_samples == 0) return {};
    const std::size_t dims = samples.num_dims;
    std::vector<double> means(start.num_clusters * dims, 0.0);
    std::vector<double> sizes(start.num_clusters, 0.0);
    for (std::size_t i = 0; i < samples.num_samples; ++i) {
        const auto row = samples.row(i);
        for (std::size_t d = 0; d < dims; ++d) means[start.labels[i] * dims + d] += row[d];
        sizes[start.labels[i]] += 1.0;
    }
    for (std::size_t k = 0; k < means.size(); ++k) means[k] /= std::max(1.0, sizes[k / dims]);
    if (max_steps == 0 || dims == 0) return {start, 0.0, 0};
    Lloyd lloyd(samples, std::move(means), executor);
    const std::size_t num_steps = lloyd.run(max_steps);
    return lloyd.result(num_steps);
}

}  // namespace quadcut
