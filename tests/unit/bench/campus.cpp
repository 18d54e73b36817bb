// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/campus.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/map/connected_parts.hpp"
#include "quadcut/segment/inside.hpp"
#include "tests/unit/map/reference_tree.hpp"

namespace quadcut {
namespace {

TEST(Campus, GroundIsWhatIsUnknownAround) {
    Raster<CellState> states = test::grid_from_text({"????????",  //
                                                     "?######?",  //
                                                     "?#..#?#?",  //
                                                     "?####.##"})
                                   .states;
    campus::open_ground(states);
    const Raster<CellState> expected = test::grid_from_text({"........",  //
                                                             ".######.",  //
                                                             ".#..#?#.",  //
                                                             ".####.##"})
                                           .states;
    EXPECT_EQ(states.values, expected.values);
}

TEST(Campus, BuildingsLieApart) {
    const std::vector<Raster<CellState>> buildings{
        {{0, 0}, 300, 100}, {{0, 0}, 200, 150}, {{0, 0}, 400, 50}};
    Cell size;
    const std::vector<Cell> places = campus::places(buildings, 800, size);
    ASSERT_EQ(places.size(), 3U);
    EXPECT_EQ(places[0], (Cell{kStreetCells, kStreetCells}));
    EXPECT_EQ(places[1], (Cell{2 * kStreetCells + 300, kStreetCells}));
    // A row of its own, above the higher of the two below.
    EXPECT_EQ(places[2], (Cell{kStreetCells, 2 * kStreetCells + 150}));
    EXPECT_EQ(size, (Cell{500 + 3 * kStreetCells, 200 + 3 * kStreetCells}));
}

TEST(Campus, SegmentsAsBuildingsOnOpenGround) {
    const GridMap map = campus_of(80);
    EXPECT_EQ(map.states.values, campus_of(80).states.values);
    const ConnectedParts free = free_parts(map.states);
    // The ground, two buildings, and shafts that nobody can enter.
    EXPECT_GE(free.count, 3U);
    const Raster<std::uint8_t> kept = inside(map, {}, 1.0);
    EXPECT_EQ(map.states.at({0, 0}), CellState::free);
    EXPECT_EQ(kept.at({0, 0}), 0);
    // 80 rooms of 10 to 40 m^2.
    const auto num_kept = std::count(kept.values.begin(), kept.values.end(), 1);
    EXPECT_GT(num_kept, 80 * 10 * 400);
    EXPECT_LT(num_kept, 80 * 40 * 400);
}

}  // namespace
}  // namespace quadcut
