// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/k_means.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/spectral/test_samples.hpp"

namespace quadcut {
namespace {

using Rows = std::vector<std::vector<double>>;

Rows means_of(const Embedding& samples, const Clustering& clusters) {
    Rows means(clusters.num_clusters, std::vector<double>(samples.num_dims, 0.0));
    std::vector<double> sizes(clusters.num_clusters, 0.0);
    for (std::size_t i = 0; i < samples.num_samples; ++i) {
        sizes[clusters.labels[i]] += 1.0;
        for (std::size_t d = 0; d < samples.num_dims; ++d) {
            means[clusters.labels[i]][d] += samples.row(i)[d];
        }
    }
    for (std::size_t c = 0; c < means.size(); ++c) {
        for (double& value : means[c]) value /= sizes[c];
    }
    return means;
}

double squared(const Embedding& samples, std::size_t i, const std::vector<double>& mean) {
    double sum = 0.0;
    for (std::size_t d = 0; d < mean.size(); ++d) sum += std::pow(samples.row(i)[d] - mean[d], 2);
    return sum;
}

double inertia_of(const Embedding& samples, const Clustering& clusters) {
    const Rows means = means_of(samples, clusters);
    double sum = 0.0;
    for (std::size_t i = 0; i < samples.num_samples; ++i) {
        sum += squared(samples, i, means[clusters.labels[i]]);
    }
    return sum;
}

Clustering nearest_to(const Embedding& samples, const Rows& means) {
    Clustering clusters{std::vector<std::uint32_t>(samples.num_samples), means.size()};
    for (std::size_t i = 0; i < samples.num_samples; ++i) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::uint32_t c = 0; c < means.size(); ++c) {
            const double distance = squared(samples, i, means[c]);
            if (distance >= nearest) continue;
            nearest = distance;
            clusters.labels[i] = c;
        }
    }
    return clusters;
}

bool has_empty_cluster(const Clustering& clusters) {
    for (std::uint32_t c = 0; c < clusters.num_clusters; ++c) {
        if (std::count(clusters.labels.begin(), clusters.labels.end(), c) == 0) return true;
    }
    return false;
}

TEST(KMeans, FindsWellSeparatedHeaps) {
    Random random(41);
    for (const std::size_t num_blobs : {1U, 2U, 5U, 13U}) {
        const Embedding samples = test::blobs(1500, num_blobs, 5, 0.04, random);
        const KMeansResult result = cluster_k_means(samples, num_blobs);
        EXPECT_EQ(result.clustering.num_clusters, num_blobs);
        EXPECT_EQ(result.clustering.labels, test::blob_labels(1500, num_blobs));
        EXPECT_NEAR(result.inertia, inertia_of(samples, result.clustering), 1e-9);
    }
}

TEST(KMeans, BoundsDoNotChangeWhatLloydDoes) {
    Random random(42);
    int num_compared = 0;
    for (int round = 0; round < 40; ++round) {
        const Embedding samples =
            test::blobs(400, 1 + random.below(8), 1 + random.below(9), 0.3, random);
        Rows seeds(2 + random.below(12));
        for (auto& seed : seeds) {
            const auto row = samples.row(random.below(samples.num_samples));
            seed.assign(row.begin(), row.end());
        }
        const Clustering start = nearest_to(samples, seeds);
        if (has_empty_cluster(start)) continue;
        // Lloyd's algorithm without any bound.
        Clustering plain = start;
        for (std::size_t step = 0; step <= 12; ++step) {
            plain = nearest_to(samples, means_of(samples, plain));
            if (has_empty_cluster(plain)) break;
            const KMeansResult result = refine_k_means(samples, start, step);
            EXPECT_FALSE(has_empty_cluster(result.clustering));
            if (step == 0) continue;
            const KMeansResult before = refine_k_means(samples, start, step - 1);
            EXPECT_LE(result.inertia, before.inertia + 1e-9);
            // One step moves the means once, and the samples before and after.
            if (result.num_steps < step) break;
            EXPECT_NEAR(result.inertia, inertia_of(samples, plain), 1e-9 * result.inertia)
                << "round " << round << ", step " << step;
            ++num_compared;
        }
    }
    EXPECT_GT(num_compared, 100);
}

