// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/spectral_pieces.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/map/clearance.hpp"
#include "quadcut/rooms/basins.hpp"
#include "quadcut/rooms/contracted_graph.hpp"
#include "quadcut/segment/inside.hpp"
#include "tests/unit/rooms/drawing.hpp"
#include "tests/unit/rooms/plain_ground.hpp"

namespace quadcut {
namespace {

constexpr double kMinAreaM2 = 1.5;

/// Nodes in a row, each joined to the next.
Graph row_of(std::size_t num_nodes, double area_m2, double weight) {
    std::vector<WeightedEdge> edges;
    for (std::uint32_t node = 1; node < num_nodes; ++node) {
        edges.push_back({node - 1, node, weight});
    }
    return build_graph(edges, std::vector<double>(num_nodes, area_m2));
}

TEST(SpectralPieces, TwoRoomsAreCutAtTheirDoor) {
    const GridMap map = test::two_rooms();
    const Raster<float> clearance = clearance_m(mask_of(map, CellState::free), map.resolution_m);
    const Basins basins = build_basins(clearance, map.resolution_m);
    const test::PlainGround plain(clearance, map.resolution_m);
    RegionGraph regions(basins.labels, basins.count, plain.ground());
    const ContractedGraph contracted = contract(regions);
    join_pieces(regions, contracted, cut_spectrally(contracted.graph, kMinAreaM2));
    std::set<std::uint32_t> left;
    std::set<std::uint32_t> right;
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        if (basins.labels.values[i] == 0) continue;
        const std::uint32_t piece = regions.region_of(basins.labels.values[i]);
        const std::int32_t x = map.states.cell(i).x;
        if (x < 82) left.insert(piece);
        if (x >= 86) right.insert(piece);
    }
    for (const std::uint32_t piece : left) EXPECT_EQ(right.count(piece), 0U) << "one piece of both";
}

TEST(SpectralPieces, WhatIsWideOpenAndSmallIsOne) {
    const Pieces pieces = cut_spectrally(row_of(3, 2.0, 4.0), kMinAreaM2);
    EXPECT_EQ(pieces.count, 1U);
    ASSERT_EQ(pieces.eigen.size(), 1U);
    EXPECT_EQ(pieces.eigen[0].eigenvalues.size(), 1U) << "those below 0.8 / m^2";
}

TEST(SpectralPieces, AnEdgeThatIsNearlyClosedIsCut) {
    const std::vector<WeightedEdge> edges{{0, 1, 4.0}, {1, 2, 0.05}, {2, 3, 4.0}};
    const Pieces pieces = cut_spectrally(build_graph(edges, {2.0, 2.0, 2.0, 2.0}), kMinAreaM2);
    EXPECT_EQ(pieces.piece_of_node, (std::vector<std::uint32_t>{0, 0, 1, 1}));
}

TEST(SpectralPieces, NothingIsSolvedForWhatIsSmallerThanARoom) {
    const std::vector<WeightedEdge> edges{{0, 1, 0.01}, {2, 3, 0.01}};
    const Pieces pieces = cut_spectrally(build_graph(edges, {0.7, 0.7, 0.8, 0.8, 9.0}), kMinAreaM2);
    ASSERT_EQ(pieces.eigen.size(), 1U);
    EXPECT_EQ(pieces.eigen[0].num_nodes, 2U);
    EXPECT_EQ(pieces.count, 4U);
    EXPECT_EQ(pieces.piece_of_node[0], pieces.piece_of_node[1]);
    EXPECT_NE(pieces.piece_of_node[2], pieces.piece_of_node[3]);
}

TEST(SpectralPieces, ALongRowIsCutAgainAndAgainIntoPiecesThatHangTogether) {
    const Pieces pieces = cut_spectrally(row_of(400, 1.0, 1.0), kMinAreaM2);
    EXPECT_GT(pieces.eigen.size(), 8U);
    for (const EigenReport& solve : pieces.eigen) {
        EXPECT_GE(solve.num_nodes, 2U);
        EXPECT_LE(solve.eigenvalues.size(), 8U);
    }
    // By the eigenvalue of an even row: pi^2 / length^2 below 0.8.
    EXPECT_GT(pieces.count, 400U / 8U);
    EXPECT_LT(pieces.count, 400U / 2U);
    std::set<std::uint32_t> closed;
    for (std::size_t node = 1; node < pieces.piece_of_node.size(); ++node) {
        if (pieces.piece_of_node[node] == pieces.piece_of_node[node - 1]) continue;
        EXPECT_TRUE(closed.insert(pieces.piece_of_node[node - 1]).second);
        EXPECT_EQ(closed.count(pieces.piece_of_node[node]), 0U) << "in two parts";
    }
}

TEST(SpectralPieces, TheFewNodesThatLanczosCouldNotSolve) {
    const std::vector<WeightedEdge> edges{{0, 1, 0.0605279}, {1, 2, 1.84672}};
    const Pieces pieces = cut_spectrally(build_graph(edges, {13.4775, 0.4725, 0.7325}), kMinAreaM2);
    EXPECT_EQ(pieces.piece_of_node, (std::vector<std::uint32_t>{0, 1, 1}));
}

TEST(SpectralPieces, OfNothingAreNone) { EXPECT_EQ(cut_spectrally(Graph{}, kMinAreaM2).count, 0U); }

}  // namespace
}  // namespace quadcut
