// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/paper/cut.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/paper/halves.hpp"
#include "quadcut/paper/submaps.hpp"

namespace quadcut {
namespace {

/// Submaps of up to 400 m^2.
const PaperOptions kLimits = [] {
    PaperOptions options;
    options.max_submap_m2 = 400.0;
    options.max_route_edges = 60;
    options.min_relation_per_m = 1.0;
    return options;
}();

/// A grid of width x height nodes of 1 m^2 for each room, rooms in a row; neighbouring rooms are
/// joined by one edge of weight `door` (none if 0).
Graph rooms_in_a_row(std::uint32_t num_rooms, std::uint32_t width, std::uint32_t height,
                     double door) {
    std::vector<WeightedEdge> edges;
    const std::uint32_t size = width * height;
    for (std::uint32_t room = 0; room < num_rooms; ++room) {
        const auto node = [&](std::uint32_t x, std::uint32_t y) {
            return room * size + y * width + x;
        };
        for (std::uint32_t y = 0; y < height; ++y) {
            for (std::uint32_t x = 0; x < width; ++x) {
                if (x + 1 < width) edges.push_back({node(x, y), node(x + 1, y), 1.0});
                if (y + 1 < height) edges.push_back({node(x, y), node(x, y + 1), 1.0});
            }
        }
        if (room + 1 < num_rooms && door > 0.0) {
            edges.push_back({node(width - 1, height / 2),
                             node(width - 1, height / 2) + size - width + 1, door});
        }
    }
    return build_graph(edges, std::vector<double>(std::size_t{num_rooms} * size, 1.0));
}

/// Every node is in a piece, pieces are numbered without gaps, and each is connected.
void expect_partition(const Graph& graph, const Pieces& pieces) {
    ASSERT_EQ(pieces.piece_of_node.size(), graph.num_nodes());
    std::vector<std::vector<std::uint32_t>> members(pieces.count);
    for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
        ASSERT_LT(pieces.piece_of_node[node], pieces.count);
        members[pieces.piece_of_node[node]].push_back(node);
    }
    for (const auto& nodes : members) {
        ASSERT_FALSE(nodes.empty());
        const auto component = connected_components(induced_subgraph(graph, nodes));
        EXPECT_EQ(*std::max_element(component.begin(), component.end()), 0U);
    }
}

/// Whether all nodes of each room are in one piece, and no piece holds two rooms.
void expect_rooms(const Pieces& pieces, std::uint32_t num_rooms) {
    EXPECT_EQ(pieces.count, num_rooms);
    const std::size_t size = pieces.piece_of_node.size() / num_rooms;
    std::set<std::uint32_t> used;
    for (std::uint32_t room = 0; room < num_rooms; ++room) {
        for (std::size_t i = 0; i < size; ++i) {
            ASSERT_EQ(pieces.piece_of_node[room * size + i], pieces.piece_of_node[room * size]);
        }
        used.insert(pieces.piece_of_node[room * size]);
    }
    EXPECT_EQ(used.size(), num_rooms);
}

TEST(Cut, FindsRoomsBehindDoors) {
    const Graph graph = rooms_in_a_row(4, 6, 6, 0.2);
    StageClock clock;
    PaperOptions options;
    options.num_submaps = 4;
    const Pieces pieces = cut(graph, options, 1, clock);
    expect_partition(graph, pieces);
    expect_rooms(pieces, 4);
    ASSERT_EQ(pieces.eigen.size(), 1U);
    EXPECT_EQ(pieces.eigen[0].eigenvalues.size(), 4U);
}

TEST(Cut, TheSilhouetteFindsTheNumberOfRooms) {
    const Graph graph = rooms_in_a_row(5, 6, 6, 0.05);
    StageClock clock;
    PaperOptions options;
    options.first_cut = FirstCut::silhouette;
    options.max_submaps = 10;
    expect_rooms(cut(graph, options, 1, clock), 5);
}

TEST(Cut, TheEigengapFindsTheNumberOfRooms) {
    // More than the silhouette is tried for.
    const Graph graph = rooms_in_a_row(40, 5, 5, 0.05);
    StageClock clock;
    PaperOptions options;
    options.first_cut = FirstCut::eigengap;
    const Pieces pieces = cut(graph, options, 1, clock);
    expect_partition(graph, pieces);
    expect_rooms(pieces, 40);
}

TEST(Cut, ARoomWithoutAGapIsOne) {
    StageClock clock;
    EXPECT_EQ(cut(rooms_in_a_row(1, 3, 3, 0.0), {}, 1, clock).count, 1U);
}

TEST(Cut, EightDisconnectedEqualRoomsAreEight) {
    const Graph graph = rooms_in_a_row(8, 5, 5, 0.0);
    StageClock clock;
    PaperOptions options;
    options.num_submaps = 8;
    expect_rooms(cut(graph, options, 1, clock), 8);
}

TEST(Cut, ARegionWithoutNodesHasNoPieces) {
    StageClock clock;
    EXPECT_EQ(cut(Graph{}, {}, 1, clock).count, 0U);
}

TEST(Submaps, LongestRouteOfAPathAndAGrid) {
    EXPECT_EQ(longest_route_edges(rooms_in_a_row(1, 10, 1, 0.0)), 9U);
    EXPECT_EQ(longest_route_edges(rooms_in_a_row(1, 7, 4, 0.0)), 6U + 3U);
    EXPECT_EQ(longest_route_edges(rooms_in_a_row(1, 1, 1, 0.0)), 0U);
    EXPECT_EQ(longest_route_edges(Graph{}), 0U);
}

TEST(Halves, LieWhereTheNormalisedCutIsLeast) {
    // Of three rooms in a row, one of the two doors.
    const Graph graph = rooms_in_a_row(3, 8, 8, 0.1);
    StageClock clock;
    const Halves halves = cut_in_half(graph, {}, 1, clock);
    expect_partition(graph, halves.pieces);
    ASSERT_EQ(halves.pieces.count, 2U);
    EXPECT_NEAR(halves.relation_per_m, 0.1 / 192.0, 1e-12);
}

TEST(Halves, AreNoSmallerThanASubmap) {
    const Graph graph = rooms_in_a_row(1, 3, 2, 0.0);
    StageClock clock;
    PaperOptions options;
    options.min_submap_m2 = 4.0;
    EXPECT_EQ(cut_in_half(graph, options, 1, clock).pieces.count, 1U) << "6 m^2";
    options.min_submap_m2 = 3.0;
    EXPECT_EQ(cut_in_half(graph, options, 1, clock).pieces.count, 2U);
    EXPECT_EQ(cut_in_half(Graph{}, options, 1, clock).pieces.count, 0U);
}

TEST(Submaps, APartOfARegionGetsTheBordersOfTheWhole) {
    // Six rooms, and the last three of them alone.
    const Graph whole = rooms_in_a_row(6, 8, 8, 0.1);
    std::vector<std::uint32_t> nodes(192);
    std::iota(nodes.begin(), nodes.end(), 192U);
    StageClock clock;
    PaperOptions options;
    options.min_relation_per_m = 0.02;
    const Submaps all = find_submaps(whole, options, 1, clock, {});
    const Submaps part = find_submaps(induced_subgraph(whole, nodes), options, 1, clock, {});
    EXPECT_EQ(all.pieces.count, 6U);
    EXPECT_EQ(part.pieces.count, 3U);
}

TEST(Submaps, LongSubmapsAreDivided) {
    const Graph corridor = rooms_in_a_row(1, 64, 2, 0.0);
    Pieces one;
    one.piece_of_node.assign(corridor.num_nodes(), 0);
    one.count = 1;
    PaperOptions limits = kLimits;
    limits.max_route_edges = 20;
    limits.min_relation_per_m = 0.0;
    StageClock clock;
    const Pieces divided = divide_submaps(corridor, one, limits, 1, clock);
    expect_partition(corridor, divided);
    EXPECT_EQ(divided.count, 4U);
    limits.max_route_edges = 1000;
    EXPECT_EQ(divide_submaps(corridor, one, limits, 1, clock).count, 1U);
    limits.max_submap_m2 = 70.0;
    EXPECT_EQ(divide_submaps(corridor, one, limits, 1, clock).count, 2U) << "128 m^2";
}

/// Three rooms of 36 m^2 and, at the wall of the first, a chain of twenty nodes of 0.01 m^2 that
/// hangs on by less than the rooms do.
Graph three_rooms_and_a_sliver() {
    const Graph rooms = rooms_in_a_row(3, 6, 6, 0.1);
    std::vector<WeightedEdge> edges;
    std::vector<double> areas = rooms.area_m2;
    for (std::uint32_t node = 0; node < rooms.num_nodes(); ++node) {
        const auto neighbours = rooms.neighbours(node);
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            if (neighbours[k] < node) continue;
            edges.push_back({node, neighbours[k], rooms.neighbour_weights(node)[k]});
        }
    }
    std::uint32_t last = 0;
    for (int i = 0; i < 20; ++i) {
        const auto next = static_cast<std::uint32_t>(areas.size());
        edges.push_back({last, next, i == 0 ? 0.001 : 1.0});
        areas.push_back(0.01);
        last = next;
    }
    return build_graph(edges, areas);
}

