// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/floor_cells.hpp"

#include <gtest/gtest.h>

#include "tests/unit/io/floor_drawing.hpp"

namespace quadcut::draw {
namespace {

/// The sorted cells as text: letters rooms, '#' wall, '+' thin unknown, '.' loose free, ' ' paper;
/// on it 'F' furniture and 'I' its inside.
std::vector<std::string> sorted(const io::test::DrawnFloor& floor) {
    const FloorCells cells = sort_floor_cells(floor.map, floor.segmentation.labels);
    const Raster<std::uint16_t>& ground = cells.ground;
    std::vector<std::string> rows(static_cast<std::size_t>(ground.height),
                                  std::string(static_cast<std::size_t>(ground.width), ' '));
    for (std::size_t i = 0; i < ground.values.size(); ++i) {
        const Cell cell = ground.cell(i);
        char& mark = rows[static_cast<std::size_t>(ground.origin.y + ground.height - 1 - cell.y)]
                         [static_cast<std::size_t>(cell.x - ground.origin.x)];
        const std::uint32_t value = ground.values[i];
        if (value > 0 && value < kFirstNonRoom) mark = static_cast<char>('a' + value - 1);
        if (value == kLooseFree) mark = '.';
        if (value == kWallCore) mark = '+';
        if (value == kWall) mark = '#';
        if (cells.furniture.values[i] == kFurniture) mark = 'F';
        if (cells.furniture.values[i] == kFurnitureInside) mark = 'I';
    }
    return rows;
}

using Rows = std::vector<std::string>;

TEST(FloorCells, TakeWhatARoomEnclosesForFurniture) {
    const Rows rows = {"########", "#aaaaaa#", "#a#a #a#", "#aa#aaa#", "#aaaaaa#", "########"};
    const Rows expected = {"########", "#aaaaaa#", "#aFaIFa#", "#aaFaaa#", "#aaaaaa#", "########"};
    EXPECT_EQ(sorted(io::test::drawn_floor(rows)), expected);
}

TEST(FloorCells, ShowWhatStandsWhereTheLabelsReachUnderIt) {
    io::test::DrawnFloor floor =
        io::test::drawn_floor({"######", "#aaaa#", "#aaaa#", "######"}, 1, 0.25);
    floor.map.states.at({2, 2}) = CellState::occupied;
    floor.map.states.at({3, 2}) = CellState::unknown;
    floor.map.states.at({4, 1}) = CellState::occupied;
    const Rows expected = {"######", "#aFIa#", "#aaaF#", "######"};
    EXPECT_EQ(sorted(floor), expected);
    const FloorCells cells = sort_floor_cells(floor.map, floor.segmentation.labels);
    EXPECT_EQ(cells.ground.at({2, 2}), 1U) << "the room reaches under its furniture";
}

TEST(FloorCells, OnTheRimOfARoomThereAreWalls) {
    Rows rows(22, "#aaaaaaaaaaaaaaaaaaaa#");
    rows.front() = rows.back() = std::string(22, '#');
    io::test::DrawnFloor floor = io::test::drawn_floor(rows);
    for (std::int32_t y = 1; y <= 20; ++y) {
        floor.map.states.at({2, y}) = CellState::occupied;   // The face of the wall.
        floor.map.states.at({10, y}) = CellState::occupied;  // A counter.
    }
    const Rows drawn = sorted(floor);
    EXPECT_EQ(drawn[10], "###aaaaaaaFaaaaaaaaaa#") << "what the face cuts off is wall, too";
    EXPECT_EQ(drawn[1], "###aaaaaaa#aaaaaaaaaa#");
}

TEST(FloorCells, WhatTouchesTwoRoomsOrAWallIsAWall) {
    const Rows rows = {"#######", "#aa#bb#", "#aaabb#", "#aa#bb#", "#aaabb#", "#######"};
    EXPECT_EQ(sorted(io::test::drawn_floor(rows)), rows);
}

TEST(FloorCells, LargeObstaclesAreNoFurniture) {
    const Rows rows = {"aaaaaaa", "aa###aa", "aa###aa", "aaaaaaa"};
    const auto with_resolution = [&](double resolution_m) {
        return sorted(io::test::drawn_floor(rows, 1, resolution_m))[1];
    };
    EXPECT_EQ(with_resolution(0.5), "aaFFFaa");
    EXPECT_EQ(with_resolution(2.0), "aa###aa") << "24 m2";
}

TEST(FloorCells, FillTheInsideOfAWall) {
    const Rows rows = {"##########", "#        #", "# ###### #", "# #aaaa# #",
                       "# #aaaa# #", "# ###### #", "#        #", "##########"};
    const Rows expected = {"##########", "##########", "##########", "###aaaa###",
                           "###aaaa###", "##########", "##########", "##########"};
    EXPECT_EQ(sorted(io::test::drawn_floor(rows)), expected);
}

TEST(FloorCells, ThinUnknownBetweenRoomsIsMarked) {
    EXPECT_EQ(sorted(io::test::drawn_floor({"aaaa bbbb", "aaaa bbbb"})),
              (Rows{"aaaa+bbbb", "aaaa+bbbb"}));
}

TEST(FloorCells, FreeGroundOutsideIsNoWallHoweverNarrow) {
    // The ground reaches into a gap between two walls, and on beyond the frame.
    const Rows rows = {"..........", "..........", "..###.###.", "..#a#.#b#.", "..###.###."};
    EXPECT_EQ(sorted(io::test::drawn_floor(rows)), rows);
}

TEST(FloorCells, HollowOutSolidBlocks) {
    Rows rows(40, std::string(40, '#'));
    rows[20] = std::string(20, '#') + "aaa" + std::string(17, '#');
    const Rows drawn = sorted(io::test::drawn_floor(rows, 1, 0.1));
    // Two cells of wall around the room, then paper.
    EXPECT_EQ(drawn[8], "        #######        ");
    EXPECT_EQ(drawn[9], "        #######        ");
    EXPECT_EQ(drawn[10], "        ##aaa##        ");
    EXPECT_EQ(drawn[11], "        #######        ");
    EXPECT_EQ(drawn[13], std::string(23, ' '));
}

TEST(FloorCells, KeepAMetreAroundTheRooms) {
    const Rows empty(60, std::string(60, ' '));
    Rows rows = empty;
    rows[30] = std::string(30, ' ') + "aaa" + std::string(27, ' ');
    const io::test::DrawnFloor floor = io::test::drawn_floor(rows, 1, 0.1);
    const FloorCells cells = sort_floor_cells(floor.map, floor.segmentation.labels);
    EXPECT_EQ(cells.ground.origin, (Cell{20, 19}));
    EXPECT_EQ(cells.ground.width, 23);
    EXPECT_EQ(cells.ground.height, 21);
}

TEST(FloorCells, WithoutRoomsShowWhatIsKnown) {
    Rows rows(60, std::string(60, ' '));
    rows[10][15] = '#';
    rows[12][18] = '.';
    const io::test::DrawnFloor floor = io::test::drawn_floor(rows, 1, 1.0);
    const FloorCells cells = sort_floor_cells(floor.map, floor.segmentation.labels);
    EXPECT_EQ(cells.ground.width, 6);
    EXPECT_EQ(cells.ground.height, 5);
    const io::test::DrawnFloor blank = io::test::drawn_floor({"  ", "  "});
    EXPECT_EQ(sort_floor_cells(blank.map, blank.segmentation.labels).ground.width, 2);
}

}  // namespace
}  // namespace quadcut::draw
