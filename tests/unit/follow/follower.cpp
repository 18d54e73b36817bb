// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/follower.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "eval/score.hpp"
#include "io/label_image.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "tests/unit/follow/followed.hpp"
#include "tests/unit/segment/painted_floor.hpp"

namespace quadcut {
namespace {

using test::ids_of;
using test::scans_in;
using test::small_building;

io::LabelImage image_of(const Raster<std::uint16_t>& labels) {
    const std::vector<std::uint32_t> values(labels.values.begin(), labels.values.end());
    return io::number_regions(labels.width, labels.height, values);
}

class FollowerOfPieces : public testing::TestWithParam<PieceSource> {};

TEST_P(FollowerOfPieces, EndsWithTheRoomsOfItsMap) {
    const std::vector<Scan> scans = scans_in(small_building(3));
    FollowOptions options;
    options.segment.rooms.pieces = GetParam();
    Follower follower(options);
    std::vector<Point> trajectory;
    std::set<RoomId> born;
    for (const Scan& scan : scans) {
        const FollowUpdate update = follower.add_scan(scan);
        trajectory.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
        EXPECT_EQ(update.scan + 1, trajectory.size());
        EXPECT_GE(update.ps, 0.0);
        EXPECT_LE(update.ps, 1.0);
        for (const RoomEvent& event : update.events) {
            EXPECT_FALSE(event.reason.empty());
            const bool is_new =
                event.change == RoomChange::born || event.change == RoomChange::split;
            EXPECT_TRUE(!is_new || born.insert(event.room).second) << "an id was used again";
        }
    }
    follower.finish();
    const Segmentation followed = follower.rooms();
    const Segmentation batch = segment(follower.map().to_grid(), options.segment, {}, trajectory);
    const eval::RoomScore score =
        eval::score_rooms(image_of(followed.labels), image_of(batch.labels));
    EXPECT_GT(score.pq, 0.95);
    EXPECT_GT(score.ari, 0.97);
    EXPECT_EQ(followed.doors.size() > 0, batch.doors.size() > 0);
    for (const RoomId id : ids_of(followed)) EXPECT_LT(index(id), followed.next_id);
    for (std::size_t i = 0; i < followed.labels.values.size(); ++i) {
        ASSERT_LE(followed.labels.values[i], followed.rooms.size());
    }
}

INSTANTIATE_TEST_SUITE_P(Pieces, FollowerOfPieces,
                         testing::Values(PieceSource::basins, PieceSource::spectral));

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
    EXPECT_FALSE(follower.refine().has_value());
    EXPECT_TRUE(follower.rooms().rooms.empty());
}

TEST(Follower, RefinesWhileThereIsTimeAndThenIsDone) {
    const std::vector<Scan> scans = scans_in(small_building(3));
    Follower follower;
    for (std::size_t i = 0; i < scans.size() / 2; ++i) follower.add_scan(scans[i]);
    // In slices, each of which a scan may follow.
    std::size_t num_slices = 0;
    while (follower.refine() && num_slices < 100) ++num_slices;
    EXPECT_LT(num_slices, 100U);
    follower.finish();
    const Segmentation refined = follower.rooms();
    const Segmentation batch = segment(follower.map().to_grid());
    EXPECT_GT(eval::score_rooms(image_of(refined.labels), image_of(batch.labels)).pq, 0.95);
    for (std::size_t i = scans.size() / 2; i < scans.size(); ++i) follower.add_scan(scans[i]);
}

TEST(Follower, PresetPaperIsFollowedScanByScan) {
    const std::vector<Scan> scans = scans_in(small_building(3));
    FollowOptions options;
    options.segment.preset = Preset::paper;
    options.segment.uncrossed = Uncrossed::kept;
    Follower follower(options);
    OccupancyMap map(options.resolution_m);
    std::size_t num_cuts = 0;
    for (std::size_t i = 0; i < 30; ++i) {
        const FollowUpdate update = follower.add_scan(scans[i]);
        integrate_scan(map, scans[i]);
        if (update.graph_nodes > 0) ++num_cuts;
        EXPECT_LE(update.graph_nodes, update.num_leaves);
    }
    EXPECT_GT(num_cuts, 1U);
    EXPECT_EQ(follower.map().to_raster().values, map.to_raster().values) << "one map rule";
    const Segmentation rooms = follower.rooms();
    ASSERT_GT(rooms.rooms.size(), 0U);
    const Raster<CellState> states = follower.map().to_grid().states;
    std::size_t num_free = 0;
    std::size_t num_in_rooms = 0;
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        if (states.values[i] != CellState::free) continue;
        ++num_free;
        if (rooms.labels.values[i] != 0) ++num_in_rooms;
    }
    EXPECT_GT(10 * num_in_rooms, 8 * num_free);
}

