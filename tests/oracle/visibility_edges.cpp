// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/paper/visibility.hpp"
#include "tests/oracle/visibility_oracle.hpp"
#include "tests/unit/paper/small_map.hpp"

/// The edges against a look at every pair of leaves.
namespace quadcut {
namespace {

constexpr double kResolution = 0.05;

double centre_distance(const Leaf& a, const Leaf& b) {
    const HalfCell p = centre(a);
    const HalfCell q = centre(b);
    return std::hypot(static_cast<double>(p.x - q.x), static_cast<double>(p.y - q.y)) / 2.0;
}

std::vector<WeightedEdge> all_sight_pairs(const test::States& states, const LeafTable& table,
                                          const std::vector<LeafId>& nodes) {
    std::vector<WeightedEdge> edges;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        for (std::uint32_t j = 0; j < nodes.size(); ++j) {
            const Leaf& a = table.leaf(nodes[i]);
            const Leaf& b = table.leaf(nodes[j]);
            const bool coarser = a.level > b.level || (a.level == b.level && i < j);
            // The paper's own form, with the root's side and layers.
            const double root_m = table.root().side_cells() * kResolution;
            const double cells_a = std::pow(2.0, table.root().level - a.level);
            const double cells_b = std::pow(2.0, table.root().level - b.level);
            const double threshold_m = 1.05 * root_m * (cells_a + cells_b) / (cells_a * cells_b);
            if (!coarser || centre_distance(a, b) * kResolution > threshold_m ||
                !test::slow_line_of_sight(states, centre(a), centre(b))) {
                continue;
            }
            edges.push_back({i, j, root_m / (cells_a + cells_b)});
        }
    }
    return edges;
}

void expect_equal(const std::vector<WeightedEdge>& edges,
                  const std::vector<WeightedEdge>& expected) {
    ASSERT_EQ(edges.size(), expected.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        ASSERT_EQ(edges[i].a, expected[i].a);
        ASSERT_EQ(edges[i].b, expected[i].b);
        ASSERT_NEAR(edges[i].weight, expected[i].weight, 1e-12);
    }
}

/// Every leaf, or now and then a random part of them.
std::vector<LeafId> random_region(Random& random, const LeafTable& table) {
    std::vector<LeafId> nodes = test::free_leaves(table);
    if (random.below(3) == 0) {
        std::erase_if(nodes, [&](LeafId) { return random.below(2) == 0; });
    }
    return nodes;
}

TEST(EdgeOracle, SightEdgesOfRandomQuadtrees) {
    Random random(31);
    std::size_t num_edges = 0;
    for (int round = 0; round < 120; ++round) {
        const std::int32_t side = std::int32_t{4} << random.below(3);
        const test::States states = test::random_map(random, side, random.uniform(0.0, 0.15));
        const LeafTable table = test::table_of(states);
        const std::vector<LeafId> nodes = random_region(random, table);
        const auto edges = sight_edges(table, nodes, kResolution);
        expect_equal(edges, all_sight_pairs(states, table, nodes));
        num_edges += edges.size();
    }
    EXPECT_GT(num_edges, 10'000U);
}

}  // namespace
}  // namespace quadcut
