// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/multilevel.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/spectral/coarsen.hpp"
#include "tests/unit/spectral/test_graphs.hpp"

namespace quadcut {
namespace {

using Parts = std::vector<std::uint32_t>;

/// 0 -2- 1 -3- 2 -1- 3, a loop of 5 on node 1; areas 1, 4, 9, 2.
Graph small_graph() {
    return build_graph(
        std::vector<WeightedEdge>{{0, 1, 2.0}, {1, 2, 3.0}, {2, 3, 1.0}, {1, 1, 5.0}},
        {1.0, 4.0, 9.0, 2.0});
}

/// Part of each node in every way to cut `num_nodes` nodes in two, node 0 in part 0.
std::vector<Parts> all_halves(std::size_t num_nodes) {
    std::vector<Parts> all;
    for (std::size_t bits = 1; bits < std::size_t{1} << (num_nodes - 1); ++bits) {
        Parts parts(num_nodes, 0);
        for (std::size_t i = 1; i < num_nodes; ++i) parts[i] = (bits >> (i - 1)) & 1U;
        all.push_back(std::move(parts));
    }
    return all;
}

TEST(NormalisedCut, ByHand) {
    const Graph graph = small_graph();
    // Degrees 2, 10, 4, 1.
    EXPECT_NEAR(normalised_cut(graph, LaplacianKind::degree, Parts{7, 7, 2, 2}),
                3.0 / 12.0 + 3.0 / 5.0, 1e-14);
    EXPECT_NEAR(normalised_cut(graph, LaplacianKind::area, Parts{0, 1, 1, 2}),
                2.0 / 1.0 + 3.0 / 13.0 + 1.0 / 2.0, 1e-14);
    EXPECT_NEAR(normalised_cut(graph, LaplacianKind::unweighted, Parts{0, 0, 0, 1}),
                1.0 / 16.0 + 1.0 / 1.0, 1e-14);
    EXPECT_EQ(normalised_cut(graph, LaplacianKind::degree, Parts{3, 3, 3, 3}), 0.0);
    EXPECT_THROW((void)normalised_cut(graph, LaplacianKind::degree, Parts{0, 0}), std::logic_error);
}

TEST(Coarsening, KeepsVolumesAndCuts) {
    Random random(3);
    const Graph graph = test::random_graph(random, 2000, 2.0);
    const Coarsening coarse = coarsen(graph, graph.area_m2, 1e9);
    EXPECT_LT(2 * coarse.graph.num_nodes(), graph.num_nodes() + 200);
    std::vector<double> area_m2(coarse.graph.num_nodes(), 0.0);
    std::vector<int> num_members(coarse.graph.num_nodes(), 0);
    for (std::size_t i = 0; i < graph.num_nodes(); ++i) {
        area_m2[coarse.coarse_of_node[i]] += graph.area_m2[i];
        ++num_members[coarse.coarse_of_node[i]];
    }
    for (std::size_t i = 0; i < area_m2.size(); ++i) {
        EXPECT_NEAR(coarse.graph.area_m2[i], area_m2[i], 1e-9 * area_m2[i]);
        EXPECT_GE(num_members[i], 1);
        EXPECT_LE(num_members[i], 4);
    }
    // Whatever parts the coarse nodes are put in, the cut is that of the fine nodes.
    Parts coarse_parts(coarse.graph.num_nodes());
    for (std::uint32_t& part : coarse_parts) part = static_cast<std::uint32_t>(random.below(5));
    Parts parts;
    for (const std::uint32_t node : coarse.coarse_of_node) parts.push_back(coarse_parts[node]);
    const double fine = normalised_cut(graph, LaplacianKind::area, parts);
    EXPECT_NEAR(normalised_cut(coarse.graph, LaplacianKind::area, coarse_parts), fine, 1e-9 * fine);
}

TEST(Coarsening, FollowsHeavyEdgesUpToTheVolume) {
    // Pairs (0, 1), (2, 3), ... bound by 10, and the pairs among each other by 1.
    std::vector<WeightedEdge> edges;
    for (std::uint32_t i = 0; i + 1 < 20; ++i) edges.push_back({i, i + 1, i % 2 == 0 ? 10.0 : 1.0});
    const Graph graph = build_graph(edges, std::vector<double>(20, 1.0));
    const Coarsening pairs = coarsen(graph, graph.area_m2, 2.0);
    ASSERT_EQ(pairs.graph.num_nodes(), 10U);
    for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(pairs.coarse_of_node[i], i / 2);
    EXPECT_EQ(coarsen(graph, graph.area_m2, 1.5).graph.num_nodes(), 20U);
}

TEST(MultilevelCut, CutsAtTheDoors) {
    // 2,304 rooms of 49 cells, 64 in a part: six levels.
    const auto plan = test::room_plan(48, 48, 7, test::Doors::open);
    const Graph graph = test::floor_graph(plan);
    const std::size_t num_rooms = 36;
    const Parts parts = cut_multilevel(graph, LaplacianKind::area, num_rooms);
    // No part ends inside a room: an edge between parts touches the cell of a door.
    std::size_t num_cut = 0;
    std::size_t num_inside = 0;
    for (std::size_t i = 0; i < graph.num_nodes(); ++i) {
        for (const std::uint32_t j : graph.neighbours(i)) {
            if (parts[i] == parts[j]) continue;
            ++num_cut;
            // The cell of a door has two neighbours; all others have more or are in a corner.
            const bool is_door = graph.neighbours(i).size() == 2 || graph.neighbours(j).size() == 2;
            if (!is_door) ++num_inside;
        }
    }
    EXPECT_EQ(num_inside, 0U);
    // 6 x 6 squares of 8 x 8 rooms have 60 borders of 8 doors.
    EXPECT_LE(num_cut, 2 * 8 * 60 * 5 / 4);
    EXPECT_EQ(std::set<std::uint32_t>(parts.begin(), parts.end()).size(), num_rooms);
}

TEST(MultilevelCut, NoMoveOfOneNodeHelps) {
    // Uneven weights make the coarse nodes' borders ragged: it takes the finest level to mend them.
    Graph graph = test::grid_graph(90, 40);
    for (std::size_t i = 0; i < graph.num_nodes(); ++i) {
        for (std::size_t k = graph.row_begin[i]; k < graph.row_begin[i + 1]; ++k) {
            graph.weights[k] = 0.05 + static_cast<double>((i + 1) * (graph.columns[k] + 1) % 7);
        }
    }
    Parts parts = cut_multilevel(graph, LaplacianKind::area, 6);
    const double cost = normalised_cut(graph, LaplacianKind::area, parts);
    for (std::size_t i = 0; i < graph.num_nodes(); ++i) {
        const std::uint32_t own = parts[i];
        for (const std::uint32_t j : graph.neighbours(i)) {
            if (parts[j] == own) continue;
            parts[i] = parts[j];
            EXPECT_GT(normalised_cut(graph, LaplacianKind::area, parts), cost * (1.0 - 1e-6));
            parts[i] = own;
        }
    }
}

TEST(MultilevelCut, SmallGraphsAreCutAsWellAsCanBe) {
    // Two clumps and what random edges there are: every way is tried.
    Random random(11);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<WeightedEdge> edges;
        for (std::uint32_t i = 0; i < 12; ++i) {
            for (std::uint32_t j = 0; j < i; ++j) {
                const double most = i / 6 == j / 6 ? 1.0 : 0.3;
                edges.push_back({i, j, random.uniform(0.01, most)});
            }
        }
        const Graph graph = build_graph(edges, std::vector<double>(12, 1.0));
        double best = std::numeric_limits<double>::infinity();
        for (const Parts& parts : all_halves(12)) {
            best = std::min(best, normalised_cut(graph, LaplacianKind::degree, parts));
        }
        const Parts parts = cut_multilevel(graph, LaplacianKind::degree, 2);
        EXPECT_NEAR(normalised_cut(graph, LaplacianKind::degree, parts), best, 1e-12);
    }
}

TEST(MultilevelCut, NoPartIsEmptyOnAnyGraph) {
    Random random(7);
    for (const LaplacianKind kind :
         {LaplacianKind::degree, LaplacianKind::unweighted, LaplacianKind::area}) {
        for (const std::size_t num_nodes : {0U, 1U, 2U, 30U, 5000U}) {
            const Graph graph = test::random_graph(random, num_nodes, 1.5, 1 + num_nodes / 1000);
            for (const std::size_t num_parts : {1U, 2U, 7U, 40U}) {
                const Parts parts = cut_multilevel(graph, kind, num_parts);
                ASSERT_EQ(parts.size(), num_nodes);
                const std::set<std::uint32_t> used(parts.begin(), parts.end());
                ASSERT_EQ(used.size(), std::min(num_nodes, num_parts));
                EXPECT_TRUE(used.empty() || *used.rbegin() == used.size() - 1);
            }
        }
    }
}

TEST(MultilevelCut, ComponentsAreFreeCuts) {
    const Graph graph = test::disjoint_union({test::grid_graph(50, 40), test::grid_graph(30, 30),
                                              test::grid_graph(40, 45), test::path_graph(300)});
    const Parts parts = cut_multilevel(graph, LaplacianKind::degree, 4);
    EXPECT_EQ(normalised_cut(graph, LaplacianKind::degree, parts), 0.0);
    EXPECT_EQ(std::set<std::uint32_t>(parts.begin(), parts.end()).size(), 4U);
}

TEST(MultilevelCut, NodesWithoutEdges) {
    const Graph graph = build_graph(std::vector<WeightedEdge>{{0, 1, 1.0}, {2, 2, 1.0}},
                                    std::vector<double>(4, 1.0));
    for (const LaplacianKind kind :
         {LaplacianKind::degree, LaplacianKind::unweighted, LaplacianKind::area}) {
        const Parts parts = cut_multilevel(graph, kind, 3);
        EXPECT_EQ(parts[0], parts[1]);
        EXPECT_NE(parts[2], parts[3]);
    }
}

}  // namespace
}  // namespace quadcut