/// The share of a robot's poses that lie in a room, and the rooms that none lies in.
std::pair<double, std::size_t> way_in(const Follower& follower, const std::vector<Scan>& scans) {
    std::set<RoomId> crossed;
    std::size_t num_in = 0;
    for (const Scan& scan : scans) {
        const RoomId room = follower.room_at({scan.world_from_sensor.x, scan.world_from_sensor.y});
        if (room == RoomId{}) continue;
        ++num_in;
        crossed.insert(room);
    }
    return {static_cast<double>(num_in) / static_cast<double>(scans.size()),
            follower.num_rooms() - crossed.size()};
}

TEST(Follower, SlowARoomOffTheWayIsNoPartOfTheMapInEitherPreset) {
    const std::vector<Scan> scans = scans_in(small_building(3));
    for (const Preset preset : {Preset::paper, Preset::rooms}) {
        FollowOptions options;
        options.segment.preset = preset;
        options.segment.uncrossed = Uncrossed::dropped;
        Follower follower(options);
        // At each moment; half of the way leaves rooms that were looked into only.
        for (std::size_t i = 0; i < scans.size() / 2; ++i) follower.add_scan(scans[i]);
        std::vector<Scan> gone(scans.begin(),
                               scans.begin() + static_cast<std::ptrdiff_t>(scans.size() / 2));
        EXPECT_EQ(way_in(follower, gone).second, 0U);
        for (std::size_t i = scans.size() / 2; i < scans.size(); ++i) follower.add_scan(scans[i]);
        follower.finish();
        EXPECT_EQ(way_in(follower, scans).second, 0U);
        EXPECT_GT(way_in(follower, scans).first, 0.95) << "what it enters becomes a room";
    }
}

TEST(Follower, SlowPresetPaperEndsWithTheSubmapsOfItsMap) {
    const std::vector<Scan> scans = scans_in(small_building(3));
    FollowOptions options;
    options.segment.preset = Preset::paper;
    Follower follower(options);
    std::vector<Point> way;
    for (const Scan& scan : scans) {
        follower.add_scan(scan);
        way.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
    }
    follower.finish();
    EXPECT_FALSE(follower.refine().has_value()) << "by the method of the preset rooms";
    const Segmentation batch = segment(follower.map().to_grid(), options.segment, {}, way);
    const Segmentation followed = follower.rooms();
    EXPECT_GT(eval::score_rooms(image_of(followed.labels), image_of(batch.labels)).pq, 0.8);
}

