// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/transparent_ground.hpp"

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

using Rows = std::vector<std::string>;

/// '#' occupied, '.' free; each character a square of a metre, of 5 x 5 cells.
constexpr std::int32_t kScale = 5;

GridMap drawn(const Rows& rows) {
    GridMap map;
    map.resolution_m = 0.2;
    const auto width = static_cast<std::int32_t>(rows[0].size());
    const auto height = static_cast<std::int32_t>(rows.size());
    map.states = Raster<CellState>({}, width * kScale, height * kScale);
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        const Cell cell = map.states.cell(i);
        const char c = rows[static_cast<std::size_t>(height - 1 - cell.y / kScale)]
                           [static_cast<std::size_t>(cell.x / kScale)];
        map.states.values[i] = c == '#' ? CellState::occupied : CellState::free;
    }
    return map;
}

/// The state in the middle of each square, ' ' unknown.
Rows draw(const GridMap& map) {
    Rows rows;
    for (std::int32_t y = map.states.height / kScale - 1; y >= 0; --y) {
        rows.emplace_back();
        for (std::int32_t x = 0; x < map.states.width / kScale; ++x) {
            const Cell middle{x * kScale + kScale / 2, y * kScale + kScale / 2};
            rows.back() += " .#"[static_cast<std::size_t>(map.states.at(middle))];
        }
    }
    return rows;
}

TEST(TransparentGround, FloorIsWhatWallsEnclose) {
    const WalledFloor floor = take_outside_away(
        drawn({"..............", ".############.", ".#.....#....#.", ".#..........#.",
               ".#.....#....#.", ".#.....#....#.", ".############.", ".............."}));
    EXPECT_TRUE(floor.is_enclosed);
    EXPECT_EQ(draw(floor.map),
              (Rows{"              ", " ############ ", " #.....#....# ", " #..........# ",
                    " #.....#....# ", " #.....#....# ", " ############ ", "              "}));
}

TEST(TransparentGround, AnOpenDoorLetsNothingOutAndANicheIsNoRoom) {
    const WalledFloor floor = take_outside_away(
        drawn({"................", "..############..", "..#....#.....#..", "..#....#.....#..",
               "..#..........#..", "..#....#.....#..", "..##.####.####..", "................"}));
    EXPECT_TRUE(floor.is_enclosed);
    const Rows rows = draw(floor.map);
    EXPECT_EQ(rows[3], "  #....#.....#  ");
    EXPECT_EQ(rows[4], "  #..........#  ");
    EXPECT_EQ(rows[7], std::string(16, ' '));
    const WalledFloor niche =
        take_outside_away(drawn({"............", ".##########.", ".#......#...", ".#......####",
                                 ".#......#...", ".##########.", "............"}));
    EXPECT_EQ(draw(niche.map)[2], " #......#   ");
    EXPECT_EQ(draw(niche.map)[4], " #......#   ");
}

TEST(TransparentGround, WallsAtTheEdgeOfTheImageEnclose) {
    const WalledFloor floor =
        take_outside_away(drawn({"#######", "#.....#", "#.....#", "#.....#", "#.#####"}));
    EXPECT_TRUE(floor.is_enclosed);
    EXPECT_EQ(draw(floor.map)[2], "#.....#");
}

TEST(TransparentGround, WithoutAnythingEnclosedTheMapStaysAsItWas) {
    const Rows rows = {"..........", ".##....##.", ".#......#.", "..........",
                       ".#......#.", ".##....##.", ".........."};
    const WalledFloor floor = take_outside_away(drawn(rows));
    EXPECT_FALSE(floor.is_enclosed);
    EXPECT_EQ(draw(floor.map), rows);
}

TEST(TransparentGround, WhoDrawsTheFloorLeavesTheUnknownTransparent) {
    GreyTally tally;
    tally.num_transparent = tally.num_not_opaque = 900;
    const MapKeys keys;
    EXPECT_FALSE(is_drawn_on_transparent(tally, keys));  // Nothing at all is drawn.
    tally.counts[0] = 100;
    EXPECT_TRUE(is_drawn_on_transparent(tally, keys));
    tally.counts[254] = 50;
    EXPECT_FALSE(is_drawn_on_transparent(tally, keys));
    tally.counts[254] = 0;
    tally.counts[0] = 90'000;  // The corners of a picture.
    EXPECT_FALSE(is_drawn_on_transparent(tally, keys));
}

}  // namespace
}  // namespace quadcut::io
