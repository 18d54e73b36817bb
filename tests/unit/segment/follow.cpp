// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/follow.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "io/label_image.hpp"
#include "io/score.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/segment/segment.hpp"
#include "tests/unit/segment/followed.hpp"

namespace quadcut {
namespace {

using test::ids_of;
using test::scans_in;
using test::small_building;

io::LabelImage image_of(const Raster<std::uint16_t>& labels) {
    const std::vector<std::uint32_t> values(labels.values.begin(), labels.values.end());
    return io::number_regions(labels.width, labels.height, values);
}

TEST(Follower, EndsWithTheRoomsOfItsMap) {
    const std::vector<Scan> scans = scans_in(small_building(3));
    Follower follower;
    std::vector<Point> trajectory;
    std::set<RoomId> born;
    for (const Scan& scan : scans) {
        const FollowUpdate update = follower.add_scan(scan);
        trajectory.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
        EXPECT_EQ(update.scan + 1, trajectory.size());
        EXPECT_GE(update.ps, 0.0);
        EXPECT_LE(update.ps, 1.0);
        for (const LifeEvent& event : update.events) {
            EXPECT_FALSE(event.reason.empty());
            const bool is_new = event.life == RoomLife::born || event.life == RoomLife::split;
            EXPECT_TRUE(!is_new || born.insert(event.room).second) << "an id was used again";
        }
    }
    follower.finish();
    const Segmentation followed = follower.rooms();
    const Segmentation batch = segment(follower.map().to_grid(), {}, trajectory);
    const io::RoomScore score = io::score_rooms(image_of(followed.labels), image_of(batch.labels));
    EXPECT_GT(score.pq, 0.95);
    EXPECT_GT(score.ari, 0.97);
    EXPECT_EQ(followed.doors.size() > 0, batch.doors.size() > 0);
    for (const RoomId id : ids_of(followed)) EXPECT_LT(index(id), followed.next_id);
    for (std::size_t i = 0; i < followed.labels.values.size(); ++i) {
        ASSERT_LE(followed.labels.values[i], followed.rooms.size());
    }
}

TEST(Follower, AGridThatAMapperShiftsKeepsItsIds) {
    const GridMap map = small_building(5).map;
    Follower follower;
    follower.update_cells(map.states);
    const Segmentation before = follower.rooms();
    ASSERT_GT(before.rooms.size(), 3U);
    // After a loop closure everything lies three cells further.
    Raster<CellState> shifted({map.states.origin.x, map.states.origin.y}, map.states.width + 3,
                              map.states.height + 3, CellState::unknown);
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        const Cell cell = map.states.cell(i);
        shifted.at({cell.x + 3, cell.y + 3}) = map.states.values[i];
    }
    follower.update_cells(shifted);
    const Segmentation after = follower.rooms();
    EXPECT_EQ(ids_of(after), ids_of(before));
}

TEST(Follower, AScanThatCannotBeUsedChangesNothing) {
    const std::vector<Scan> scans = scans_in(small_building(3));
    Follower follower;
    for (std::size_t i = 0; i < 10; ++i) follower.add_scan(scans[i]);
    const Segmentation before = follower.rooms();
    Scan broken = scans[10];
    broken.world_from_sensor.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(follower.add_scan(broken), InputError);
    broken = scans[10];
    broken.world_from_sensor.yaw_rad = std::numeric_limits<double>::infinity();
    EXPECT_THROW(follower.add_scan(broken), InputError);
    broken = scans[10];
    broken.world_from_sensor.x += 1500.0;
    broken.world_from_sensor.y += 1500.0;
    EXPECT_THROW(follower.add_scan(broken), InputError) << "a jump out of all bounds";
    EXPECT_EQ(follower.num_scans(), 10U);
    EXPECT_EQ(follower.rooms().labels.values, before.labels.values);
    Scan empty = scans[10];
    empty.ranges_m.clear();
    follower.add_scan(empty);
    EXPECT_EQ(follower.num_scans(), 11U);
    EXPECT_EQ(follower.rooms().labels.values, before.labels.values);
}

TEST(Follower, NothingSeenIsNoRoom) {
    Follower follower;
    EXPECT_EQ(follower.finish().num_rooms, 0U);
    EXPECT_FALSE(follower.refine());
    EXPECT_TRUE(follower.rooms().rooms.empty());
}

TEST(Follower, AWallThatGoesUpSplitsARoomAndOneThatGoesDownMergesThem) {
    const Raster<CellState> states = test::bare_hall();
    Follower follower;
    follower.update_cells(states);
    ASSERT_EQ(follower.num_rooms(), 1U);
    const RoomId first = follower.rooms().rooms.front().id;
    Raster<CellState> wall({100, 10}, 4, 100, CellState::occupied);
    for (std::int32_t y = 50; y < 68; ++y) {
        for (std::int32_t x = 100; x < 104; ++x) wall.at({x, y}) = CellState::free;
    }
    const FollowUpdate split = follower.update_cells(wall);
    EXPECT_EQ(follower.num_rooms(), 2U);
    ASSERT_EQ(split.events.size(), 1U);
    EXPECT_EQ(split.events.front().life, RoomLife::split);
    EXPECT_EQ(split.events.front().other, first) << "the larger part keeps the id";
    const FollowUpdate merged =
        follower.update_cells(Raster<CellState>({100, 10}, 4, 100, CellState::free));
    EXPECT_EQ(follower.num_rooms(), 1U);
    ASSERT_FALSE(merged.events.empty());
    EXPECT_EQ(merged.events.front().life, RoomLife::merged);
    EXPECT_EQ(merged.events.front().other, first);
    EXPECT_EQ(follower.rooms().rooms.front().id, first);
}

}  // namespace
}  // namespace quadcut
