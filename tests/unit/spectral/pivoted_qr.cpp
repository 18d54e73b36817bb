// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/pivoted_qr.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/spectral/eigensolver.hpp"
#include "tests/unit/spectral/test_graphs.hpp"
#include "tests/unit/spectral/test_samples.hpp"

namespace quadcut {
namespace {

/// Groups of nodes that hang together closely; edges between them are few and weak. Node i is in
/// group i % num_groups.
Graph planted_graph(std::size_t num_nodes, std::size_t num_groups, double weak, Random& random) {
    std::vector<WeightedEdge> edges;
    const auto add = [&](std::size_t a, std::size_t b, double weight) {
        if (a != b) edges.push_back({test::node_id(a), test::node_id(b), weight});
    };
    for (std::size_t i = 0; i < num_nodes; ++i) {
        for (int e = 0; e < 6; ++e) {
            const std::size_t other = random.below(num_nodes / num_groups) * num_groups;
            add(i, other + i % num_groups, 1.0);
        }
        add(i, random.below(num_nodes), weak);
    }
    return build_graph(edges, std::vector<double>(num_nodes, 1.0));
}

TEST(PivotedQr, FindsPlantedGroups) {
    Random random(51);
    for (const std::size_t num_groups : {2U, 5U, 12U}) {
        const std::size_t num_nodes = 60 * num_groups;
        const Graph graph = planted_graph(num_nodes, num_groups, 0.05, random);
        for (const LaplacianKind kind : {LaplacianKind::degree, LaplacianKind::area}) {
            const Eigenpairs pairs = smallest_eigenpairs(graph, kind, num_groups);
            const Clustering clusters = cluster_pivoted_qr(embed(pairs, num_groups));
            EXPECT_EQ(clusters.num_clusters, num_groups);
            EXPECT_EQ(clusters.labels, test::blob_labels(num_nodes, num_groups));
        }
    }
}

TEST(PivotedQr, RoomsWithDoorsAreTheClusters) {
    constexpr std::size_t kSide = 13;
    const auto plan = test::room_plan(4, 3, kSide, test::Doors::open);
    const Graph graph = test::floor_graph(plan);
    const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::area, 12);
    const Clustering clusters = cluster_pivoted_qr(embed(pairs, 12));
    EXPECT_EQ(clusters.num_clusters, 12U);
    // All cells of a room but those of the door are together, and no two rooms are.
    std::vector<std::uint32_t> room_label(12, 99);
    std::size_t node = 0;
    for (std::size_t y = 0; y < plan.size(); ++y) {
        for (std::size_t x = 0; x < plan[y].size(); ++x) {
            if (plan[y][x] == '#') continue;
            const std::uint32_t label = clusters.labels[node++];
            if (x % (kSide + 1) == 0 || y % (kSide + 1) == 0) continue;
            std::uint32_t& of_room = room_label[y / (kSide + 1) * 4 + x / (kSide + 1)];
            if (of_room == 99) of_room = label;
            EXPECT_EQ(label, of_room) << "cell " << x << ", " << y;
        }
    }
    for (std::size_t a = 0; a < 12; ++a) {
        for (std::size_t b = 0; b < a; ++b) EXPECT_NE(room_label[a], room_label[b]);
    }
}

TEST(PivotedQr, AnyRotationOfTheEmbeddingGivesTheSame) {
    Random random(52);
    const Graph graph = planted_graph(300, 5, 0.05, random);
    const Embedding samples = embed(smallest_eigenpairs(graph, LaplacianKind::degree, 5), 5);
    const Clustering reference = cluster_pivoted_qr(samples);
    for (int round = 0; round < 5; ++round) {
        Embedding turned = samples;
        for (int turn = 0; turn < 20; ++turn) {
            const std::size_t a = random.below(5);
            const std::size_t b = (a + 1 + random.below(4)) % 5;
            const double angle = random.uniform(0.0, 6.28);
            for (std::size_t i = 0; i < turned.num_samples; ++i) {
                double& first = turned.values[i * 5 + a];
                double& second = turned.values[i * 5 + b];
                const double old = first;
                first = std::cos(angle) * first - std::sin(angle) * second;
                second = std::sin(angle) * old + std::cos(angle) * second;
            }
        }
        EXPECT_EQ(cluster_pivoted_qr(turned).labels, reference.labels);
    }
}

TEST(PivotedQr, SameForAnyNumberOfThreads) {
    Random random(53);
    const Embedding samples = test::blobs(7000, 8, 6, 0.4, random);
    const Clustering reference = cluster_pivoted_qr(samples, {1});
    for (const int num_threads : {2, 3, 8}) {
        EXPECT_EQ(cluster_pivoted_qr(samples, {num_threads}).labels, reference.labels);
    }
}

TEST(PivotedQr, FewerClustersWhereTheRowsSpanLess) {
    // Rank 2 in four dimensions.
    Embedding samples{20, 4, {}};
    for (std::size_t i = 0; i < 20; ++i) {
        const double a = i % 2 == 0 ? 1.0 : 0.0;
        const double b = 1.0 - a;
        for (const double value : {a, a, b, 2.0 * b}) samples.values.push_back(value);
    }
    const Clustering clusters = cluster_pivoted_qr(samples);
    EXPECT_EQ(clusters.num_clusters, 2U);
    EXPECT_EQ(clusters.labels, test::blob_labels(20, 2));
}

TEST(PivotedQr, NothingToDistinguish) {
    EXPECT_EQ(cluster_pivoted_qr(Embedding{}).num_clusters, 0U);
    for (const Embedding& samples : {Embedding{4, 0, {}}, Embedding{4, 1, {0.0, 0.0, 0.0, 0.0}},
                                     Embedding{4, 1, {0.5, 0.5, 0.5, 0.5}}}) {
        const Clustering clusters = cluster_pivoted_qr(samples);
        EXPECT_EQ(clusters.num_clusters, 1U);
        EXPECT_EQ(clusters.labels, std::vector<std::uint32_t>(4, 0));
    }
    EXPECT_EQ(cluster_pivoted_qr(Embedding{1, 3, {1.0, 2.0, 3.0}}).num_clusters, 1U);
}

}  // namespace
}  // namespace quadcut
