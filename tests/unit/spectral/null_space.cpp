// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/null_space.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/spectral/test_graphs.hpp"

namespace quadcut {
namespace {

constexpr LaplacianKind kAllKinds[] = {LaplacianKind::degree, LaplacianKind::unweighted,
                                       LaplacianKind::area};

TEST(NullSpace, DimensionIsTheNumberOfComponents) {
    const Graph rooms = test::floor_graph(test::room_plan(4, 2, 10, test::Doors::none));
    for (const LaplacianKind kind : kAllKinds) {
        const NullSpace space = find_null_space(Laplacian(rooms, kind));
        EXPECT_EQ(space.dimension, 8U);
        ASSERT_EQ(space.vectors.size(), 8 * rooms.num_nodes());
        for (std::size_t a = 0; a < 8; ++a) {
            for (std::size_t b = 0; b <= a; ++b) {
                const double* of_a = &space.vectors[a * space.num_nodes];
                const double* of_b = &space.vectors[b * space.num_nodes];
                const double dot = std::inner_product(of_a, of_a + space.num_nodes, of_b, 0.0);
                EXPECT_NEAR(dot, a == b ? 1.0 : 0.0, 1e-12);
            }
        }
    }
    EXPECT_EQ(find_null_space(Laplacian(Graph{}, LaplacianKind::degree)).dimension, 0U);
}

TEST(NullSpace, BasisIsARotationNotTheIndicators) {
    // What makes counting non-zero elements fail: a vector mixes the components.
    const Graph rooms = test::floor_graph(test::room_plan(2, 1, 6, test::Doors::none));
    const NullSpace space = find_null_space(Laplacian(rooms, LaplacianKind::degree));
    ASSERT_EQ(space.dimension, 2U);
    for (const double value : space.vectors) EXPECT_GT(std::abs(value), 1e-6);
}

TEST(NullSpace, ComponentsAsTheTraversalFindsThem) {
    Random random(31);
    for (int round = 0; round < 60; ++round) {
        const std::size_t num_nodes = 1 + random.below(150);
        const std::size_t num_groups = 1 + random.below(std::min<std::size_t>(num_nodes, 12));
        const Graph graph =
            test::random_graph(random, num_nodes, random.uniform(0.0, 2.0), num_groups);
        const auto expected = connected_components(graph);
        for (const LaplacianKind kind : kAllKinds) {
            EXPECT_EQ(components_from_null_space(graph, kind, random.bits()), expected)
                << "round " << round << ", kind " << static_cast<int>(kind);
        }
    }
}

TEST(NullSpace, ComponentsOfFloorPlans) {
    const Graph closed = test::floor_graph(test::room_plan(5, 4, 9, test::Doors::none));
    EXPECT_EQ(components_from_null_space(closed), connected_components(closed));
    const Graph open = test::floor_graph(test::room_plan(5, 4, 9, test::Doors::open));
    EXPECT_EQ(components_from_null_space(open), std::vector<std::uint32_t>(open.num_nodes(), 0));
}

TEST(NullSpace, LonelyNodesAndEdgesOfWeightZero) {
    const Graph graph =
        build_graph(std::vector<WeightedEdge>{{0, 3, 1.0}, {1, 1, 2.0}, {2, 4, 0.0}},
                    std::vector<double>(5, 1.0));
    for (const LaplacianKind kind : kAllKinds) {
        EXPECT_EQ(components_from_null_space(graph, kind),
                  (std::vector<std::uint32_t>{0, 1, 2, 0, 3}));
    }
    EXPECT_TRUE(components_from_null_space(Graph{}).empty());
}

TEST(NullSpace, WeakTiesAreTies) {
    // Two rooms joined by a millionth of an edge: one component, though hardly.
    std::vector<WeightedEdge> edges;
    const Graph rooms = test::disjoint_union({test::grid_graph(8, 8), test::grid_graph(8, 8)});
    for (std::uint32_t i = 0; i < rooms.num_nodes(); ++i) {
        for (const std::uint32_t other : rooms.neighbours(i)) {
            if (other > i) edges.push_back({i, other, 1.0});
        }
    }
    edges.push_back({63, 64, 1e-6});
    const Graph graph = build_graph(edges, rooms.area_m2);
    EXPECT_EQ(components_from_null_space(graph), connected_components(graph));
}

}  // namespace
}  // namespace quadcut
