// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/border_edges.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/paper/small_map.hpp"

namespace quadcut {
namespace {

TEST(BorderEdges, SharedLengthOverCentreDistanceByHand) {
    // Free leaves in order: the 2 x 2 square (0, 0), the cells (2, 0), (3, 0), (3, 1).
    const LeafTable table = test::table_of(test::map_from_text({"..#.", "...."}));
    const std::vector<LeafId> nodes = test::free_leaves(table);
    const std::vector<WeightedEdge> edges = border_edges(table, nodes);
    ASSERT_EQ(edges.size(), 3U);
    // The square and (2, 0): they share one cell; centres 1.5 and 0.5 cells apart.
    EXPECT_EQ(edges[0].a, 0U);
    EXPECT_EQ(edges[0].b, 1U);
    EXPECT_NEAR(edges[0].weight, 1.0 / std::sqrt(2.5), 1e-15);
    // Equal neighbours share their side at that distance: weight 1.
    EXPECT_EQ(edges[1].a, 1U);
    EXPECT_EQ(edges[1].b, 2U);
    EXPECT_DOUBLE_EQ(edges[1].weight, 1.0);
    EXPECT_EQ(edges[2].a, 2U);
    EXPECT_EQ(edges[2].b, 3U);
    EXPECT_DOUBLE_EQ(edges[2].weight, 1.0);
}

TEST(BorderEdges, ACornerIsNoBorder) {
    const LeafTable table = test::table_of(test::map_from_text({"#.", ".#"}));
    EXPECT_TRUE(border_edges(table, test::free_leaves(table)).empty());
}

TEST(BorderEdges, LeavesOutOfTheRegionAreLeftOut) {
    const LeafTable table = test::table_of(test::map_from_text({"..", ".#"}));
    EXPECT_EQ(border_edges(table, test::free_leaves(table)).size(), 2U);
    EXPECT_EQ(border_edges(table, std::vector<LeafId>{LeafId{0}, LeafId{2}}).size(), 1U);
    EXPECT_TRUE(border_edges(table, {}).empty());
    EXPECT_THROW((void)border_edges(table, std::vector<LeafId>{LeafId{1}}), std::logic_error);
}

TEST(BorderEdges, SameBytesOnOneAndManyThreads) {
    Random random(6);
    const LeafTable table = test::table_of(test::random_map(random, 128, 0.05));
    const std::vector<LeafId> nodes = test::free_leaves(table);
    ASSERT_GT(nodes.size(), 2000U);
    const auto reference = border_edges(table, nodes, {1});
    for (const int num_threads : {2, 3, 8}) {
        const auto edges = border_edges(table, nodes, {num_threads});
        ASSERT_EQ(edges.size(), reference.size());
        for (std::size_t i = 0; i < edges.size(); ++i) {
            ASSERT_EQ(edges[i].a, reference[i].a);
            ASSERT_EQ(edges[i].b, reference[i].b);
            ASSERT_EQ(edges[i].weight, reference[i].weight);
        }
    }
}

}  // namespace
}  // namespace quadcut
