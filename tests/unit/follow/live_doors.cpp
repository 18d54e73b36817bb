// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/live_doors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "bench/shared_folder.hpp"
#include "io/carmen.hpp"
#include "quadcut/follow/follower.hpp"
#include "tests/unit/follow/followed.hpp"

namespace quadcut {
namespace {

/// How the doors that are kept up to date agree with those of the whole map.
struct DoorAgreement {
    std::size_t num_live = 0;
    std::size_t num_whole = 0;
    /// Of doors between the same rooms; the larger distance of two jambs.
    std::size_t num_within_10_cm = 0;
    double worst_jamb_m = 0.0;
    double worst_width_m = 0.0;
    double worst_confidence = 0.0;
};

double jamb_distance(const Door& p, const Door& q) {
    return std::min(std::max(distance(p.jamb_1, q.jamb_1), distance(p.jamb_2, q.jamb_2)),
                    std::max(distance(p.jamb_1, q.jamb_2), distance(p.jamb_2, q.jamb_1)));
}

DoorAgreement agreement_of(const Follower& follower) {
    const std::vector<Door> whole = follower.rooms().doors;
    DoorAgreement result{follower.state().doors.size(), whole.size()};
    for (const Door& door : whole) {
        const Door* nearest = nullptr;
        for (const auto& [id, live] : follower.state().doors) {
            if (live.door.a != door.a || live.door.b != door.b) continue;
            const bool is_nearer = nearest == nullptr ||
                                   jamb_distance(live.door, door) < jamb_distance(*nearest, door);
            if (is_nearer) nearest = &live.door;
        }
        if (nearest == nullptr) continue;
        const double far = jamb_distance(*nearest, door);
        if (far > 0.1) continue;
        ++result.num_within_10_cm;
        result.worst_jamb_m = std::max(result.worst_jamb_m, far);
        result.worst_width_m =
            std::max(result.worst_width_m, std::abs(nearest->width_m - door.width_m));
        result.worst_confidence =
            std::max(result.worst_confidence, std::abs(nearest->confidence - door.confidence));
    }
    std::printf(
        "%zu live doors, %zu of the whole map, %zu within 0.1 m; of these jambs differ by "
        "at most %.3f m, widths by %.3f m, confidence by %.3f\n",
        result.num_live, result.num_whole, result.num_within_10_cm, result.worst_jamb_m,
        result.worst_width_m, result.worst_confidence);
    return result;
}

TEST(LiveDoors, AreThoseOfTheWholeMap) {
    for (const std::uint64_t seed : {3U, 5U, 8U}) {
        Follower follower;
        for (const Scan& scan : test::scans_in(test::small_building(seed))) follower.add_scan(scan);
        follower.finish();
        const DoorAgreement agreement = agreement_of(follower);
        EXPECT_GT(agreement.num_whole, 3U);
        EXPECT_EQ(agreement.num_live, agreement.num_whole);
        EXPECT_EQ(agreement.num_within_10_cm, agreement.num_whole);
    }
}

TEST(LiveDoors, OfARealLogAreThoseOfTheWholeMapSlow) {
    const std::filesystem::path log = shared_path("data/logs/intel.log");
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "no " << log;
    Follower follower;
    for (const Scan& scan : io::read_carmen_log(log).scans) follower.add_scan(scan);
    follower.finish();
    const DoorAgreement agreement = agreement_of(follower);
    EXPECT_GT(agreement.num_whole, 20U);
    EXPECT_GE(10 * agreement.num_within_10_cm, 9 * agreement.num_whole);
    EXPECT_LE(10 * agreement.num_live, 11 * agreement.num_whole);
}

TEST(LiveDoors, FollowEdits) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    ASSERT_EQ(follower.state().doors.size(), 1U);
    const auto [id, placed] = *follower.state().doors.begin();
    EXPECT_NEAR(placed.door.width_m, 0.9, 0.1);
    const RoomId right = follower.room_at({9.0, 3.0});
    const Edited split = follower.edit(test::split({9.0, 1.0}, {9.0, 5.0}));
    ASSERT_EQ(follower.state().doors.size(), 2U);
    EXPECT_EQ(agreement_of(follower).num_within_10_cm, 2U);
    follower.apply(split.inverse);
    ASSERT_EQ(follower.state().doors.size(), 1U);
    EXPECT_EQ(follower.state().doors.begin()->first, id) << "the other was not touched";
    follower.edit(test::lock(right));
    follower.update_cells(Raster<CellState>({100, 50}, 4, 18, CellState::occupied));
    EXPECT_TRUE(follower.state().doors.empty()) << "the door is shut";
}

TEST(LiveDoors, OneThatMovesALittleIsTheSame) {
    Follower follower;
    follower.update_cells(test::hall_with_wall());
    ASSERT_EQ(follower.state().doors.size(), 1U);
    const auto before = *follower.state().doors.begin();
    const FollowUpdate update =
        follower.update_cells(Raster<CellState>({100, 50}, 4, 3, CellState::occupied));
    ASSERT_EQ(follower.state().doors.size(), 1U);
    EXPECT_EQ(follower.state().doors.begin()->first, before.first);
    EXPECT_LT(follower.state().doors.begin()->second.door.width_m, before.second.door.width_m);
    EXPECT_EQ(update.changes.doors, std::vector{before.first});
}

}  // namespace
}  // namespace quadcut
