// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/k_means.hpp"
#include "quadcut/spectral/null_space.hpp"
#include "quadcut/spectral/pivoted_qr.hpp"
#include "quadcut/spectral/silhouette.hpp"
#include "tests/unit/spectral/test_graphs.hpp"

namespace quadcut {
namespace {

/// `count` blobs of `size` samples in a plane, on a circle of radius 10; sample i is in blob
/// i % count.
Embedding blobs(std::size_t count, std::size_t size, double spread, std::uint64_t seed) {
    Random random(seed);
    Embedding out{count * size, 2, {}};
    for (std::size_t i = 0; i < out.num_samples; ++i) {
        const double angle =
            6.283185307179586 * static_cast<double>(i % count) / static_cast<double>(count);
        out.values.push_back(10.0 * std::cos(angle) + spread * random.normal());
        out.values.push_back(10.0 * std::sin(angle) + spread * random.normal());
    }
    return out;
}

/// Whether sample i has label i % count for every i.
void expect_round_robin(const Clustering& clusters, std::size_t count) {
    ASSERT_EQ(clusters.num_clusters, count);
    for (std::size_t i = 0; i < clusters.labels.size(); ++i) {
        ASSERT_EQ(clusters.labels[i], i % count) << "sample " << i;
    }
}

double distance(const Embedding& samples, std::size_t i, std::size_t j) {
    double squared = 0.0;
    for (std::size_t d = 0; d < samples.num_dims; ++d) {
        squared += std::pow(samples.row(i)[d] - samples.row(j)[d], 2);
    }
    return std::sqrt(squared);
}

TEST(Embedding, RowsAreSamplesOfTheEigenvectors) {
    Eigenpairs pairs;
    pairs.num_nodes = 3;
    pairs.values = {0.0, 1.0, 2.0};
    pairs.vectors = {1, 2, 2, 3, 0, 4, 5, 6, 7};
    EXPECT_EQ(embed(pairs, 2).values, (std::vector<double>{1, 3, 2, 0, 2, 4}));
    EXPECT_EQ(embed(pairs, 9).num_dims, 3U);
    const Embedding unit = embed(pairs, 2, RowScaling::unit_length);
    EXPECT_NEAR(unit.row(2)[0], 2.0 / std::sqrt(20.0), 1e-15);
    EXPECT_NEAR(unit.row(2)[1], 4.0 / std::sqrt(20.0), 1e-15);
}

TEST(KMeans, FindsBlobs) {
    for (const std::size_t count : {2U, 3U, 7U}) {
        const Embedding samples = blobs(count, 50, 0.3, count);
        const KMeansResult result = cluster_k_means(samples, count);
        expect_round_robin(result.clustering, count);
        EXPECT_LT(result.inertia / static_cast<double>(samples.num_samples), 0.3);
    }
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

TEST(KMeans, ThreadsAndRepetitionDoNotChangeAByte) {
    const Embedding samples = blobs(5, 3000, 4.0, 9);
    const KMeansResult one = cluster_k_means(samples, 5, {}, {1});
    for (const int num_threads : {1, 2, 3, 8}) {
        const KMeansResult many = cluster_k_means(samples, 5, {}, {num_threads});
        EXPECT_EQ(many.clustering.labels, one.clustering.labels);
        EXPECT_EQ(many.inertia, one.inertia);
    }
}

TEST(KMeans, OddInputs) {
    EXPECT_EQ(cluster_k_means(Embedding{}, 3).clustering.num_clusters, 0U);
    EXPECT_THROW((void)cluster_k_means(blobs(2, 2, 0.0, 1), 0), std::logic_error);
    // Two distinct samples make two clusters at most.
    const Embedding two{4, 1, {1.0, 5.0, 1.0, 5.0}};
    EXPECT_EQ(cluster_k_means(two, 3).clustering.labels, (std::vector<std::uint32_t>{0, 1, 0, 1}));
}

TEST(KMeans, RefiningStartsFromWhatIsGiven) {
    const Embedding samples = blobs(3, 40, 0.3, 2);
    Clustering start{std::vector<std::uint32_t>(120), 3};
    for (std::size_t i = 0; i < 120; ++i) {
        start.labels[i] = static_cast<std::uint32_t>(i % 10 == 0 ? 0 : i % 3);
    }
    expect_round_robin(refine_k_means(samples, start, 20).clustering, 3);
    EXPECT_EQ(refine_k_means(samples, start, 0).clustering.labels, start.labels);
}

TEST(PivotedQr, FindsThePartsOfAPlantedPartition) {
    // Four rooms behind narrow doors, and eight without any.
    std::vector<std::string> plan;
    for (int y = 0; y < 6; ++y) {
        plan.emplace_back(y == 3 ? "..........................." : "......#......#......#......");
    }
    const Graph graph = test::floor_graph(plan);
    const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::area, 4);
    const Clustering clusters = cluster_pivoted_qr(embed(pairs, 4));
    EXPECT_EQ(clusters.num_clusters, 4U);
    for (std::size_t room = 0; room < 4; ++room) {
        const std::uint32_t label = clusters.labels[room * 6 + room * 1 - (room > 0 ? room : 0)];
        for (std::size_t x = 1; x < 5; ++x) EXPECT_EQ(clusters.labels[room * 6 + x], label);
    }
    for (const int num_threads : {2, 3}) {
        EXPECT_EQ(cluster_pivoted_qr(embed(pairs, 4), {num_threads}).labels, clusters.labels);
    }
}

TEST(PivotedQr, OddInputs) {
    EXPECT_EQ(cluster_pivoted_qr(Embedding{}).num_clusters, 0U);
    EXPECT_EQ(cluster_pivoted_qr(Embedding{3, 2, std::vector<double>(6, 0.0)}).num_clusters, 1U);
    // One direction only: one cluster, though two columns.
    EXPECT_EQ(cluster_pivoted_qr(Embedding{3, 2, {1, 1, 2, 2, 3, 3}}).num_clusters, 1U);
}

TEST(Silhouette, EqualsTheDefinition) {
    Random random(11);
    Embedding samples{60, 3, {}};
    for (int i = 0; i < 180; ++i) samples.values.push_back(random.normal());
    Clustering clusters{std::vector<std::uint32_t>(60), 5};
    for (std::uint32_t& label : clusters.labels) {
        label = static_cast<std::uint32_t>(random.below(4));
    }
    clusters.labels[17] = 4;  // alone
    const std::vector<double> found = silhouettes(samples, clusters);
    for (std::size_t i = 0; i < 60; ++i) {
        std::vector<double> sum(5, 0.0);
        std::vector<double> count(5, 0.0);
        for (std::size_t j = 0; j < 60; ++j) {
            if (j == i) continue;
            sum[clusters.labels[j]] += distance(samples, i, j);
            count[clusters.labels[j]] += 1.0;
        }
        const std::uint32_t own = clusters.labels[i];
        double b = 1e30;
        for (std::size_t k = 0; k < 5; ++k) {
            if (k != own) b = std::min(b, sum[k] / count[k]);
        }
        const double a = sum[own] / count[own];
        const double expected = own == 4 ? 0.0 : (b - a) / std::max(a, b);
        ASSERT_NEAR(found[i], expected, 1e-5) << "sample " << i;
    }
}

TEST(Silhouette, TheGaussianDistanceStaysInRangeAndOrdersAlike) {
    const Embedding samples = blobs(4, 30, 0.5, 3);
    Clustering clusters{std::vector<std::uint32_t>(120), 4};
    for (std::size_t i = 0; i < 120; ++i) clusters.labels[i] = static_cast<std::uint32_t>(i % 4);
    for (const double s : silhouettes(samples, clusters, SampleDistance::gaussian)) {
        EXPECT_GT(s, 0.5);
        EXPECT_LE(s, 1.0);
    }
    clusters.labels[0] = 1;
    EXPECT_LT(silhouettes(samples, clusters, SampleDistance::gaussian)[0], 0.0);
}

TEST(Silhouette, ASampleOfTheSamplesScoresAboutTheSame) {
    const Embedding samples = blobs(3, 400, 1.5, 8);
    const Clustering clusters = cluster_k_means(samples, 3).clustering;
    SilhouetteOptions some;
    some.max_samples = 300;
    EXPECT_NEAR(mean_silhouette(samples, clusters, some), mean_silhouette(samples, clusters), 0.03);
    const Clustering one{std::vector<std::uint32_t>(1200, 0), 1};
    EXPECT_EQ(mean_silhouette(samples, one), 0.0);
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

TEST(NullSpace, TellsTheComponentsLikeATraversal) {
    Random random(21);
    for (int round = 0; round < 20; ++round) {
        const std::size_t num_nodes = 1 + random.below(60);
        std::vector<WeightedEdge> edges;
        for (std::size_t i = 0; i < num_nodes; ++i) {
            edges.push_back({static_cast<std::uint32_t>(random.below(num_nodes)),
                             static_cast<std::uint32_t>(random.below(num_nodes)),
                             random.uniform(0.5, 2.0)});
        }
        const Graph graph = build_graph(edges, std::vector<double>(num_nodes, 1.0));
        for (const LaplacianKind kind : {LaplacianKind::degree, LaplacianKind::area}) {
            EXPECT_EQ(components_from_null_space(graph, kind), connected_components(graph));
        }
    }
}

TEST(NullSpace, EightEqualRoomsHaveEightDimensions) {
    const Graph graph = test::floor_graph({"...#...#...#...", "...#...#...#...", "###############",
                                           "...#...#...#...", "...#...#...#..."});
    const Laplacian laplacian(graph, LaplacianKind::degree);
    const NullSpace space = find_null_space(laplacian);
    EXPECT_EQ(space.dimension, 8U);
    EXPECT_EQ(space.vectors.size(), 8U * graph.num_nodes());
    EXPECT_EQ(find_null_space(Laplacian(Graph{}, LaplacianKind::degree)).dimension, 0U);
}

}  // namespace
}  // namespace quadcut
