// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/graph.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

using Columns = std::vector<std::uint32_t>;

TEST(Graph, RowsAreSortedSymmetricAndLoopsAreStoredOnce) {
    const std::vector<WeightedEdge> edges{{2, 0, 5.0}, {1, 1, 7.0}, {0, 1, 3.0}};
    const Graph graph = build_graph(edges, {1.0, 2.0, 4.0});
    EXPECT_EQ(graph.num_nodes(), 3U);
    EXPECT_EQ(graph.columns, (Columns{1, 2, 0, 1, 0}));
    EXPECT_EQ(graph.weights, (std::vector<double>{3, 5, 3, 7, 5}));
    EXPECT_EQ(graph.row_begin, (std::vector<std::size_t>{0, 2, 4, 5}));
    EXPECT_EQ(graph.area_m2, (std::vector<double>{1, 2, 4}));
}

TEST(Graph, EdgesOfOnePairAreAddedUp) {
    const std::vector<WeightedEdge> edges{{0, 1, 1.0}, {1, 0, 2.0}, {0, 0, 4.0}, {0, 0, 8.0}};
    const Graph graph = build_graph(edges, {1.0, 1.0});
    EXPECT_EQ(graph.columns, (Columns{0, 1, 0}));
    EXPECT_EQ(graph.weights, (std::vector<double>{12, 3, 3}));
}

TEST(Graph, RandomEdgesAgreeWithAMapOfPairs) {
    Random random(21);
    for (int round = 0; round < 50; ++round) {
        const auto num_nodes = static_cast<std::uint32_t>(1 + random.below(20));
        std::vector<WeightedEdge> edges;
        std::map<std::pair<std::uint32_t, std::uint32_t>, double> expected;
        for (std::uint64_t n = random.below(60); n > 0; --n) {
            const auto a = static_cast<std::uint32_t>(random.below(num_nodes));
            const auto b = static_cast<std::uint32_t>(random.below(num_nodes));
            const auto weight = static_cast<double>(1 + random.below(9));
            edges.push_back({a, b, weight});
            expected[{a, b}] += weight;
            if (a != b) expected[{b, a}] += weight;
        }
        const Graph graph = build_graph(edges, std::vector<double>(num_nodes, 1.0));
        ASSERT_EQ(graph.columns.size(), expected.size());
        auto entry = expected.begin();
        for (std::uint32_t node = 0; node < num_nodes; ++node) {
            for (std::size_t k = graph.row_begin[node]; k < graph.row_begin[node + 1]; ++k) {
                EXPECT_EQ(entry->first, std::make_pair(node, graph.columns[k]));
                EXPECT_EQ(entry->second, graph.weights[k]);
                ++entry;
            }
        }
    }
}

TEST(Graph, AnEdgeToNowhereIsRefused) {
    const std::vector<WeightedEdge> edges{{0, 2, 1.0}};
    EXPECT_THROW((void)build_graph(edges, {1.0, 1.0}), std::logic_error);
}

TEST(Graph, NoNodes) {
    const Graph graph = build_graph({}, {});
    EXPECT_EQ(graph.num_nodes(), 0U);
    EXPECT_TRUE(connected_components(graph).empty());
}

TEST(Graph, ComponentsAreNumberedByTheirFirstNode) {
    const std::vector<WeightedEdge> edges{{0, 3, 1.0}, {4, 1, 1.0}};
    const Graph graph = build_graph(edges, std::vector<double>(5, 1.0));
    EXPECT_EQ(connected_components(graph), (Columns{0, 1, 2, 0, 1}));
}

TEST(Graph, AnInducedSubgraphKeepsTheEdgesBetweenItsNodes) {
    const std::vector<WeightedEdge> edges{{0, 1, 1.0}, {1, 2, 2.0}, {2, 3, 3.0},
                                          {1, 3, 4.0}, {3, 3, 5.0}, {0, 4, 6.0}};
    const Graph graph = build_graph(edges, {1, 2, 3, 4, 5});
    const Graph sub = induced_subgraph(graph, Columns{1, 3});
    EXPECT_EQ(sub.columns, (Columns{1, 0, 1}));
    EXPECT_EQ(sub.weights, (std::vector<double>{4, 4, 5}));
    EXPECT_EQ(sub.area_m2, (std::vector<double>{2, 4}));
    EXPECT_EQ(induced_subgraph(graph, {}).num_nodes(), 0U);
    EXPECT_THROW((void)induced_subgraph(graph, Columns{3, 1}), std::logic_error);
    EXPECT_THROW((void)induced_subgraph(graph, Columns{5}), std::logic_error);
}

}  // namespace
}  // namespace quadcut
