// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/contracted_graph.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/rooms/drawing.hpp"
#include "tests/unit/rooms/plain_ground.hpp"

namespace quadcut {
namespace {

/// Drawn regions whose clearance is 0.2 m, but for what a test says.
struct Drawn {
    explicit Drawn(const std::vector<std::string>& rows)
        : labels(test::drawn_labels(rows)),
          clearance(labels.origin, labels.width, labels.height, 0.2F) {}

    [[nodiscard]] RegionGraph regions(std::uint32_t count) const {
        return RegionGraph(labels, count, plain.ground());
    }

    Raster<std::uint32_t> labels;
    Raster<float> clearance;
    test::PlainGround plain{clearance, 0.1};
};

TEST(ContractedGraph, WeightsByHand) {
    Drawn drawn({"aaaabbbbbb",  //
                 "aaaabbbbbb",  //
                 "aaaa.....c"});
    drawn.clearance.at({0, 0}) = 0.5F;
    drawn.clearance.at({8, 2}) = 0.8F;
    const ContractedGraph contracted = contract(drawn.regions(3));
    EXPECT_EQ(contracted.region_of_node, (std::vector<std::uint32_t>{1, 2, 3}));
    EXPECT_NEAR(contracted.graph.area_m2[0], 0.12, 1e-12);
    ASSERT_EQ(contracted.graph.neighbours(0).size(), 1U);
    // Two cells of border; centroids 5 and half a cell apart; a quarter of the wider one's peak.
    EXPECT_NEAR(contracted.graph.neighbour_weights(0)[0], 2.0 / std::hypot(5.0, 0.5) / 16.0, 1e-7);
    ASSERT_EQ(contracted.graph.neighbours(2).size(), 1U);
    EXPECT_NEAR(contracted.graph.neighbour_weights(2)[0], 1.0 / std::hypot(2.5, 1.5) / 16.0, 1e-7);
}

TEST(ContractedGraph, OpenBordersWeighAllOfBorderOverDistance) {
    const ContractedGraph contracted = contract(Drawn({"aaaabb", "aaaabb"}).regions(2));
    EXPECT_NEAR(contracted.graph.neighbour_weights(0)[0], 2.0 / 3.0, 1e-12);
}

TEST(ContractedGraph, ARingAndItsCoreHaveAFiniteWeight) {
    const ContractedGraph contracted = contract(Drawn({"aaa", "aba", "aaa"}).regions(2));
    EXPECT_NEAR(contracted.graph.neighbour_weights(0)[0], 4.0, 1e-12);
}

TEST(ContractedGraph, NodesAreTheRegionsThatThereAre) {
    const Drawn drawn({"aaabbbccc", "aaabbb.cc"});
    RegionGraph regions = drawn.regions(3);
    regions.join(2, 3);
    const ContractedGraph contracted = contract(regions);
    EXPECT_EQ(contracted.region_of_node, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_NEAR(contracted.graph.area_m2[1], 0.11, 1e-12);
    // The centroid of 11 cells.
    const double x = (2 * (3 + 4 + 5) + 6 + 2 * (7 + 8)) / 11.0;
    const double y = (5.0 + 1.0) / 11.0;
    EXPECT_NEAR(contracted.graph.neighbour_weights(0)[0], 2.0 / std::hypot(x - 1.0, y - 0.5),
                1e-12);
}

TEST(ContractedGraph, RegionsOfAPieceAreJoined) {
    const Drawn drawn({"aabbccdd"});
    RegionGraph regions = drawn.regions(4);
    const ContractedGraph contracted = contract(regions);
    Pieces pieces;
    pieces.piece_of_node = {0, 0, 1, 0};
    pieces.count = 2;
    join_pieces(regions, contracted, pieces);
    EXPECT_EQ(regions.region_of(2), 1U);
    EXPECT_EQ(regions.region_of(3), 3U);
    EXPECT_EQ(regions.region_of(4), 1U);
    EXPECT_EQ(regions.num_saddles(), 1U);
}

}  // namespace
}  // namespace quadcut
