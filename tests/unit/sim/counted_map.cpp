// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/counted_map.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut::sim {
namespace {

Scan beam(float range) {
    Scan scan;
    scan.world_from_sensor = {0.25, 0.25, 0.0};
    scan.angle_step_rad = 0.1;
    scan.max_range_m = 10.0;
    scan.ranges_m = {range};
    return scan;
}

CellState state_at(const GridMap& map, double x, double y) {
    const Cell cell{
        static_cast<std::int32_t>(std::floor((x - map.map_from_image.x) / map.resolution_m)),
        static_cast<std::int32_t>(std::floor((y - map.map_from_image.y) / map.resolution_m))};
    return map.states.contains(cell) ? map.states.at(cell) : CellState::unknown;
}

TEST(CountedMap, ABeamIsALineWithAnEnd) {
    const GridMap map = counted_map(std::vector<Scan>{beam(3.0F)}, 0.1);
    EXPECT_EQ(state_at(map, 0.3, 0.25), CellState::free);
    EXPECT_EQ(state_at(map, 3.1, 0.25), CellState::free);
    EXPECT_EQ(state_at(map, 3.25, 0.25), CellState::occupied);
    EXPECT_EQ(state_at(map, 1.0, 0.35), CellState::unknown);
}

TEST(CountedMap, BetweenFreeAndOccupiedNothingIsKnown) {
    // One hit in five, one in ten.
    std::vector<Scan> scans(5, beam(3.0F));
    scans[0] = beam(2.0F);
    EXPECT_EQ(state_at(counted_map(scans, 0.1), 2.25, 0.25), CellState::unknown);
    scans.resize(10, beam(3.0F));
    EXPECT_EQ(state_at(counted_map(scans, 0.1), 2.25, 0.25), CellState::free);
}

TEST(CountedMap, FewVisitsAreNone) {
    std::vector<Scan> scans(2, beam(3.0F));
    EXPECT_EQ(state_at(counted_map(scans, 0.1, {3}), 1.0, 0.25), CellState::unknown);
    scans.resize(3, beam(3.0F));
    EXPECT_EQ(state_at(counted_map(scans, 0.1, {3}), 1.0, 0.25), CellState::free);
}

TEST(CountedMap, NoReturnSaysNothing) {
    const GridMap map = counted_map(std::vector<Scan>{beam(1.0F), beam(10.0F)}, 0.1);
    EXPECT_EQ(state_at(map, 1.25, 0.25), CellState::occupied);
    EXPECT_EQ(state_at(map, 2.0, 0.25), CellState::unknown);
}

}  // namespace
}  // namespace quadcut::sim
