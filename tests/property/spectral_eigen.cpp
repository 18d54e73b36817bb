// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/spectral/eigensolver.hpp"
#include "tests/unit/spectral/test_graphs.hpp"

namespace quadcut {
namespace {

constexpr LaplacianKind kAllKinds[] = {LaplacianKind::degree, LaplacianKind::unweighted,
                                       LaplacianKind::area};

/// A graph of any sort: loops, trees, several components, floor plans with furniture.
Graph any_graph(Random& random) {
    if (random.below(2) == 0) {
        const std::size_t num_nodes = 1 + random.below(260);
        return test::random_graph(random, num_nodes, random.uniform(0.0, 3.0),
                                  1 + random.below(std::min<std::size_t>(5, num_nodes)));
    }
    auto plan = test::room_plan(1 + random.below(4), 1 + random.below(3), 3 + random.below(8),
                                random.below(2) == 0 ? test::Doors::open : test::Doors::none);
    for (std::size_t i = random.below(12); i > 0; --i) {
        std::string& row = plan[random.below(plan.size())];
        row[random.below(row.size())] = '#';
    }
    return test::floor_graph(plan, random.uniform(0.01, 2.0));
}

TEST(SpectralProperty, EigenvaluesOfTheNormalisedKindsLieBetweenZeroAndTwo) {
    Random random(81);
    for (int round = 0; round < 25; ++round) {
        const Graph graph = any_graph(random);
        for (const LaplacianKind kind : {LaplacianKind::degree, LaplacianKind::unweighted}) {
            const Eigenpairs pairs = smallest_eigenpairs(graph, kind, graph.num_nodes());
            ASSERT_EQ(pairs.size(), graph.num_nodes());
            for (const double value : pairs.values) {
                EXPECT_GE(value, 0.0);
                EXPECT_LE(value, 2.0 + 1e-12);
            }
        }
    }
}

TEST(SpectralProperty, ZeroEigenvaluesAreTheComponents) {
    Random random(82);
    for (int round = 0; round < 40; ++round) {
        const Graph graph = any_graph(random);
        if (graph.num_nodes() == 0) continue;
        const auto component = connected_components(graph);
        const std::size_t num_components =
            1 + *std::max_element(component.begin(), component.end());
        for (const LaplacianKind kind : kAllKinds) {
            const double norm = Laplacian(graph, kind).norm_bound();
            const Eigenpairs pairs = eigenpairs_below(graph, kind, 1e-8 * norm, graph.num_nodes());
            EXPECT_EQ(pairs.size(), num_components);
        }
    }
}

TEST(SpectralProperty, EigenvaluesDoNotDependOnTheOrderOfTheNodes) {
    Random random(83);
    for (int round = 0; round < 20; ++round) {
        const Graph graph = any_graph(random);
        const Graph other =
            test::renamed(graph, test::random_permutation(random, graph.num_nodes()));
        const std::size_t count = 1 + random.below(40);
        for (const LaplacianKind kind : kAllKinds) {
            const Eigenpairs a = smallest_eigenpairs(graph, kind, count);
            const Eigenpairs b = smallest_eigenpairs(other, kind, count);
            ASSERT_EQ(a.size(), b.size());
            const double norm = Laplacian(graph, kind).norm_bound();
            for (std::size_t j = 0; j < a.size(); ++j) {
                EXPECT_NEAR(a.values[j], b.values[j], 1e-10 * norm) << "pair " << j;
            }
        }
    }
}

TEST(SpectralProperty, ScalingWeightsOrAreasScalesTheSpectrum) {
    Random random(84);
    for (int round = 0; round < 15; ++round) {
        const Graph graph = any_graph(random);
        Graph scaled = graph;
        for (double& weight : scaled.weights) weight *= 3.0;
        for (double& area : scaled.area_m2) area *= 0.5;
        for (const LaplacianKind kind : kAllKinds) {
            const double factor = kind == LaplacianKind::area ? 6.0 : 1.0;
            const Eigenpairs a = smallest_eigenpairs(graph, kind, 20);
            const Eigenpairs b = smallest_eigenpairs(scaled, kind, 20);
            const double norm = Laplacian(scaled, kind).norm_bound();
            for (std::size_t j = 0; j < a.size(); ++j) {
                EXPECT_NEAR(factor * a.values[j], b.values[j], 1e-10 * norm);
            }
        }
    }
}

TEST(SpectralProperty, AnEdgeMoreNeverLowersAnEigenvalue) {
    // Of the area kind: L grows by a positive semidefinite matrix (Weyl).
    Random random(85);
    for (int round = 0; round < 20; ++round) {
        const std::size_t num_nodes = 20 + random.below(150);
        const Graph graph = test::random_graph(random, num_nodes, 1.0, 1 + random.below(3));
        std::vector<WeightedEdge> edges;
        for (std::uint32_t i = 0; i < graph.num_nodes(); ++i) {
            const auto columns = graph.neighbours(i);
            const auto weights = graph.neighbour_weights(i);
            for (std::size_t k = 0; k < columns.size(); ++k) {
                if (columns[k] >= i) edges.push_back({i, columns[k], weights[k]});
            }
        }
        edges.push_back({test::node_id(random.below(num_nodes)),
                         test::node_id(random.below(num_nodes)), random.uniform(0.01, 2.0)});
        const Graph more = build_graph(edges, graph.area_m2);
        const Eigenpairs a = smallest_eigenpairs(graph, LaplacianKind::area, 30);
        const Eigenpairs b = smallest_eigenpairs(more, LaplacianKind::area, 30);
        const double norm = Laplacian(more, LaplacianKind::area).norm_bound();
        for (std::size_t j = 0; j < a.size(); ++j) {
            EXPECT_GE(b.values[j], a.values[j] - 1e-10 * norm);
        }
    }
}

TEST(SpectralProperty, MoreThanAskedForChangesNothing) {
    // The first pairs of a longer list are those of the shorter.
    Random random(86);
    for (int round = 0; round < 15; ++round) {
        const Graph graph = any_graph(random);
        const std::size_t count = 1 + random.below(20);
        for (const LaplacianKind kind : kAllKinds) {
            const Eigenpairs few = smallest_eigenpairs(graph, kind, count);
            const Eigenpairs many = smallest_eigenpairs(graph, kind, 3 * count);
            const double norm = Laplacian(graph, kind).norm_bound();
            ASSERT_LE(few.size(), many.size());
            for (std::size_t j = 0; j < few.size(); ++j) {
                EXPECT_NEAR(few.values[j], many.values[j], 1e-10 * norm);
            }
        }
    }
}

}  // namespace
}  // namespace quadcut