TEST(Submaps, ASliverDoesNotTakeTheNumberOfARoom) {
    const Graph graph = three_rooms_and_a_sliver();
    StageClock clock;
    PaperOptions options;
    options.num_submaps = 3;
    const Pieces plain = cut(graph, options, 1, clock);
    EXPECT_NE(plain.piece_of_node[0], plain.piece_of_node[108]) << "the sliver is a piece";
    const Pieces rooms = cut_into(graph, 3, kLimits, 1, clock);
    expect_partition(graph, rooms);
    ASSERT_EQ(rooms.count, 3U);
    for (std::uint32_t node = 0; node < 108; ++node) {
        EXPECT_EQ(rooms.piece_of_node[node], rooms.piece_of_node[node / 36 * 36]) << node;
    }
    EXPECT_EQ(rooms.piece_of_node[108], rooms.piece_of_node[0]);
}

/// Three submaps: 0 and 1 joined by weight 3 over 4 + 4 m^2, 1 and 2 by weight 1 over 4 + 2 m^2.
struct ThreeSubmaps {
    Graph graph = build_graph(
        std::vector<WeightedEdge>{{0, 1, 1.0}, {1, 2, 3.0}, {2, 3, 1.0}, {3, 4, 1.0}, {4, 5, 1.0}},
        {2.0, 2.0, 2.0, 2.0, 1.0, 1.0});
    Pieces pieces{{0, 0, 1, 1, 2, 2}, 3, {}};
};

