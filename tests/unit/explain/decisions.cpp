// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/explain/decisions.hpp"

#include <gtest/gtest.h>

#include "quadcut/base/stage_clock.hpp"
#include "quadcut/rooms/fuse.hpp"
#include "quadcut/segment/inside.hpp"
#include "sim/building.hpp"
#include "tests/unit/rooms/drawing.hpp"

namespace quadcut {
namespace {

DecidedCut decided(const GridMap& map, const RoomsOptions& options = {}) {
    const Raster<std::uint8_t> free = mask_of(map, CellState::free);
    return cut_with_decisions({free, map.states, map.resolution_m, {}, 0, {}}, options, {});
}

std::size_t count(const DecidedCut& cut, Verdict verdict) {
    std::size_t result = 0;
    for (const Decision& decision : cut.decisions) result += decision.verdict == verdict ? 1 : 0;
    return result;
}

TEST(Decisions, ChangeNothing) {
    sim::BuildingOptions building;
    building.seed = 31;
    GridMap map = sim::generate_building(building).map;
    map.states.origin = {0, 0};
    const Raster<std::uint8_t> free = mask_of(map, CellState::free);
    StageClock clock;
    const RoomsCut plain =
        cut_into_rooms({free, map.states, map.resolution_m, {}, 0, {}}, RoomsOptions{}, clock, {});
    EXPECT_TRUE(decided(map).cut.rooms.values == plain.rooms.values);
}

TEST(Decisions, OfTwoRoomsTheDoorIsTheOneCut) {
    const DecidedCut cut = decided(test::two_rooms());
    ASSERT_EQ(count(cut, Verdict::cut), 1U);
    const Decision& door = cut.decisions.front();
    EXPECT_EQ(door.verdict, Verdict::cut);
    EXPECT_NEAR(2.0 * door.border.narrowing.half_width_m, 0.9, 0.06);
    EXPECT_GE(door.log_odds, fuse_threshold(0.5));
}

TEST(Decisions, ANarrowerDoorWidthMakesItTooWide) {
    RoomsOptions options;
    options.door_width_m = 0.5;
    const DecidedCut cut = decided(test::two_rooms(), options);
    EXPECT_EQ(count(cut, Verdict::cut), 0U);
    EXPECT_GE(count(cut, Verdict::too_wide), 1U);
}

}  // namespace
}  // namespace quadcut
