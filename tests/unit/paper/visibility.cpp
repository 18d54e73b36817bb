// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/visibility.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/map/leaf_table.hpp"
#include "tests/unit/paper/small_map.hpp"
#include "tests/unit/spectral/fake_accelerator.hpp"

namespace quadcut {
namespace {

/// Free cells of one size, not collapsed: the quadtree that a fixed grid would be.
void append_cells(Cell low, std::uint8_t level, std::vector<Leaf>& leaves) {
    if (level == 0) {
        leaves.push_back({low, 0, CellState::free});
        return;
    }
    const auto child = static_cast<std::uint8_t>(level - 1);
    const std::int32_t half = std::int32_t{1} << child;
    for (const Cell step : {Cell{0, 0}, Cell{half, 0}, Cell{0, half}, Cell{half, half}}) {
        append_cells({low.x + step.x, low.y + step.y}, child, leaves);
    }
}

std::vector<WeightedEdge> edges_of(const std::vector<std::string>& rows,
                                   SelfLoops self_loops = SelfLoops::none) {
    const LeafTable table = test::table_of(test::map_from_text(rows));
    return sight_edges(table, test::free_leaves(table), 0.05, self_loops);
}

TEST(SightEdges, ACellOfAUniformGridHasTwelveNeighbours) {
    std::vector<Leaf> leaves;
    append_cells({0, 0}, 3, leaves);
    const LeafTable table(leaves, Root{{0, 0}, 3});
    const std::vector<LeafId> nodes = test::free_leaves(table);
    const Graph graph =
        build_graph(sight_edges(table, nodes, 0.05), leaf_areas_m2(table, nodes, 1.0));
    const LeafId middle = *table.find({4, 4});
    const auto neighbours = graph.neighbours(index(middle));
    ASSERT_EQ(neighbours.size(), 12U);
    int num_at_one_side = 0;
    int num_at_the_diagonal = 0;
    int num_at_two_sides = 0;
    for (const std::uint32_t node : neighbours) {
        const Cell cell = leaves[node].lower_left;
        const int distance2 = (cell.x - 4) * (cell.x - 4) + (cell.y - 4) * (cell.y - 4);
        num_at_one_side += distance2 == 1 ? 1 : 0;
        num_at_the_diagonal += distance2 == 2 ? 1 : 0;
        num_at_two_sides += distance2 == 4 ? 1 : 0;
    }
    EXPECT_EQ(num_at_one_side, 4);
    EXPECT_EQ(num_at_the_diagonal, 4);
    EXPECT_EQ(num_at_two_sides, 4);
    // A corner of the grid keeps five of them: two beside it, two behind those, one diagonal.
    EXPECT_EQ(graph.neighbours(index(*table.find({0, 0}))).size(), 5U);
}

TEST(SightEdges, WeightOfEquationTwoByHand) {
    // Leaves: sides 2, 1, 1 cells and their like; the left one is 2 x 2.
    const std::vector<WeightedEdge> edges = edges_of({
        "..#.",
        "....",
    });
    const LeafTable table = test::table_of(test::map_from_text({"..#.", "...."}));
    const std::vector<LeafId> nodes = test::free_leaves(table);
    // Free leaves in order: the square (0, 0), the cells (2, 0), (3, 0), (3, 1).
    ASSERT_EQ(nodes.size(), 4U);
    ASSERT_EQ(table.leaf(nodes[0]).level, 1);
    // Square to (2, 0): s = 0.1 and 0.05, so w = 0.1 * 0.05 / 0.15 = 1/30 metre.
    ASSERT_FALSE(edges.empty());
    EXPECT_EQ(edges[0].a, 0U);
    EXPECT_EQ(edges[0].b, 1U);
    EXPECT_NEAR(edges[0].weight, 1.0 / 30.0, 1e-15);
    // Square to (3, 0): centres 2.5 x 0.5 cells apart, 2.55 <= Th = 1.05 * 3 = 3.15 cells.
    EXPECT_EQ(edges[1].b, 2U);
    EXPECT_NEAR(edges[1].weight, 1.0 / 30.0, 1e-15);
    // Cell (2, 0) to (3, 0): two equal cells, w = s / 2. Cell (2, 0) to (3, 1) passes the corner of
    // one obstacle only, so it counts, and (3, 0) to (3, 1); the square does not see (3, 1).
    ASSERT_EQ(edges.size(), 5U);
    EXPECT_EQ(edges[2].a, 1U);
    EXPECT_EQ(edges[2].b, 2U);
    EXPECT_NEAR(edges[2].weight, 0.025, 1e-15);
    EXPECT_EQ(edges[3].a, 1U);
    EXPECT_EQ(edges[3].b, 3U);
    EXPECT_EQ(edges[4].a, 2U);
    EXPECT_EQ(edges[4].b, 3U);
}

TEST(SightEdges, ThresholdOfEquationThreeByHand) {
    // Side 4 at (0, 0), cells in columns 4 and 6: the cells at (4, y) and (6, y) are single ones.
    const std::vector<std::string> rows{
        "?????.??", "????????", "????????", "????????",
        "....?.??", "......??", "....?.??", "....?.??",
    };
    const LeafTable table = test::table_of(test::map_from_text(rows));
    const std::vector<LeafId> nodes = test::free_leaves(table);
    const std::vector<WeightedEdge> edges = sight_edges(table, nodes, 1.0);
    const LeafId large = *table.find({0, 0});
    ASSERT_EQ(table.leaf(large).level, 2);
    ASSERT_EQ(nodes[0], large);
    // Th = 1.05 * 5 = 5.25 cells. (4, 2) is 2.55 cells away, (5, 2) is 3.54. (5, 3) at 3.81 is near
    // enough, and the straight way to it, over (4, 2) and (4, 3), is blocked by (4, 3).
    std::vector<Cell> seen;
    for (const WeightedEdge& edge : edges) {
        if (edge.a != 0) continue;
        seen.push_back(table.leaf(nodes[edge.b]).lower_left);
        EXPECT_NEAR(edge.weight, 4.0 * 1.0 / 5.0, 1e-15);
    }
    EXPECT_EQ(seen, (std::vector<Cell>{{4, 2}, {5, 2}}));
    // Two single cells: Th = 2.1. Two apart is an edge, five apart is none.
    EXPECT_EQ(edges.size(), 2U + 1U + 3U + 2U + 2U);
}

TEST(SightEdges, ThresholdOfEquationThreeToTheLastCell) {
    // A free square but for one cell, which splits its quarter down to single cells.
    test::States states({0, 0}, 32, 32, CellState::free);
    states.at({25, 10}) = CellState::occupied;
    const LeafTable table = test::table_of(states);
    const std::vector<LeafId> nodes = test::free_leaves(table);
    ASSERT_EQ(table.leaf(nodes[0]).level, 4);
    std::vector<Cell> single;
    for (const WeightedEdge& edge : sight_edges(table, nodes, 1.0)) {
        const Leaf& other = table.leaf(nodes[edge.b]);
        if (edge.a == 0 && other.level == 0) single.push_back(other.lower_left);
    }
    // From (8, 8) to the middle of (25, 11) is sqrt(17.5^2 + 3.5^2) = 17.846 cells, and Th = 1.05 *
    // 17 = 17.85; (24, 10) and (24, 11) are nearer.
    EXPECT_EQ(single, (std::vector<Cell>{{24, 10}, {24, 11}, {25, 11}}));
}

TEST(SightEdges, EachKindOfSelfLoopIsStoredOnce) {
    const std::vector<std::string> rows{
        "..#.",
        "....",
    };
    const std::size_t num_edges = edges_of(rows).size();
    for (const SelfLoops self_loops : {SelfLoops::own_weight, SelfLoops::largest_weight}) {
        const std::vector<WeightedEdge> edges = edges_of(rows, self_loops);
        EXPECT_EQ(edges.size(), num_edges + 4);
        const Graph graph = build_graph(edges, std::vector<double>(4, 1.0));
        EXPECT_EQ(graph.columns.size(), 2 * num_edges + 4);
        for (std::uint32_t node = 0; node < 4; ++node) {
            const auto neighbours = graph.neighbours(node);
            const auto weights = graph.neighbour_weights(node);
            int num_loops = 0;
            for (std::size_t k = 0; k < neighbours.size(); ++k) {
                if (neighbours[k] != node) continue;
                ++num_loops;
                const bool large = node == 0 || self_loops == SelfLoops::largest_weight;
                EXPECT_NEAR(weights[k], large ? 0.05 : 0.025, 1e-15);
            }
            EXPECT_EQ(num_loops, 1);
        }
    }
}

TEST(SightEdges, NoNodesNoEdgesAndOneNodeOnlyItsLoop) {
    const LeafTable table = test::table_of(test::map_from_text({".."}));
    EXPECT_TRUE(sight_edges(table, {}, 0.05).empty());
    const std::vector<LeafId> one{test::free_leaves(table).front()};
    EXPECT_TRUE(sight_edges(table, one, 0.05).empty());
    EXPECT_EQ(sight_edges(table, one, 0.05, SelfLoops::own_weight).size(), 1U);
}

TEST(SightEdges, NodesThatAreNotFreeOrNotInOrderAreRefused) {
    const LeafTable table = test::table_of(test::map_from_text({"..", ".#"}));
    EXPECT_THROW((void)sight_edges(table, std::vector<LeafId>{LeafId{1}}, 0.05), std::logic_error);
    EXPECT_THROW((void)sight_edges(table, std::vector<LeafId>{LeafId{2}, LeafId{0}}, 0.05),
                 std::logic_error);
    EXPECT_THROW((void)sight_edges(table, std::vector<LeafId>{LeafId{0}, LeafId{0}}, 0.05),
                 std::logic_error);
    EXPECT_THROW((void)sight_edges(table, std::vector<LeafId>{LeafId{9}}, 0.05), std::logic_error);
}

TEST(SightEdges, SameBytesOnOneAndManyThreads) {
    Random random(5);
    const LeafTable table = test::table_of(test::random_map(random, 128, 0.05));
    const std::vector<LeafId> nodes = test::free_leaves(table);
    ASSERT_GT(nodes.size(), 2000U);
    const auto reference = sight_edges(table, nodes, 0.05, SelfLoops::own_weight, {1});
    for (const int num_threads : {2, 3, 8}) {
        const auto edges = sight_edges(table, nodes, 0.05, SelfLoops::own_weight, {num_threads});
        ASSERT_EQ(edges.size(), reference.size());
        for (std::size_t i = 0; i < edges.size(); ++i) {
            ASSERT_EQ(edges[i].a, reference[i].a);
            ASSERT_EQ(edges[i].b, reference[i].b);
            ASSERT_EQ(edges[i].weight, reference[i].weight);
        }
    }
}

TEST(SightEdges, AreTheAcceleratorsUnlessItDeclines) {
    const LeafTable table = test::table_of(test::map_from_text({"..#.", "...."}));
    const std::vector<LeafId> nodes = test::free_leaves(table);
    test::FakeAccelerator willing(false);
    const auto edges = sight_edges(table, nodes, 0.5, SelfLoops::none, {1, &willing});
    ASSERT_EQ(edges.size(), 1U);
    EXPECT_EQ(edges[0].weight, 9.0);
    test::FakeAccelerator declining(true);
    EXPECT_EQ(sight_edges(table, nodes, 0.5, SelfLoops::none, {1, &declining}).size(),
              sight_edges(table, nodes, 0.5).size());
    EXPECT_EQ(declining.num_calls, 1);
    // It is asked for nothing, and for nothing that is wrong.
    EXPECT_TRUE(sight_edges(table, {}, 0.5, SelfLoops::none, {1, &willing}).empty());
    EXPECT_THROW((void)sight_edges(table, std::vector<LeafId>{LeafId{99}}, 0.5, {}, {1, &willing}),
                 std::logic_error);
    EXPECT_EQ(willing.num_calls, 1);
}

TEST(LeafAreas, AreInSquareMetres) {
    const LeafTable table = test::table_of(test::map_from_text({"..#.", "...."}));
    const std::vector<double> areas = leaf_areas_m2(table, test::free_leaves(table), 0.5);
    EXPECT_EQ(areas, (std::vector<double>{1.0, 0.25, 0.25, 0.25}));
}

}  // namespace
}  // namespace quadcut
