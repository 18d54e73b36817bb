// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/partition.hpp"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "reproduce/position_clusters.hpp"
#include "tests/unit/rooms/drawing.hpp"

namespace quadcut::reproduce {
namespace {

// Two rooms without a door; a character is 0.4 m.
constexpr std::int32_t kScale = 8;

GridMap two_closed_rooms() {
    return test::drawn_map({"############",  //
                            "#....##....#",  //
                            "#....##....#",  //
                            "#....##....#",  //
                            "#....##....#",  //
                            "############"},
                           0.05, kScale);
}

MapGraph graph_of_rooms(const GridMap& map) { return graph_of(map, SelfLoops::none, {}); }

/// 1 left of the column (in characters), 2 right of it, in free cells.
Raster<std::uint32_t> cut_at(const GridMap& map, std::int32_t column) {
    Raster<std::uint32_t> labels(map.states.box());
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        if (map.states.values[i] != CellState::free) continue;
        labels.values[i] = labels.cell(i).x < column * kScale ? 1 : 2;
    }
    return labels;
}

TEST(Partition, ACutAlongTheWallCouplesNothing) {
    const GridMap map = two_closed_rooms();
    const Quality quality = quality_of(graph_of_rooms(map), cut_at(map, 6), map, {});
    EXPECT_EQ(quality.num_regions, 2U);
    EXPECT_EQ(quality.num_broken, 0U);
    EXPECT_EQ(quality.coupling_percent, 0.0);
    EXPECT_EQ(quality.cut_percent, 0.0);
    EXPECT_DOUBLE_EQ(quality.imbalance, 1.0);
    EXPECT_FALSE(quality.pq_percent.has_value());
}

TEST(Partition, ACutThroughARoomIsSeen) {
    const GridMap map = two_closed_rooms();
    const Quality quality = quality_of(graph_of_rooms(map), cut_at(map, 9), map, {});
    EXPECT_EQ(quality.num_regions, 2U);
    EXPECT_EQ(quality.num_broken, 1U);
    EXPECT_GT(quality.coupling_percent, 0.0);
    EXPECT_GT(quality.cut_percent, 0.0);
    // At a column that leaves end at, areas are exact: five columns against three.
    EXPECT_DOUBLE_EQ(quality_of(graph_of_rooms(map), cut_at(map, 8), map, {}).imbalance, 1.25);
}

TEST(Partition, TrueRoomsThatAreCutApartAreCounted) {
    World world;
    world.map = two_closed_rooms();
    world.truth_map = world.map;
    world.truth = cut_at(world.map, 6);
    EXPECT_EQ(count_cut_rooms(cut_at(world.map, 6), world.map, world), 0U);
    EXPECT_EQ(count_cut_rooms(cut_at(world.map, 9), world.map, world), 1U);
    EXPECT_DOUBLE_EQ(pq_percent(cut_at(world.map, 6), world.map, world).value(), 100.0);
    EXPECT_LT(pq_percent(cut_at(world.map, 9), world.map, world).value(), 80.0);
}

TEST(Partition, ResultsAgreeWhereBothHaveRooms) {
    const GridMap map = two_closed_rooms();
    const Segmentation whole = as_segmentation(cut_at(map, 6), map);
    Raster<std::uint32_t> seen = cut_at(map, 6);
    for (std::uint32_t& label : seen.values) label = label == 2 ? 0 : label;
    EXPECT_DOUBLE_EQ(agreement_percent(map, as_segmentation(seen, map), map, whole), 100.0);
    EXPECT_LT(agreement_percent(map, as_segmentation(cut_at(map, 9), map), map, whole), 80.0);
}

TEST(Partition, LikenessCountsRegionsThatAreMissing) {
    const GridMap map = two_closed_rooms();
    const Segmentation whole = as_segmentation(cut_at(map, 6), map);
    Raster<std::uint32_t> seen = cut_at(map, 6);
    for (std::uint32_t& label : seen.values) label = label == 2 ? 0 : label;
    EXPECT_DOUBLE_EQ(likeness_percent(whole, whole), 100.0);
    EXPECT_LT(likeness_percent(as_segmentation(seen, map), whole), 80.0);
}

TEST(Partition, WhatNobodyCanNameIsNotJudged) {
    World world;
    world.map = two_closed_rooms();
    world.truth_map = world.map;
    world.truth = cut_at(world.map, 6);
    for (std::uint32_t& label : world.truth.values) label = label == 2 ? 0 : label;
    EXPECT_LT(pq_percent(cut_at(world.map, 6), world.map, world).value(), 80.0);
    world.is_void_judged = false;
    EXPECT_DOUBLE_EQ(pq_percent(cut_at(world.map, 6), world.map, world).value(), 100.0);
}

TEST(Partition, ABorderAcrossTheFloorIsToldFromOneInADoor) {
    // 4.8 m wide, so that the middle of a cut is 0.75 m from all walls and more; a door of 0.4 m.
    const GridMap map = test::drawn_map({"##############",  //
                                         "#.....##.....#",  //
                                         "#.....##.....#",  //
                                         "#............#",  //
                                         "#.....##.....#",  //
                                         "#.....##.....#",  //
                                         "#.....##.....#",  //
                                         "##############"},
                                        0.05, kScale);
    EXPECT_EQ(open_border_percent(cut_at(map, 7), map), 0.0);
    EXPECT_NEAR(open_border_percent(cut_at(map, 4), map), 100.0 * 0.9 / 2.4, 4.0);
    EXPECT_EQ(open_border_percent(cut_at(map, 1), map), 0.0) << "no border at all";
}

TEST(Partition, SubmapsHaveNoDoors) {
    Segmentation rooms = as_segmentation(cut_at(two_closed_rooms(), 6), two_closed_rooms());
    rooms.doors.emplace_back();
    EXPECT_TRUE(as_submaps(rooms).doors.empty());
}

TEST(Partition, LinksAreThePairsWithAnEdge) {
    const GridMap map = two_closed_rooms();
    const MapGraph graph = graph_of_rooms(map);
    EXPECT_TRUE(linked_regions(graph, labels_of_nodes(graph, cut_at(map, 6))).empty());
    EXPECT_EQ(linked_regions(graph, labels_of_nodes(graph, cut_at(map, 9))),
              (std::set<std::pair<std::uint32_t, std::uint32_t>>{{1, 2}}));
}

TEST(PositionClusters, TwoRoomsOnEitherSideOfALineAreTwoClusters) {
    const GridMap map = two_closed_rooms();
    const MapGraph graph = graph_of_rooms(map);
    const std::vector<std::uint32_t> clusters =
        cluster_positions(graph.leaves.table, graph.leaves.nodes, 2, 1);
    ASSERT_EQ(clusters.size(), graph.leaves.nodes.size());
    const Raster<std::uint32_t> labels = labels_of_cells(graph, map, clusters);
    const Quality quality = quality_of(graph, labels, map, {});
    EXPECT_EQ(quality.num_regions, 2U);
    EXPECT_EQ(quality.num_broken, 0U);
}

TEST(PositionClusters, WallsPlayNoPart) {
    // Three clusters of two rooms: one of them has to lie in both, or to cut a room.
    const GridMap map = two_closed_rooms();
    const MapGraph graph = graph_of_rooms(map);
    const Quality quality =
        quality_of(graph,
                   labels_of_cells(graph, map,
                                   cluster_positions(graph.leaves.table, graph.leaves.nodes, 3, 1)),
                   map, {});
    EXPECT_EQ(quality.num_regions, 3U);
    EXPECT_GT(quality.cut_percent, 0.0);
    EXPECT_TRUE(cluster_positions(graph.leaves.table, {}, 3, 1).empty());
}

}  // namespace
}  // namespace quadcut::reproduce
