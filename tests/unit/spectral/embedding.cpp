// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/embedding.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

/// Two vectors of three entries.
Eigenpairs two_pairs() {
    Eigenpairs pairs;
    pairs.num_nodes = 3;
    pairs.values = {0.0, 1.0};
    pairs.vectors = {3.0, 0.0, -1.0, 4.0, 0.0, 2.0};
    pairs.components = {0, 0};
    pairs.null_vector = {2.0, 1.0, 0.5};
    pairs.residuals = {0.0, 0.0};
    return pairs;
}

TEST(Embedding, RowsAreSamplesOfTheEigenvectors) {
    const Embedding samples = embed(two_pairs(), 2);
    EXPECT_EQ(samples.num_samples, 3U);
    EXPECT_EQ(samples.num_dims, 2U);
    EXPECT_EQ(samples.values, (std::vector<double>{3.0, 4.0, 0.0, 0.0, -1.0, 2.0}));
    EXPECT_EQ(samples.row(2)[1], 2.0);
}

TEST(Embedding, NoMoreColumnsThanPairs) {
    EXPECT_EQ(embed(two_pairs(), 7).num_dims, 2U);
    EXPECT_EQ(embed(two_pairs(), 1).values, (std::vector<double>{3.0, 0.0, -1.0}));
    EXPECT_EQ(embed(two_pairs(), 0).num_dims, 0U);
    EXPECT_EQ(embed(Eigenpairs{}, 4).num_samples, 0U);
}

TEST(Embedding, RowsDividedByTheNullVector) {
    const Embedding samples = embed(two_pairs(), 2, RowScaling::degree);
    EXPECT_EQ(samples.values, (std::vector<double>{1.5, 2.0, 0.0, 0.0, -2.0, 4.0}));
}

TEST(Embedding, RowsOfAComponentStartAlikeWhenTheyAreDivided) {
    // A path of three nodes and an edge: degrees 1, 3, 2 and 5, 5.
    const std::vector<WeightedEdge> edges{{0, 1, 1.0}, {1, 2, 2.0}, {3, 4, 5.0}};
    const Graph graph = build_graph(edges, {1.0, 2.0, 3.0, 4.0, 5.0});
    for (const LaplacianKind kind : {LaplacianKind::degree, LaplacianKind::area}) {
        const Embedding samples = embed(smallest_eigenpairs(graph, kind, 2), 2, RowScaling::degree);
        EXPECT_NEAR(samples.row(0)[0], samples.row(2)[0], 1e-9);
        EXPECT_NEAR(samples.row(1)[0], samples.row(2)[0], 1e-9);
        EXPECT_NEAR(samples.row(3)[1], samples.row(4)[1], 1e-9);
    }
}

TEST(Embedding, RowsOfLengthOneUnlessTheyAreZero) {
    const Embedding samples = embed(two_pairs(), 2, RowScaling::unit_length);
    EXPECT_DOUBLE_EQ(samples.row(0)[0], 0.6);
    EXPECT_DOUBLE_EQ(samples.row(0)[1], 0.8);
    EXPECT_EQ(samples.row(1)[0], 0.0);
    EXPECT_EQ(samples.row(1)[1], 0.0);
    EXPECT_DOUBLE_EQ(std::hypot(samples.row(2)[0], samples.row(2)[1]), 1.0);
}

}  // namespace
}  // namespace quadcut
