// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/contract.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/spectral/eigensolver.hpp"
#include "tests/unit/spectral/test_graphs.hpp"

namespace quadcut {
namespace {

using Labels = std::vector<std::uint32_t>;

TEST(Contract, BasinsClimbToTheLargestDegree) {
    // Degrees 1, 4, 3.5, 1.5, 5, 4: two summits, 1 and 4; node 2 goes to the higher side.
    const std::vector<WeightedEdge> edges{
        {0, 1, 1.0}, {1, 2, 3.0}, {2, 3, 0.5}, {3, 4, 1.0}, {4, 5, 4.0}};
    const Graph graph = build_graph(edges, std::vector<double>(6, 1.0));
    EXPECT_EQ(degree_basins(graph), (Labels{0, 0, 0, 1, 1, 1}));
}

TEST(Contract, EqualDegreesLeadToTheFirst) {
    const std::vector<WeightedEdge> ring{{0, 1, 1.0}, {1, 2, 1.0}, {2, 3, 1.0}, {3, 0, 1.0}};
    EXPECT_EQ(degree_basins(build_graph(ring, std::vector<double>(4, 1.0))), Labels(4, 0));
    EXPECT_EQ(degree_basins(build_graph({}, {1.0, 1.0})), (Labels{0, 1}));
    EXPECT_TRUE(degree_basins(Graph{}).empty());
}

TEST(Contract, SumsAreasWeightsAndDegrees) {
    const std::vector<WeightedEdge> edges{
        {0, 1, 1.0}, {1, 2, 2.0}, {0, 2, 3.0}, {2, 3, 4.0}, {3, 3, 0.5}};
    const Graph graph = build_graph(edges, {1.0, 2.0, 4.0, 8.0});
    const Graph small = contract(graph, Labels{0, 0, 1, 1});
    EXPECT_EQ(small.area_m2, (std::vector<double>{3.0, 12.0}));
    ASSERT_EQ(small.num_nodes(), 2U);
    // Inside the groups both directions count: 2 * 1; 2 * 4 and the loop. Between them 2 + 3.
    EXPECT_EQ(small.weights, (std::vector<double>{2.0, 5.0, 5.0, 8.5}));
}

TEST(Contract, NoEigenvalueIsBelowTheGraphs) {
    const Graph graph = test::floor_graph(test::room_plan(3, 2, 7, test::Doors::open));
    const Graph small = contract(graph, degree_basins(graph));
    ASSERT_GT(small.num_nodes(), 6U);
    const Eigenpairs whole = smallest_eigenpairs(graph, LaplacianKind::degree, 6);
    const Eigenpairs contracted = smallest_eigenpairs(small, LaplacianKind::degree, 6);
    for (std::size_t j = 0; j < 6; ++j) {
        EXPECT_GE(contracted.values[j], whole.values[j] - 1e-9);
    }
}

}  // namespace
}  // namespace quadcut
