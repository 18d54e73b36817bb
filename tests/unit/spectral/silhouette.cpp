// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/silhouette.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/spectral/test_graphs.hpp"
#include "tests/unit/spectral/test_samples.hpp"

namespace quadcut {
namespace {

/// Rousseeuw's definition by squared distances, pair by pair.
std::vector<double> brute_force(const Embedding& samples, const Clustering& clusters) {
    const std::size_t count = samples.num_samples;
    std::vector<double> result(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        double a = std::numeric_limits<double>::infinity();
        double b = std::numeric_limits<double>::infinity();
        for (std::uint32_t c = 0; c < clusters.num_clusters; ++c) {
            double sum = 0.0;
            double others = 0.0;
            for (std::size_t j = 0; j < count; ++j) {
                if (j == i || clusters.labels[j] != c) continue;
                sum += test::squared_distance(samples, i, j);
                others += 1.0;
            }
            if (c == clusters.labels[i]) {
                a = others > 0.0 ? sum / others : -1.0;
            } else if (others > 0.0) {
                b = std::min(b, sum / others);
            }
        }
        if (a >= 0.0 && std::isfinite(b)) result[i] = (b - a) / std::max(a, b);
    }
    return result;
}

TEST(Silhouette, ByHand) {
    // Two pairs on a line, and one alone.
    const Embedding samples{5, 1, {0.0, 1.0, 10.0, 12.0, 20.0}};
    const auto values = silhouettes(samples, {{0, 0, 1, 1, 2}, 3});
    EXPECT_DOUBLE_EQ(values[0], (122.0 - 1.0) / 122.0);
    EXPECT_DOUBLE_EQ(values[1], (101.0 - 1.0) / 101.0);
    EXPECT_DOUBLE_EQ(values[2], (90.5 - 4.0) / 90.5);
    EXPECT_DOUBLE_EQ(values[3], (64.0 - 4.0) / 64.0);
    EXPECT_EQ(values[4], 0.0);
}

TEST(Silhouette, EqualsTheDefinition) {
    Random random(61);
    for (int round = 0; round < 20; ++round) {
        const std::size_t count = 3 + random.below(120);
        const std::size_t num_dims = 1 + random.below(7);
        const Embedding samples =
            test::blobs(count, 1 + random.below(6), num_dims, random.uniform(0.01, 0.5), random);
        Clustering clusters{{}, 2 + random.below(5)};
        for (std::size_t i = 0; i < count; ++i) {
            clusters.labels.push_back(
                static_cast<std::uint32_t>(random.below(clusters.num_clusters)));
        }
        const auto expected = brute_force(samples, clusters);
        const auto values = silhouettes(samples, clusters);
        ASSERT_EQ(values.size(), count);
        for (std::size_t i = 0; i < count; ++i) EXPECT_NEAR(values[i], expected[i], 1e-12);
        EXPECT_NEAR(
            mean_silhouette(samples, clusters),
            std::accumulate(expected.begin(), expected.end(), 0.0) / static_cast<double>(count),
            1e-12);
    }
}

TEST(Silhouette, OneClusterNoSamplesEqualSamples) {
    EXPECT_TRUE(silhouettes(Embedding{}, Clustering{}).empty());
    EXPECT_EQ(mean_silhouette(Embedding{}, Clustering{}), 0.0);
    const Embedding samples{3, 1, {1.0, 1.0, 1.0}};
    EXPECT_EQ(silhouettes(samples, {{0, 0, 0}, 1}), std::vector<double>(3, 0.0));
    EXPECT_EQ(silhouettes(samples, {{0, 0, 1}, 2}), std::vector<double>(3, 0.0));
    EXPECT_THROW((void)silhouettes(samples, {{0, 0}, 1}), std::logic_error);
    EXPECT_THROW((void)mean_silhouette(samples, {{0, 0}, 1}), std::logic_error);
}

TEST(Silhouette, SameForAnyNumberOfThreads) {
    Random random(63);
    const Embedding samples = test::blobs(1000, 6, 4, 0.3, random);
    const Clustering clusters{test::blob_labels(1000, 6), 6};
    const auto reference = silhouettes(samples, clusters);
    for (const int num_threads : {2, 3, 8}) {
        EXPECT_EQ(silhouettes(samples, clusters, {num_threads}), reference);
    }
}

/// Rooms behind doors of one cell.
Eigenpairs pairs_of_rooms(std::size_t per_row, std::size_t num_rows, std::size_t num_pairs) {
    const auto plan = test::room_plan(per_row, num_rows, 11, test::Doors::open);
    return smallest_eigenpairs(test::floor_graph(plan), LaplacianKind::degree, num_pairs);
}

TEST(Silhouette, ChoosesThePlantedNumber) {
    const Graph graph = test::floor_graph(
        {"......#......#......#......#......", "......#......#......#......#......",
         "..................................", "......#......#......#......#......",
         "......#......#......#......#......"});
    ChooseOptions options;
    options.max_clusters = 9;
    const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::degree, 9);
    const ChosenClustering chosen = choose_num_clusters(pairs, options);
    EXPECT_EQ(chosen.clustering.num_clusters, 5U);
    EXPECT_TRUE(chosen.accepted);
    EXPECT_EQ(chosen.scores.size(), 8U);
    options.accept_score = 0.9999;
    const ChosenClustering never = choose_num_clusters(pairs, options);
    EXPECT_FALSE(never.accepted);
    EXPECT_EQ(never.num_attempts, options.max_attempts);
    EXPECT_EQ(choose_num_clusters(Eigenpairs{}, options).clustering.num_clusters, 0U);
}

TEST(ChooseNumClusters, AsManyAsThereAreRooms) {
    for (const RowScaling scaling :
         {RowScaling::degree, RowScaling::none, RowScaling::unit_length}) {
        const Eigenpairs pairs = pairs_of_rooms(3, 2, 12);
        ChooseOptions options;
        options.scaling = scaling;
        const ChosenClustering chosen = choose_num_clusters(pairs, options);
        EXPECT_EQ(chosen.clustering.num_clusters, 6U);
        EXPECT_TRUE(chosen.accepted);
        EXPECT_EQ(chosen.num_attempts, 1U);
        ASSERT_EQ(chosen.scores.size(), 11U);
        EXPECT_EQ(std::max_element(chosen.scores.begin(), chosen.scores.end()),
                  chosen.scores.begin() + 4);
        EXPECT_NEAR(chosen.score, chosen.scores[4], 1e-9);
    }
}

TEST(ChooseNumClusters, ScoresAreThoseOfTheClusteringsOneByOne) {
    const Eigenpairs pairs = pairs_of_rooms(2, 2, 7);
    for (const RowScaling scaling :
         {RowScaling::degree, RowScaling::none, RowScaling::unit_length}) {
        ChooseOptions options;
        options.scaling = scaling;
        const ChosenClustering chosen = choose_num_clusters(pairs, options);
        ASSERT_EQ(chosen.scores.size(), 6U);
        for (std::size_t k = 2; k <= 7; ++k) {
            const Embedding samples = embed(pairs, k, scaling);
            const Clustering clusters = cluster_k_means(samples, k, options.k_means).clustering;
            EXPECT_NEAR(chosen.scores[k - 2], mean_silhouette(samples, clusters), 1e-12)
                << "k " << k;
        }
    }
}

TEST(ChooseNumClusters, StartsAgainWhileTheScoreIsTooLow) {
    const Eigenpairs pairs = pairs_of_rooms(3, 2, 8);
    ChooseOptions options;
    options.accept_score = 0.999;
    options.max_attempts = 4;
    const ChosenClustering chosen = choose_num_clusters(pairs, options);
    EXPECT_FALSE(chosen.accepted);
    EXPECT_EQ(chosen.num_attempts, 4U);
    EXPECT_GT(chosen.score, 0.5);
}

TEST(ChooseNumClusters, OnASampleOfTheNodes) {
    const Eigenpairs pairs = pairs_of_rooms(3, 2, 10);
    ASSERT_GT(pairs.num_nodes, 600U);
    ChooseOptions options;
    options.max_samples = 300;
    const ChosenClustering chosen = choose_num_clusters(pairs, options);
    EXPECT_EQ(chosen.clustering.num_clusters, 6U);
    EXPECT_EQ(chosen.clustering.labels.size(), pairs.num_nodes);
}

TEST(ChooseNumClusters, SameForAnyNumberOfThreads) {
    const Eigenpairs pairs = pairs_of_rooms(3, 2, 8);
    const ChosenClustering reference = choose_num_clusters(pairs);
    for (const int num_threads : {2, 3, 8}) {
        const ChosenClustering chosen = choose_num_clusters(pairs, {}, {num_threads});
        EXPECT_EQ(chosen.clustering.labels, reference.clustering.labels);
        EXPECT_EQ(chosen.scores, reference.scores);
    }
}

TEST(ChooseNumClusters, TooLittleToChooseFrom) {
    const ChosenClustering none = choose_num_clusters(Eigenpairs{});
    EXPECT_EQ(none.clustering.num_clusters, 0U);
    const Eigenpairs one = smallest_eigenpairs(test::path_graph(5), LaplacianKind::degree, 1);
    const ChosenClustering single = choose_num_clusters(one);
    EXPECT_EQ(single.clustering.num_clusters, 1U);
    EXPECT_EQ(single.clustering.labels, std::vector<std::uint32_t>(5, 0));
    EXPECT_TRUE(single.scores.empty());
    EXPECT_FALSE(single.accepted);
}

}  // namespace
}  // namespace quadcut
