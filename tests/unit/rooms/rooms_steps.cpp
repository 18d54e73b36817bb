// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/map/clearance.hpp"
#include "quadcut/rooms/basins.hpp"
#include "quadcut/rooms/door_model.hpp"
#include "quadcut/rooms/fuse.hpp"
#include "quadcut/rooms/narrowing.hpp"
#include "quadcut/rooms/open_space.hpp"
#include "quadcut/rooms/opening.hpp"
#include "quadcut/segment/inside.hpp"
#include "tests/unit/rooms/drawing.hpp"
#include "tests/unit/rooms/plain_ground.hpp"

namespace quadcut {
namespace {

struct TwoRooms {
    GridMap map = test::two_rooms();
    Raster<std::uint8_t> free = mask_of(map, CellState::free);
    Raster<float> clearance = clearance_m(free, map.resolution_m);
    Basins basins = build_basins(clearance, map.resolution_m);
};

TEST(Basins, CoverTheOpenSpaceAndNothingElse) {
    const TwoRooms rooms;
    std::set<std::uint32_t> labels;
    for (std::size_t i = 0; i < rooms.free.values.size(); ++i) {
        EXPECT_EQ(rooms.free.values[i] != 0, rooms.basins.labels.values[i] != 0);
        labels.insert(rooms.basins.labels.values[i]);
    }
    labels.erase(0);
    EXPECT_EQ(labels.size(), rooms.basins.count);
    EXPECT_EQ(*labels.rbegin(), rooms.basins.count);
}

TEST(Basins, AnEmptyMapHasNone) {
    EXPECT_EQ(build_basins(Raster<float>{}, 0.05).count, 0U);
    EXPECT_EQ(build_basins(Raster<float>({0, 0}, 5, 5), 0.05).count, 0U);
}

TEST(Narrowing, ADoorwayIsMeasuredAsOne) {
    const TwoRooms rooms;
    // One region each side of the middle of the door.
    Raster<std::uint32_t> halves({0, 0}, rooms.free.width, rooms.free.height);
    for (std::size_t i = 0; i < halves.values.size(); ++i) {
        if (rooms.free.values[i] != 0) halves.values[i] = halves.cell(i).x < 84 ? 1 : 2;
    }
    const test::PlainGround plain(rooms.clearance, rooms.map.resolution_m);
    RegionGraph regions(halves, 2, plain.ground());
    regions.describe_all({});
    const Saddle saddle{{83, 38}, {84, 38}, rooms.clearance.at({83, 38})};
    NarrowingGauge gauge = plain.gauge();
    const BorderMeasure border = regions.measure_at(saddle, saddle, {1, 2}, gauge);
    const Narrowing& narrowing = border.narrowing;
    EXPECT_NEAR(saddle.clearance_m, 0.45F, 0.03F);
    EXPECT_GT(narrowing.narrower.peak_m.back(), 2.0 * narrowing.half_width_m);
    EXPECT_GE(narrowing.wider.peak_m.back(), narrowing.narrower.peak_m.back());
    EXPECT_GE(narrowing.narrower.peak_m[2], narrowing.narrower.peak_m[0]);
    EXPECT_GT(narrowing.narrower.reach_m, 3.0);
    EXPECT_GT(narrowing.narrower.area_m2[0], 5.0);
    const Opening& opening = narrowing.opening;
    ASSERT_TRUE(opening.has_jambs);
    EXPECT_EQ(std::set<std::int32_t>({opening.jambs[0].y, opening.jambs[1].y}),
              std::set<std::int32_t>({29, 48}));
    EXPECT_NEAR(opening.width_m, 0.95, 0.051);
    EXPECT_GT(opening.thin_wall_m[0], 0.3) << "thin walls on both sides of the door";
    for (const auto& side : opening.widening_m) {
        for (const double beyond_jamb : side) EXPECT_GT(beyond_jamb, 1.0) << "rooms are wider";
    }
    EXPECT_GT(door_log_odds(border), 0.0);
    // The same gauge gives the same answer again: no state is left from the first walk.
    EXPECT_DOUBLE_EQ(door_log_odds(regions.measure_at(saddle, saddle, {1, 2}, gauge)),
                     door_log_odds(border));
}

TEST(Narrowing, TheMiddleOfACorridorIsNoDoor) {
    GridMap map;
    map.states = Raster<CellState>({0, 0}, 200, 44, CellState::occupied);
    for (std::int32_t y = 2; y < 42; ++y) {
        for (std::int32_t x = 2; x < 198; ++x) map.states.at({x, y}) = CellState::free;
    }
    const Raster<float> clearance = clearance_m(mask_of(map, CellState::free), 0.05);
    Raster<std::uint32_t> halves({0, 0}, 200, 44);
    for (std::size_t i = 0; i < halves.values.size(); ++i) {
        if (clearance.values[i] > 0.0F) halves.values[i] = halves.cell(i).x < 100 ? 1 : 2;
    }
    const test::PlainGround plain(clearance, 0.05);
    RegionGraph regions(halves, 2, plain.ground());
    regions.describe_all({});
    NarrowingGauge gauge = plain.gauge();
    const Saddle saddle{{99, 21}, {100, 21}, clearance.at({99, 21}), 40};
    const BorderMeasure border = regions.measure_at(saddle, saddle, {1, 2}, gauge);
    EXPECT_LT(door_log_odds(border), 0.0);
    for (const auto& side : border.narrowing.opening.widening_m) {
        for (const double beyond_jamb : side) EXPECT_LT(beyond_jamb, 0.01) << "the walls go on";
    }
}

TEST(Opening, TheMouthOfAnAlcoveWidensOnOneSideOnly) {
    // An alcove 2 m wide, open over its whole width to a corridor that runs past it.
    Raster<std::uint8_t> open({0, 0}, 200, 100);
    for (std::int32_t y = 5; y < 40; ++y) {
        for (std::int32_t x = 5; x < 195; ++x) open.at({x, y}) = 1;
    }
    for (std::int32_t y = 40; y < 90; ++y) {
        for (std::int32_t x = 80; x < 120; ++x) open.at({x, y}) = 1;
    }
    const Raster<float> clearance = clearance_m(open, 0.05);
    const Opening mouth =
        measure_opening(clearance, 0.05, {{99, 41}, {99, 40}, clearance.at({99, 41})});
    ASSERT_TRUE(mouth.has_jambs);
    EXPECT_GT(mouth.widening_m[0][0], 1.0) << "the corridor, beyond both jambs";
    EXPECT_LT(mouth.widening_m[1][1], 0.1) << "the alcove, beyond neither";
}

TEST(DoorModel, MoreWallNeverMakesADoorLessLikely) {
    Narrowing narrowing;
    narrowing.half_width_m = 0.5;
    narrowing.narrower = {{0.8, 1.0, 1.0}, {6.0, 10.0}, {0.9, 1.1}, 4.0, 12.0, 1.0, 2};
    narrowing.wider = {{0.8, 1.2, 1.5}, {8.0, 14.0}, {1.0, 1.2}, 5.0, 20.0, 1.5, 3};
    narrowing.border_ratio = 1.0;
    narrowing.opening.has_jambs = true;
    narrowing.opening.width_m = 1.0;
    narrowing.share_in_line = 1.0;
    double before = -100.0;
    const auto expect_no_less_likely = [&] {
        BorderMeasure border = test::plain_border(narrowing);
        border.narrower = test::rectangle(6.0, 2.0);
        border.wider = test::rectangle(6.7, 3.0);
        border.joined = test::rectangle(6.7, 5.0);
        const double now = door_log_odds(border);
        EXPECT_GE(now, before);
        before = now;
    };
    for (const double wall : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
        narrowing.opening.thin_wall_m = {wall, wall};
        narrowing.opening.flush_wall_m = {wall, wall};
        expect_no_less_likely();
    }
    for (const double in_line : {0.0, 1.0, 2.0, 3.0}) {
        narrowing.less_wall_m = in_line;
        narrowing.more_wall_m = in_line;
        expect_no_less_likely();
    }
    for (const double beyond : {0.0, 0.5, 1.0, 1.5}) {
        narrowing.opening.widening_m = {{{beyond, beyond}, {beyond, beyond}}};
        expect_no_less_likely();
    }
    EXPECT_GT(before, 0.0);
}

/// The basins of the two rooms, to be fused.
struct TwoRoomsInPieces : TwoRooms {
    test::PlainGround plain{clearance, map.resolution_m};
    RegionGraph regions{basins.labels, basins.count, plain.ground()};

