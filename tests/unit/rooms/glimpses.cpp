// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/glimpses.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/rooms/drawing.hpp"

namespace quadcut {
namespace {

using test::drawn_labels;
using test::drawn_map;
using Rows = std::vector<std::string>;

constexpr double kCellM = 0.1;

/// Borders of the regions 'a', 'b', ... of a drawing: '#' is an obstacle, ' ' unknown.
std::vector<RegionBorder> borders_of(Rows rows) {
    const Raster<std::uint32_t> labels = drawn_labels(rows);
    for (std::string& row : rows) {
        for (char& c : row) c = c >= 'a' && c <= 'z' ? '.' : c;
    }
    const GridMap map = drawn_map(rows, kCellM);
    return measure_borders(labels, map.states, as_it_lies(labels.box()), kCellM);
}

TEST(Glimpses, ABorderIsOpenWhereTheUnknownIsDeep) {
    const std::vector<RegionBorder> borders = borders_of({"              ",  //
                                                          "              ",  //
                                                          "              ",  //
                                                          "  aaaaaaaaaa##",  //
                                                          "  aaaaaaaaaa##",  //
                                                          "##############"});
    EXPECT_EQ(borders[1].num_cells, 20U);
    // Of the upper side, two sides of cells are within reach of the obstacle at its end.
    EXPECT_EQ(borders[1].num_open, 8U);
    EXPECT_EQ(borders[1].num_closed, 16U);
    EXPECT_NEAR(borders[1].open_share(), 8.0 / 24.0, 1e-12);
}

TEST(Glimpses, WhatIsUnknownBetweenRegionsIsAGapBetweenRaysOrAWallInPlans) {
    const std::vector<RegionBorder> rays = borders_of({"          ",  //
                                                       "aaa   bbb ",  //
                                                       "aaa   bbb ",  //
                                                       "          "});
    EXPECT_EQ(rays[1].num_open, 10U);
    EXPECT_EQ(rays[1].num_closed, 0U);
    const std::vector<RegionBorder> plan = borders_of({"####################",  //
                                                       "#aaaaaa bbb   cccc #",  //
                                                       "#aaaaaa bbb   cccc #",  //
                                                       "####################"});
    EXPECT_EQ(plan[2].num_open, 0U);
    EXPECT_EQ(plan[2].num_closed, 10U);
    EXPECT_EQ(plan[2].num_between, 0U);
}

TEST(Glimpses, ThickWallsOfPlansAreClosedByTheObstacleBehindThem) {
    const std::vector<RegionBorder> borders = borders_of({"########",  //
                                                          "        ",  //
                                                          "        ",  //
                                                          "        ",  //
                                                          "        ",  //
                                                          "aaaaaaaa"});
    EXPECT_EQ(borders[1].num_closed, 8U);
    EXPECT_EQ(borders[1].num_open, 10U) << "both ends, and what is below the map";
}

/// Rays upwards from a cell of a wall, a cell more to each side every second row, as high as there
/// is room.
void draw_fan(Rows& rows, std::size_t row, std::size_t column, char mark) {
    for (std::size_t up = 0; up < row; ++up) {
        for (std::size_t x = column - up / 2; x <= column + up / 2; ++x) rows[row - up][x] = mark;
    }
}

/// A room with walls, 6 m wide and `depth` cells deep, and what a crack in them lets see of the
/// unknown.
Rows room_with_fan(int depth = 20) {
    Rows rows(40, std::string(62, ' '));
    rows.push_back(std::string(62, '#'));
    for (int y = 0; y < depth; ++y) rows.push_back("#" + std::string(60, 'a') + "#");
    rows.push_back(std::string(62, '#'));
    draw_fan(rows, 40, 30, 'a');
    return rows;
}

Raster<std::uint32_t> split(Rows rows, const std::vector<Cell>& way, double min_area_m2 = 1.0) {
    Raster<std::uint32_t> labels = drawn_labels(rows);
    for (std::string& row : rows) {
        for (char& c : row) c = c == 'a' ? '.' : c;
    }
    const GridMap map = drawn_map(rows, kCellM);
    // The crack is too narrow for a robot, all else is wide.
    const auto num_floor_rows = static_cast<std::int32_t>(rows.size()) - 43;
    Raster<float> clearance(labels.box(), 0.3F);
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const std::int32_t y = labels.cell(i).y;
        if (labels.values[i] == 0 || (y > num_floor_rows && y <= num_floor_rows + 8))
            clearance.values[i] = 0.1F;
    }
    split_off_fans(labels, clearance, map.states, as_it_lies(labels.box()), kCellM, 0.4,
                   min_area_m2, way);
    return labels;
}

TEST(Glimpses, AFanBehindACrackBecomesARegionOfItsOwn) {
    const Raster<std::uint32_t> labels = split(room_with_fan(), {});
    const std::uint32_t room = labels.at({30, 5});
    const std::uint32_t fan = labels.at({30, 55});
    EXPECT_EQ(room, 1U);
    EXPECT_EQ(fan, 2U);
    EXPECT_EQ(labels.at({3, 20}), room) << "a corner";
}

TEST(Glimpses, ARoomMayBeSmallerThanItsFan) {
    const Raster<std::uint32_t> labels = split(room_with_fan(8), {});
    EXPECT_NE(labels.at({30, 5}), labels.at({30, 45}));
}

TEST(Glimpses, AFanIsLeftWhereTheRobotWasOrWhereItIsSmall) {
    EXPECT_EQ(split(room_with_fan(), {{30, 55}}).at({30, 55}), 1U);
    EXPECT_EQ(split(room_with_fan(), {}, 20.0).at({30, 55}), 1U);
}

TEST(Glimpses, APartWithWallsOfItsOwnIsNoFan) {
    Rows rows = room_with_fan();
    for (std::size_t y = 0; y < 38; ++y) {
        for (std::size_t x = 0; x < rows[y].size(); ++x) {
            const bool is_beside = rows[y][x] == ' ' && x > 0 && x + 1 < rows[y].size() &&
                                   (rows[y][x - 1] == 'a' || rows[y][x + 1] == 'a');
            if (is_beside) rows[y][x] = '#';
        }
    }
    EXPECT_EQ(split(rows, {}).at({30, 55}), 1U);
}

/// A walled room 'a', and 'b' and 'c' that are open to the unknown.
struct Floor {
    Floor() {
        Rows rows(24, std::string(62, ' '));
        rows.push_back(std::string(62, '#'));
        for (int y = 0; y < 10; ++y) rows.push_back("#" + std::string(60, 'a') + "#");
        rows.push_back(std::string(62, '#'));
        draw_fan(rows, 24, 15, 'b');
        draw_fan(rows, 24, 45, 'c');
        labels = drawn_labels(rows);
        Rows free = rows;
        for (std::string& row : free) {
            for (char& c : row) c = c >= 'a' && c <= 'c' ? '.' : c;
        }
        map = drawn_map(free, kCellM);
        for (std::uint32_t id = 1; id <= 3; ++id) {
            rooms.emplace_back();
            rooms.back().id = RoomId{id};
        }
    }
    std::vector<Seen> judged(const std::vector<Cell>& way = {}) {
        judge_seen(rooms, labels, map.states, as_it_lies(labels.box()), kCellM, doors, way);
        std::vector<Seen> seen;
        for (const Room& room : rooms) seen.push_back(room.seen);
        return seen;
    }
    void add_door(std::uint32_t a, std::uint32_t b, double width_m) {
        Door door;
        door.a = RoomId{a};
        door.b = RoomId{b};
        door.width_m = width_m;
        doors.push_back(door);
    }

    Raster<std::uint32_t> labels;
    GridMap map;
    std::vector<Room> rooms;
    std::vector<Door> doors;
};

using Judged = std::vector<Seen>;

TEST(Glimpses, WhatEndsInTheUnknownAndLeadsNowhereIsOne) {
    Floor floor;
    floor.add_door(1, 2, 0.8);
    floor.add_door(1, 3, 0.8);
    EXPECT_EQ(floor.judged(), (Judged{Seen::whole, Seen::glimpse, Seen::glimpse}));
    EXPECT_GT(floor.rooms[1].open_border, 0.45);
    EXPECT_EQ(floor.rooms[0].open_border, 0.0);
}

TEST(Glimpses, NoneIsWhereTheRobotWas) {
    Floor floor;
    EXPECT_EQ(floor.judged({{15, 30}}), (Judged{Seen::whole, Seen::partly, Seen::glimpse}));
}

TEST(Glimpses, NoneIsInAMapThatShowsNoObstacles) {
    Floor floor;
    for (CellState& state : floor.map.states.values) {
        if (state == CellState::occupied) state = CellState::unknown;
    }
    EXPECT_EQ(floor.judged(), Judged(3, Seen::whole));
}

}  // namespace
}  // namespace quadcut