TEST(Follower, ALoopClosureReplayedWithCorrectedPosesKeepsIds) {
    const std::vector<Scan> scans = scans_in(small_building(5));
    Follower follower;
    for (const Scan& scan : scans) follower.add_scan(scan);
    follower.finish();
    const std::set<RoomId> before = ids_of(follower.rooms());
    ASSERT_GT(before.size(), 3U);
    // The poses are corrected, the more the later they are; the map is made anew, and comes as one
    // patch of everything.
    OccupancyMap corrected(0.05);
    for (std::size_t i = 0; i < scans.size(); ++i) {
        Scan scan = scans[i];
        const double share = static_cast<double>(i) / static_cast<double>(scans.size());
        scan.world_from_sensor.x += 0.12 * share;
        scan.world_from_sensor.y -= 0.08 * share;
        integrate_scan(corrected, scan);
    }
    Raster<CellState> patch(follower.map().to_raster().box(), CellState::unknown);
    Box box = patch.box();
    box.include(corrected.to_raster().box());
    patch = Raster<CellState>(box, CellState::unknown);
    for (std::size_t i = 0; i < patch.values.size(); ++i) {
        patch.values[i] = corrected.state(patch.cell(i));
    }
    follower.update_cells(patch);
    const std::set<RoomId> after = ids_of(follower.rooms());
    std::size_t num_kept = 0;
    for (const RoomId id : before) num_kept += after.count(id);
    EXPECT_GE(num_kept + 1, before.size()) << num_kept << " of " << before.size();
}

TEST(Follower, StampsThatRepeatOrRunBackwardsAndOtherBeamsAreFollowed) {
    std::vector<Scan> scans = scans_in(small_building(3));
    scans.resize(60);
    Follower plain;
    for (const Scan& scan : scans) plain.add_scan(scan);
    Follower odd;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        Scan scan = scans[i];
        scan.time_s = i % 3 == 0 ? 5.0 : -static_cast<double>(i);
        odd.add_scan(scan);
    }
    EXPECT_EQ(odd.rooms().labels.values, plain.rooms().labels.values) << "stamps play no part";
    // Every other beam is missing: a coarser scanner.
    Scan coarse = scans.back();
    std::vector<float> ranges;
    for (std::size_t i = 0; i < coarse.ranges_m.size(); i += 2) {
        ranges.push_back(coarse.ranges_m[i]);
    }
    coarse.ranges_m = ranges;
    coarse.angle_step_rad *= 2.0;
    EXPECT_NO_THROW(odd.add_scan(coarse));
    // A jump of 100 m is a place far away; what was there stays.
    const std::set<RoomId> before = ids_of(odd.rooms());
    Scan jump = scans.back();
    jump.world_from_sensor.x += 100.0;
    odd.add_scan(jump);
    odd.finish();
    const std::set<RoomId> after = ids_of(odd.rooms());
    for (const RoomId id : before) EXPECT_EQ(after.count(id), 1U);
}

TEST(Follower, FansOfRaysAreGlimpsesAsInTheWholeMap) {
    Follower follower;
    follower.update_cells(test::flat_with_fans().map.states);
    follower.finish();
    const Segmentation rooms = follower.rooms();
    const Segmentation whole = segment(follower.map().to_grid());
    for (const Seen seen : {Seen::whole, Seen::partly, Seen::glimpse}) {
        std::multiset<double> areas_m2;
        std::multiset<double> expected_m2;
        for (const Room& room : test::seen_as(rooms, seen)) areas_m2.insert(room.area_m2);
        for (const Room& room : test::seen_as(whole, seen)) expected_m2.insert(room.area_m2);
        ASSERT_EQ(areas_m2.size(), expected_m2.size());
        // Where in a wall a doorway is cut depends on where the window begins.
        auto expected = expected_m2.begin();
        for (const double area_m2 : areas_m2) EXPECT_NEAR(area_m2, *expected++, 0.1);
    }
    EXPECT_EQ(test::seen_as(rooms, Seen::glimpse).size(), 5U);
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
    EXPECT_EQ(split.events.front().change, RoomChange::split);
    EXPECT_EQ(split.events.front().other, first) << "the larger part keeps the id";
    const FollowUpdate merged =
        follower.update_cells(Raster<CellState>({100, 10}, 4, 100, CellState::free));
    EXPECT_EQ(follower.num_rooms(), 1U);
    ASSERT_FALSE(merged.events.empty());
    EXPECT_EQ(merged.events.front().change, RoomChange::merged);
    EXPECT_EQ(merged.events.front().other, first);
    EXPECT_EQ(follower.rooms().rooms.front().id, first);
}

}  // namespace
}  // namespace quadcut
