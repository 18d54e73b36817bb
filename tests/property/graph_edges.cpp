// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/map/leaf_table.hpp"
#include "quadcut/paper/visibility.hpp"
#include "tests/unit/paper/small_map.hpp"

namespace quadcut {
namespace {

/// A leaf by its place, which survives a change of the list of leaves.
using Place = std::tuple<std::int32_t, std::int32_t, std::int32_t>;
using EdgeMap = std::map<std::pair<Place, Place>, double>;

std::vector<WeightedEdge> sight(const LeafTable& table, std::span<const LeafId> nodes) {
    return sight_edges(table, nodes, 0.05);
}

/// The edges of a whole map; each once, whichever end came first.
EdgeMap edge_map(const test::States& states) {
    const LeafTable table = test::table_of(states);
    const std::vector<LeafId> nodes = test::free_leaves(table);
    EdgeMap edges;
    const auto place = [&](std::uint32_t node) {
        const Leaf& leaf = table.leaf(nodes[node]);
        return Place{leaf.lower_left.x, leaf.lower_left.y, leaf.side_cells()};
    };
    for (const WeightedEdge& edge : sight(table, nodes)) {
        const Place a = place(edge.a);
        const Place b = place(edge.b);
        EXPECT_TRUE(edges.emplace(std::minmax(a, b), edge.weight).second) << "stored twice";
    }
    return edges;
}

/// One of the eight ways to lay a square on itself, for the cell or block at (x, y).
Cell turned(Cell low, std::int32_t block, std::int32_t side, Cell origin, unsigned symmetry) {
    std::int32_t x = low.x - origin.x;
    std::int32_t y = low.y - origin.y;
    if ((symmetry & 1U) != 0) x = side - block - x;
    if ((symmetry & 2U) != 0) y = side - block - y;
    if ((symmetry & 4U) != 0) std::swap(x, y);
    return {origin.x + x, origin.y + y};
}

TEST(EdgeProperties, TurningAndMirroringTheMapTurnsTheEdges) {
    Random random(41);
    for (int round = 0; round < 20; ++round) {
        const test::States states = test::random_map(random, 16, random.uniform(0.0, 0.1));
        const EdgeMap edges = edge_map(states);
        for (unsigned symmetry = 1; symmetry < 8; ++symmetry) {
            const auto turn = [&](Cell low, std::int32_t block) {
                return turned(low, block, states.width, states.origin, symmetry);
            };
            test::States other = states;
            for (std::size_t i = 0; i < states.values.size(); ++i) {
                other.at(turn(states.cell(i), 1)) = states.values[i];
            }
            const auto turn_place = [&](const Place& place) {
                const auto [x, y, block] = place;
                const Cell low = turn({x, y}, block);
                return Place{low.x, low.y, block};
            };
            EdgeMap expected;
            for (const auto& [pair, weight] : edges) {
                const Place first = turn_place(pair.first);
                const Place second = turn_place(pair.second);
                expected[{std::min(first, second), std::max(first, second)}] = weight;
            }
            EXPECT_EQ(edge_map(other), expected) << "symmetry " << symmetry;
        }
    }
}

TEST(EdgeProperties, AddingAWallNeverAddsASightEdge) {
    Random random(42);
    int num_lost = 0;
    for (int round = 0; round < 200; ++round) {
        const test::States before = test::random_map(random, 16, random.uniform(0.0, 0.1));
        test::States after = before;
        for (std::uint64_t n = 1 + random.below(3); n > 0; --n) {
            after.values[random.below(after.values.size())] = CellState::occupied;
        }
        const EdgeMap old_edges = edge_map(before);
        const EdgeMap new_edges = edge_map(after);
        const LeafTable old_table = test::table_of(before);
        const auto was_leaf = [&](const Place& place) {
            const auto [x, y, side] = place;
            const auto id = old_table.find({x, y});
            return id.has_value() && old_table.leaf(*id).side_cells() == side &&
                   old_table.leaf(*id).state == CellState::free;
        };
        // Leaves that the wall split are new ones; an edge between two old leaves must be old.
        for (const auto& [pair, weight] : new_edges) {
            if (!was_leaf(pair.first) || !was_leaf(pair.second)) continue;
            const auto old = old_edges.find(pair);
            ASSERT_NE(old, old_edges.end());
            EXPECT_EQ(old->second, weight);
        }
        num_lost += new_edges.size() < old_edges.size() ? 1 : 0;
    }
    EXPECT_GT(num_lost, 0);
}

TEST(EdgeProperties, EdgesOfARegionAreThoseOfTheMapBetweenItsLeaves) {
    Random random(43);
    for (int round = 0; round < 40; ++round) {
        const LeafTable table = test::table_of(test::random_map(random, 32, 0.05));
        const std::vector<LeafId> nodes = test::free_leaves(table);
        std::vector<LeafId> region;
        std::vector<std::uint32_t> chosen;
        for (std::uint32_t i = 0; i < nodes.size(); ++i) {
            if (random.below(2) == 0) continue;
            region.push_back(nodes[i]);
            chosen.push_back(i);
        }
        const Graph whole = build_graph(sight(table, nodes), leaf_areas_m2(table, nodes, 0.05));
        const Graph part = build_graph(sight(table, region), leaf_areas_m2(table, region, 0.05));
        const Graph expected = induced_subgraph(whole, chosen);
        EXPECT_EQ(part.row_begin, expected.row_begin);
        EXPECT_EQ(part.columns, expected.columns);
        EXPECT_EQ(part.weights, expected.weights);
        EXPECT_EQ(part.area_m2, expected.area_m2);
    }
}

}  // namespace
}  // namespace quadcut
