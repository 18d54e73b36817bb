// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/covisibility.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

using Floors = std::vector<SeenFloor>;

Segmentation rooms_of(const std::vector<std::uint32_t>& ids) {
    Segmentation rooms;
    for (const std::uint32_t id : ids) {
        Room room;
        room.id = RoomId{id};
        room.area_m2 = id;
        rooms.rooms.push_back(room);
    }
    return rooms;
}

TEST(Covisibility, AScanIsSharedOutByTheFloorThatItSees) {
    Covisibility counts;
    count_scan(counts, Floors{{7, 30}, {2, 10}});
    count_scan(counts, Floors{{2, 5}});
    count_scan(counts, Floors{});
    EXPECT_EQ(counts.scans.size(), 3U);
    EXPECT_DOUBLE_EQ((counts.scans[{7, 7}]), 9.0 / 16.0);
    EXPECT_DOUBLE_EQ((counts.scans[{2, 7}]), 3.0 / 16.0);
    EXPECT_DOUBLE_EQ((counts.scans[{2, 2}]), 1.0 / 16.0 + 1.0);
}

TEST(Covisibility, RoomsThatBecomeOneCountAsIfTheyHadAlwaysBeen) {
    Covisibility apart;
    count_scan(apart, Floors{{1, 20}, {2, 10}, {3, 10}});
    count_scan(apart, Floors{{2, 4}, {3, 12}});
    Covisibility one;
    count_scan(one, Floors{{1, 20}, {3, 20}});
    count_scan(one, Floors{{3, 16}});
    join_rooms(apart, 2, 3);
    ASSERT_EQ(apart.scans.size(), one.scans.size());
    for (const auto& [pair, scans] : one.scans) EXPECT_DOUBLE_EQ(apart.scans[pair], scans);
}

TEST(Covisibility, TheGraphHasRoomsByPlaceAndKeepsWhatARoomSharesWithItself) {
    Covisibility counts;
    count_scan(counts, Floors{{4, 10}, {9, 10}});
    count_scan(counts, Floors{{6, 1}, {9, 1}});  // 6 is no room any more.
    const Graph graph = covisibility_graph(counts, rooms_of({4, 5, 9}));
    ASSERT_EQ(graph.num_nodes(), 3U);
    EXPECT_EQ(graph.area_m2, (std::vector<double>{4.0, 5.0, 9.0}));
    EXPECT_EQ(graph.columns, (std::vector<std::uint32_t>{0, 2, 0, 2}));
    EXPECT_EQ(graph.weights, (std::vector<double>{0.25, 0.25, 0.25, 0.5}));
    EXPECT_TRUE(graph.neighbours(1).empty());
}

}  // namespace
}  // namespace quadcut