TEST(KMeans, EndsWhereEverySampleIsNearestToItsOwnMean) {
    Random random(5);
    Embedding samples{3000, 4, {}};
    for (std::size_t i = 0; i < 12000; ++i) samples.values.push_back(random.normal());
    const Clustering clusters = cluster_k_means(samples, 9, {1, 1000, 3}).clustering;
    std::vector<std::vector<double>> means(9, std::vector<double>(5, 0.0));
    for (std::size_t i = 0; i < 3000; ++i) {
        for (std::size_t d = 0; d < 4; ++d) means[clusters.labels[i]][d] += samples.row(i)[d];
        means[clusters.labels[i]][4] += 1.0;
    }
    for (std::size_t i = 0; i < 3000; ++i) {
        std::vector<double> squared(9, 0.0);
        for (std::size_t k = 0; k < 9; ++k) {
            for (std::size_t d = 0; d < 4; ++d) {
                squared[k] += std::pow(samples.row(i)[d] - means[k][d] / means[k][4], 2);
            }
        }
        ASSERT_NEAR(*std::min_element(squared.begin(), squared.end()), squared[clusters.labels[i]],
                    1e-9);
    }
}

TEST(KMeans, RefiningNeverMakesItWorse) {
    Random random(43);
    const Embedding samples = test::blobs(800, 6, 4, 0.35, random);
    Clustering start{test::blob_labels(800, 6), 6};
    double before = inertia_of(samples, start);
    for (std::size_t max_steps = 0; max_steps < 12; ++max_steps) {
        const KMeansResult result = refine_k_means(samples, start, max_steps);
        EXPECT_LE(result.inertia, before + 1e-9);
        EXPECT_LE(result.num_steps, max_steps);
        before = result.inertia;
    }
    EXPECT_EQ(refine_k_means(samples, start, 0).clustering.labels, start.labels);
}

TEST(KMeans, SameBySeedAndForAnyNumberOfThreads) {
    Random random(44);
    const Embedding samples = test::blobs(9000, 16, 6, 0.3, random);
    KMeansOptions options;
    options.seed = 7;
    const KMeansResult reference = cluster_k_means(samples, 16, options, {1});
    for (const int num_threads : {1, 2, 3, 8}) {
        const KMeansResult result = cluster_k_means(samples, 16, options, {num_threads});
        EXPECT_EQ(result.clustering.labels, reference.clustering.labels);
        EXPECT_EQ(result.inertia, reference.inertia);
        EXPECT_EQ(result.num_steps, reference.num_steps);
    }
    options.num_starts = 1;
    const KMeansResult one = cluster_k_means(samples, 16, options);
    EXPECT_GE(one.inertia, reference.inertia);
    options.seed = 8;
    EXPECT_NE(cluster_k_means(samples, 16, options).clustering.labels, one.clustering.labels);
}

TEST(KMeans, AsManyClustersAsSamples) {
    Random random(45);
    const Embedding samples = test::blobs(40, 40, 7, 0.1, random);
    const KMeansResult result = cluster_k_means(samples, 40);
    std::vector<std::uint32_t> each(40);
    std::iota(each.begin(), each.end(), 0U);
    EXPECT_EQ(result.clustering.labels, each);
    EXPECT_EQ(result.inertia, 0.0);
    EXPECT_EQ(cluster_k_means(samples, 100).clustering.num_clusters, 40U);
}

TEST(KMeans, RepeatedSamplesAreOneCluster) {
    Embedding samples{30, 2, {}};
    for (std::size_t i = 0; i < 30; ++i) {
        samples.values.push_back(static_cast<double>(i % 3));
        samples.values.push_back(1.0);
    }
    const KMeansResult result = cluster_k_means(samples, 8);
    EXPECT_EQ(result.clustering.num_clusters, 3U);
    EXPECT_EQ(result.clustering.labels, test::blob_labels(30, 3));
    EXPECT_EQ(result.inertia, 0.0);
}

TEST(KMeans, AnEmptyClusterGetsTheFarthestSample) {
    // The third cluster of the start has no sample, and its mean, the origin, is far from all.
    Embedding samples{6, 1, {10.0, 10.1, 10.2, 20.0, 20.1, 29.0}};
    const Clustering start{{0, 0, 0, 1, 1, 1}, 3};
    const KMeansResult result = refine_k_means(samples, start, 20);
    EXPECT_EQ(result.clustering.labels, (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 2}));
    EXPECT_EQ(result.clustering.num_clusters, 3U);
}

TEST(KMeans, NoSamplesNoDimensionsNoClusters) {
    EXPECT_EQ(cluster_k_means(Embedding{}, 3).clustering.num_clusters, 0U);
    EXPECT_EQ(refine_k_means(Embedding{}, Clustering{}, 3).clustering.num_clusters, 0U);
    const Embedding flat{5, 0, {}};
    EXPECT_EQ(cluster_k_means(flat, 3).clustering.labels, std::vector<std::uint32_t>(5, 0));
    const Embedding one{1, 1, {2.0}};
    EXPECT_THROW((void)cluster_k_means(one, 0), std::logic_error);
    EXPECT_THROW((void)refine_k_means(one, Clustering{{0, 0}, 1}, 1), std::logic_error);
    EXPECT_EQ(cluster_k_means(one, 4).clustering.num_clusters, 1U);
}

}  // namespace
}  // namespace quadcut