    [[nodiscard]] std::uint32_t num_regions() const {
        std::uint32_t count = 0;
        for (std::uint32_t piece = 1; piece <= regions.num_pieces(); ++piece) {
            if (regions.is_region(piece)) ++count;
        }
        return count;
    }
};

TEST(Fuse, KeepsTheCutInTheDoorwayAndNoOther) {
    TwoRoomsInPieces rooms;
    Fuser(rooms.regions, 4.0).fuse_below(0.0);
    fuse_small_regions(rooms.regions, 1.5, 0.4);
    ASSERT_EQ(rooms.num_regions(), 2U);
    Raster<std::uint32_t> labels = rooms.basins.labels;
    relabel(rooms.regions, labels);
    EXPECT_NE(labels.at({40, 40}), labels.at({120, 40}));
    // The border lies in the doorway.
    for (std::int32_t x = 1; x < labels.width; ++x) {
        if (labels.at({x, 38}) != labels.at({x - 1, 38}) && labels.at({x, 38}) != 0 &&
            labels.at({x - 1, 38}) != 0) {
            EXPECT_NEAR(x, 84, 4);
        }
    }
}

TEST(Fuse, OpeningsBeyondTheDoorWidthSeparateNothing) {
    TwoRoomsInPieces rooms;
    Fuser(rooms.regions, 0.6).fuse_below(0.0);
    EXPECT_EQ(rooms.num_regions(), 1U);
}

TEST(Fuse, SmallAndNarrowRegionsJoinANeighbour) {
    TwoRoomsInPieces small;
    Fuser(small.regions, 4.0).fuse_below(0.0);
    fuse_small_regions(small.regions, 20.0, 0.0);
    EXPECT_EQ(small.num_regions(), 1U);
    TwoRoomsInPieces narrow;
    Fuser(narrow.regions, 4.0).fuse_below(0.0);
    fuse_small_regions(narrow.regions, 0.0, 10.0);
    EXPECT_EQ(narrow.num_regions(), 1U);
}

TEST(Fuse, FinerGranularityOnlyEverDividesRooms) {
    std::uint32_t previous = 0;
    for (const double granularity : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        TwoRoomsInPieces rooms;
        Fuser(rooms.regions, 4.0).fuse_below(fuse_threshold(granularity));
        EXPECT_GE(rooms.num_regions(), previous);
        previous = rooms.num_regions();
    }
    EXPECT_GT(fuse_threshold(0.5), 0.0) << "a cut needs more than even odds";
}

TEST(Fuse, ToStopHalfwayChangesNothing) {
    TwoRoomsInPieces at_once;
    Fuser(at_once.regions, 4.0).fuse_below(3.0);
    TwoRoomsInPieces in_steps;
    Fuser fuser(in_steps.regions, 4.0);
    for (const double log_odds : {-6.0, -3.0, 0.0, 3.0}) fuser.fuse_below(log_odds);
    for (std::uint32_t piece = 1; piece <= at_once.regions.num_pieces(); ++piece) {
        EXPECT_EQ(in_steps.regions.region_of(piece), at_once.regions.region_of(piece));
    }
}

TEST(RegionGraph, WhatIsMeasuredAheadIsTheSame) {
    TwoRoomsInPieces ahead;
    std::vector<RegionPair> pairs;
    for (std::uint32_t a = 1; a <= ahead.regions.num_pieces(); ++a) {
        for (const auto& [b, saddle] : ahead.regions.saddles(a)) {
            if (a < b) pairs.emplace_back(a, b);
        }
    }
    ahead.regions.look_at(pairs, Executor{2});
    TwoRoomsInPieces asked;
    for (std::uint32_t a = 1; a <= asked.regions.num_pieces(); ++a) {
        for (const auto& [b, saddle] : asked.regions.saddles(a)) {
            EXPECT_EQ(door_log_odds(ahead.regions.measure(a, b)),
                      door_log_odds(asked.regions.measure(a, b)));
        }
    }
}

TEST(RegionGraph, WhatAJoinDoesNotComeNearToIsTheSameAsMeasuredAnew) {
    TwoRoomsInPieces kept;
    TwoRoomsInPieces anew;
    Fuser(kept.regions, 4.0).fuse_below(0.0);
    for (std::uint32_t piece = 1; piece <= anew.regions.num_pieces(); ++piece) {
        const std::uint32_t region = kept.regions.region_of(piece);
        if (region != piece) anew.regions.join(region, piece);
    }
    for (std::uint32_t region = 1; region <= kept.regions.num_pieces(); ++region) {
        for (const auto& [other, saddle] : kept.regions.saddles(region)) {
            EXPECT_EQ(door_cues(kept.regions.measure(region, other)),
                      door_cues(anew.regions.measure(region, other)));
        }
    }
}

TEST(OpenSpace, ThePierBetweenTwoDoorsIsWall) {
    // A wall 0.1 m thick with two doors of 1 m, and 0.5 m of wall between them, as an obstacle by
    // itself; a bin as large stands in the room.
    Raster<std::uint8_t> kept({0, 0}, 100, 100);
    for (std::int32_t y = 2; y < 98; ++y) {
        for (std::int32_t x = 2; x < 98; ++x) {
            const bool is_door = (x >= 25 && x < 45) || (x >= 55 && x < 75);
            const bool is_wall = (y == 50 || y == 51) && !is_door;
            const bool is_bin = x >= 45 && x < 55 && (y == 80 || y == 81);
            if (!is_wall && !is_bin) kept.at({x, y}) = 1;
        }
    }
    const Raster<std::uint8_t> open = open_space(kept, 0.05, 0.3, {});
    EXPECT_EQ(open.at({50, 50}), 0);
    EXPECT_EQ(open.at({50, 80}), 1);
}

TEST(OpenSpace, WhatAFlawCutsOffAWallIsWallAndALegBesideItIsNot) {
    // A wall 0.1 m thick with a flaw of one cell, 0.6 m from its end; a leg stands as near to the
    // end of another wall.
    Raster<std::uint8_t> kept({0, 0}, 120, 100);
    for (std::int32_t y = 2; y < 98; ++y) {
        for (std::int32_t x = 2; x < 118; ++x) {
            const bool is_wall = (y == 30 || y == 31) && x < 60 && x != 47;
            const bool is_other = (y == 70 || y == 71) && x < 47;
            const bool is_leg = (y == 70 || y == 71) && (x == 48 || x == 49);
            if (!is_wall && !is_other && !is_leg) kept.at({x, y}) = 1;
        }
    }
    const Raster<std::uint8_t> open = open_space(kept, 0.05, 0.3, {});
    EXPECT_EQ(open.at({52, 30}), 0) << "the end of the wall";
    EXPECT_EQ(open.at({48, 70}), 1) << "the leg";
}

TEST(OpenSpace, WhatStandsInANarrowPlaceIsFurniture) {
    // A corridor of 1 m with a leg in its middle.
    Raster<std::uint8_t> kept({0, 0}, 100, 24);
    for (std::int32_t y = 2; y < 22; ++y) {
        for (std::int32_t x = 2; x < 98; ++x) {
            if (x < 50 || x > 51 || y < 11 || y > 12) kept.at({x, y}) = 1;
        }
    }
    EXPECT_EQ(open_space(kept, 0.05, 0.3, {}).at({50, 11}), 1);
}

TEST(OpenSpace, LegsAreFurnitureAndWallsAreNot) {
    const std::vector<std::string> rows{"####################",  //
                                        "#..................#",  //
                                        "#..##..............#",  // a leg of 0.2 x 0.2 m
                                        "#..##......####....#",  // a box drawn as an outline
                                        "#..........#..#....#",  //
                                        "#..........####....#",  //
                                        "#...............####",  // a stub of wall
                                        "#..................#",  //
                                        "####################"};
    Raster<std::uint8_t> kept = test::drawn_mask(rows, '.', 2);
    // The inside of the box is no part of what is kept.
    for (std::int32_t y = 8; y < 10; ++y) {
        for (std::int32_t x = 24; x < 28; ++x) kept.at({x, y}) = 0;
    }
    const Raster<std::uint8_t> open = open_space(kept, 0.05, 0.3, {});
    EXPECT_EQ(open.at({7, 12}), 1) << "leg";
    EXPECT_EQ(open.at({22, 8}), 1) << "outline of the box";
    EXPECT_EQ(open.at({25, 8}), 1) << "inside of the box";
    EXPECT_EQ(open.at({34, 5}), 0) << "stub of wall";
    EXPECT_EQ(open.at({0, 0}), 0) << "outer wall";
    EXPECT_EQ(open_space(kept, 0.05, 0.01, {}).values, kept.values) << "nothing is that small";
}

TEST(OpenSpace, PostsInLineAreAWallAndOneAloneIsFurniture) {
    // Posts of 0.1 m, 0.1 m apart, in a row that touches no wall; one stands aside.
    Raster<std::uint8_t> kept({0, 0}, 200, 120);
    const auto is_post = [](std::int32_t x, std::int32_t y) {
        return (x == 100 || x == 101) && y >= 20 && y < 100 && y % 4 < 2;
    };
    for (std::int32_t y = 2; y < 118; ++y) {
        for (std::int32_t x = 2; x < 198; ++x) {
            const bool is_alone = (x == 50 || x == 51) && (y == 60 || y == 61);
            if (!is_post(x, y) && !is_alone) kept.at({x, y}) = 1;
        }
    }
    const WallLines lines = find_wall_lines(kept, 0.05, 4.0);
    const Raster<std::uint8_t> open = open_space(kept, 0.05, 0.3, lines);
    EXPECT_EQ(open.at({100, 60}), 0);
    EXPECT_EQ(open.at({101, 20}), 0) << "the last one";
    EXPECT_EQ(open.at({50, 60}), 1);
    EXPECT_EQ(open_space(kept, 0.05, 0.3, {}).at({100, 60}), 1) << "each by itself";
}

TEST(OpenSpace, LegsThatARobotFitsBetweenAreFurniture) {
    Raster<std::uint8_t> kept({0, 0}, 200, 120);
    for (std::int32_t y = 2; y < 118; ++y) {
        for (std::int32_t x = 2; x < 198; ++x) {
            const bool is_leg = (x == 100 || x == 101) && y >= 20 && y < 100 && y % 20 < 2;
            if (!is_leg) kept.at({x, y}) = 1;
        }
    }
    const WallLines lines = find_wall_lines(kept, 0.05, 4.0);
    EXPECT_EQ(open_space(kept, 0.05, 0.3, lines).at({100, 60}), 1);
}

}  // namespace
}  // namespace quadcut