TEST(Submaps, FuseByTheRelativeCoefficient) {
    // Eq. (11): r(0, 1) = 3 / 8, r(1, 2) = 1 / 6.
    const ThreeSubmaps three;
    PaperOptions limits = kLimits;
    limits.min_submap_m2 = 0.0;
    limits.min_relation_per_m = 0.3;
    EXPECT_EQ(fuse_submaps(three.graph, three.pieces, limits).piece_of_node,
              (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1}));
    limits.min_relation_per_m = 0.4;
    EXPECT_EQ(fuse_submaps(three.graph, three.pieces, limits).count, 3U);
    // After the first fuse the coefficient of what is left is 1 / 10.
    limits.min_relation_per_m = 0.11;
    EXPECT_EQ(fuse_submaps(three.graph, three.pieces, limits).count, 2U);
    limits.min_relation_per_m = 0.09;
    EXPECT_EQ(fuse_submaps(three.graph, three.pieces, limits).count, 1U);
}

TEST(Submaps, SmallOnesAreFusedWhateverTheirRelation) {
    const ThreeSubmaps three;
    PaperOptions limits = kLimits;
    limits.min_relation_per_m = 100.0;
    limits.min_submap_m2 = 3.0;
    EXPECT_EQ(fuse_submaps(three.graph, three.pieces, limits).piece_of_node,
              (std::vector<std::uint32_t>{0, 0, 1, 1, 1, 1}));
}

TEST(Submaps, FuseToANumber) {
    const ThreeSubmaps three;
    EXPECT_EQ(fuse_submaps_to(three.graph, three.pieces, 2).piece_of_node,
              (std::vector<std::uint32_t>{0, 0, 1, 1, 1, 1}));
    EXPECT_EQ(fuse_submaps_to(three.graph, three.pieces, 1).count, 1U);
    EXPECT_EQ(fuse_submaps_to(three.graph, three.pieces, 5).count, 3U);
    const Graph apart = rooms_in_a_row(3, 2, 2, 0.0);
    const Pieces rooms{{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2}, 3, {}};
    EXPECT_EQ(fuse_submaps_to(apart, rooms, 1).count, 3U) << "components stay apart";
}

}  // namespace
}  // namespace quadcut
