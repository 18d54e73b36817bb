// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/reality.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"

namespace quadcut::sim {
namespace {

RealityOptions options(std::uint64_t seed, double clutter = 1.0) {
    RealityOptions result;
    result.seed = seed;
    result.num_rooms = 12;
    result.clutter = clutter;
    return result;
}

TEST(Reality, SameOptionsGiveTheSameBytes) {
    const RealMap a = scan_as_robots_do(options(3));
    const RealMap b = scan_as_robots_do(options(3));
    EXPECT_EQ(a.map.states.values, b.map.states.values);
    EXPECT_EQ(a.truth.values, b.truth.values);
    EXPECT_EQ(a.trajectory, b.trajectory);
    EXPECT_NE(a.map.states.values, scan_as_robots_do(options(4)).map.states.values);
}

TEST(Reality, TruthHasTheCellsOfTheMapAndOnlyItsFreeOnes) {
    const RealMap real = scan_as_robots_do(options(5));
    ASSERT_EQ(real.truth.values.size(), real.map.states.values.size());
    ASSERT_EQ(real.truth.width, real.map.states.width);
    std::size_t num_labelled = 0;
    for (std::size_t i = 0; i < real.truth.values.size(); ++i) {
        if (real.truth.values[i] == 0) continue;
        ++num_labelled;
        EXPECT_EQ(real.map.states.values[i], CellState::free);
        EXPECT_LE(real.truth.values[i], real.building.rooms.size());
    }
    EXPECT_GT(num_labelled, 1000U);
}

// Rays out of windows: free cells outside of the building's walls, which are nobody's room.
TEST(Reality, FansOutsideAreNobodysRoom) {
    std::size_t num_outside = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const RealMap real = scan_as_robots_do(options(seed));
        const GridMap& bare = real.building.bare;
        const Pose bare_from_map = compose(inverse(bare.map_from_image), real.map.map_from_image);
        for (std::size_t i = 0; i < real.truth.values.size(); ++i) {
            if (real.map.states.values[i] != CellState::free) continue;
            const Cell cell = real.truth.cell(i);
            const Point at = transform(bare_from_map, {(cell.x + 0.5) * real.map.resolution_m,
                                                       (cell.y + 0.5) * real.map.resolution_m});
            const Cell there{static_cast<std::int32_t>(std::floor(at.x / bare.resolution_m)),
                             static_cast<std::int32_t>(std::floor(at.y / bare.resolution_m))};
            const bool is_outside =
                !bare.states.contains(there) || bare.states.at(there) == CellState::unknown;
            if (!is_outside) continue;
            ++num_outside;
            EXPECT_EQ(real.truth.values[i], 0U);
        }
    }
    EXPECT_GT(num_outside, 2000U);
}

TEST(Reality, TheRobotLeavesRoomsOutAndNamesNoneThatItHardlySaw) {
    std::size_t num_rooms = 0;
    std::size_t num_named = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const RealMap real = scan_as_robots_do(options(seed));
        std::vector<std::size_t> num_cells(real.building.rooms.size() + 1, 0);
        for (const std::uint32_t room : real.truth.values) ++num_cells[room];
        num_rooms += real.building.rooms.size();
        for (std::size_t room = 1; room < num_cells.size(); ++room) {
            if (num_cells[room] == 0) continue;
            ++num_named;
            const double seen_m2 = 0.0025 * static_cast<double>(num_cells[room]);
            EXPECT_GE(seen_m2, std::min(1.5, real.building.rooms[room - 1].area_m2));
        }
    }
    EXPECT_LT(num_named, num_rooms);
    EXPECT_GT(4 * num_named, num_rooms);
}

TEST(Reality, WithoutClutterEveryRoomIsVisited) {
    const RealMap real = scan_as_robots_do(options(2, 0.0));
    std::vector<std::size_t> num_cells(real.building.rooms.size() + 1, 0);
    for (const std::uint32_t room : real.truth.values) ++num_cells[room];
    EXPECT_EQ(std::count(num_cells.begin() + 1, num_cells.end(), 0U), 0);
    EXPECT_EQ(real.building_options.clutter, 0.0);
}

TEST(Reality, SaysWhatIsOutOfRange) {
    EXPECT_THROW((void)scan_as_robots_do(options(1, 1.5)), InputError);
    RealityOptions few = options(1);
    few.num_rooms = 2;
    EXPECT_THROW((void)scan_as_robots_do(few), InputError);
}

}  // namespace
}  // namespace quadcut::sim
