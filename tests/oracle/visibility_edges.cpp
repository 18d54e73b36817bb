// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/paper/visibility.hpp"
#include "quadcut/rooms/border_edges.hpp"
#include "tests/oracle/visibility_oracle.hpp"
#include "tests/unit/paper/small_map.hpp"

/// Both kinds of edge against a look at every pair of leaves.
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

std::vector<WeightedEdge> all_border_pairs(const LeafTable& table,
                                           const std::vector<LeafId>& nodes) {
    const auto overlap = [](std::int32_t low_a, std::int32_t side_a, std::int32_t low_b,
                            std::int32_t side_b) {
        return std::min(low_a + side_a, low_b + side_b) - std::max(low_a, low_b);
    };
    std::vector<WeightedEdge> edges;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        for (std::uint32_t j = 0; j < nodes.size(); ++j) {
            const Leaf& a = table.leaf(nodes[i]);
            const Leaf& b = table.leaf(nodes[j]);
            const std::int32_t along_x =
                overlap(a.lower_left.x, a.side_cells(), b.lower_left.x, b.side_cells());
            const std::int32_t along_y =
                overlap(a.lower_left.y, a.side_cells(), b.lower_left.y, b.side_cells());
            const bool beside = along_x == 0 && along_y > 0 && a.lower_left.x < b.lower_left.x;
            const bool above = along_y == 0 && along_x > 0 && a.lower_left.y < b.lower_left.y;
            if (!beside && !above) continue;
            edges.push_back({i, j, std::max(along_x, along_y) / centre_distance(a, b)});
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

TEST(EdgeOracle, BorderEdgesOfRandomQuadtrees) {
    Random random(32);
    std::size_t num_edges = 0;
    for (int round = 0; round < 120; ++round) {
        const std::int32_t side = std::int32_t{4} << random.below(4);
        const test::States states = test::random_map(random, side, random.uniform(0.0, 0.15));
        const LeafTable table = test::table_of(states);
        const std::vector<LeafId> nodes = random_region(random, table);
        const auto edges = border_edges(table, nodes);
        expect_equal(edges, all_border_pairs(table, nodes));
        num_edges += edges.size();
    }
    EXPECT_GT(num_edges, 10'000U);
}

}  // namespace
}  // namespace quadcut
