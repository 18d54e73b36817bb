// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/route/route_planner.hpp"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/route/drawn_rooms.hpp"

namespace quadcut {
namespace {

std::optional<Route> route_between(RoutePlanner& planner, const Point& from, const Point& to) {
    return planner.find(*planner.standing_place(from, 0.5), *planner.standing_place(to, 0.5));
}

std::vector<std::size_t> rooms_of(const Route& route) {
    std::vector<std::size_t> rooms{index(route.first_room)};
    for (const RouteStep& step : route.steps) rooms.push_back(index(step.to));
    return rooms;
}

/// Two rooms over a corridor; a door of 0.5 m between them, and one of 1 m to the corridor each.
DrawnRooms two_rooms() {
    return DrawnRooms({"##############",  //
                       "#aaaaa#bbbbbb#",  //
                       "#aaaaa#bbbbbb#",  //
                       "#aaaaaabbbbbb#",  //
                       "#aaaaa#bbbbbb#",  //
                       "#aa#######bb##",  //
                       "#cccccccccccc#",  //
                       "#cccccccccccc#",  //
                       "##############"});
}

TEST(RoutePlanner, GoesThroughTheNearerDoor) {
    const DrawnRooms drawn = two_rooms();
    RoutePlanner planner(drawn.frame, drawn.rooms, 0.4);
    const auto route = route_between(planner, {1.0, 3.5}, {5.5, 3.5});
    ASSERT_TRUE(route);
    EXPECT_EQ(rooms_of(*route), (std::vector<std::size_t>{1, 2}));
    EXPECT_NEAR(route->length_m, 4.75, 0.15);
    ASSERT_EQ(route->steps.size(), 1U);
    EXPECT_NEAR(route->steps[0].at.x, 3.5, 0.11);
    EXPECT_NEAR(route->steps[0].at.y, 2.75, 0.2);
    EXPECT_NEAR(route->steps[0].after_m, 2.6, 0.15);
}

TEST(RoutePlanner, GoesRoundWhereTheDoorIsTooNarrow) {
    const DrawnRooms drawn = two_rooms();
    RoutePlanner planner(drawn.frame, drawn.rooms, 0.7);
    const auto route = route_between(planner, {1.0, 3.5}, {5.5, 3.5});
    ASSERT_TRUE(route);
    EXPECT_EQ(rooms_of(*route), (std::vector<std::size_t>{1, 3, 2}));
    EXPECT_GT(route->length_m, 7.0);
    RoutePlanner wide(drawn.frame, drawn.rooms, 1.2);
    EXPECT_FALSE(route_between(wide, {1.0, 3.5}, {5.5, 3.5}));
}

TEST(RoutePlanner, StaysOffWallsByTheRobotsRadius) {
    const DrawnRooms drawn = two_rooms();
    for (const double width_m : {0.1, 0.4, 0.7}) {
        RoutePlanner planner(drawn.frame, drawn.rooms, width_m);
        const auto route = route_between(planner, {0.9, 3.6}, {6.0, 0.8});
        ASSERT_TRUE(route);
        for (std::size_t i = 1; i < route->points.size(); ++i) {
            for (int k = 0; k <= 100; ++k) {
                const Point& a = route->points[i - 1];
                const Point& b = route->points[i];
                const Cell cell{static_cast<std::int32_t>((a.x + k * (b.x - a.x) / 100) / 0.1),
                                static_cast<std::int32_t>((a.y + k * (b.y - a.y) / 100) / 0.1)};
                // A point of a cell is less than a cell nearer to the wall than its middle.
                EXPECT_GE(static_cast<double>(planner.floor().clearance_m.at(cell)),
                          width_m / 2.0 - 0.1);
            }
        }
    }
}

TEST(RoutePlanner, BendsAroundWhatStandsInARoom) {
    const DrawnRooms drawn({"###########",  //
                            "#aaaaaaaaa#",  //
                            "#aaaa#aaaa#",  //
                            "#aaaa#aaaa#",  //
                            "#aaaa#aaaa#",  //
                            "###########"});
    RoutePlanner planner(drawn.frame, drawn.rooms, 0.2);
    const auto route = route_between(planner, {1.0, 0.75}, {4.5, 0.75});
    ASSERT_TRUE(route);
    EXPECT_TRUE(route->steps.empty());
    EXPECT_NEAR(route->length_m, 2.0 * 2.1 + 0.6, 0.5);
    EXPECT_GT(route->points.size(), 2U);
}

TEST(RoutePlanner, BendsAroundFurnitureThatARoomHasInIt) {
    DrawnRooms drawn({"###########",  //
                      "#aaaaaaaaa#",  //
                      "#aaaaaaaaa#",  //
                      "#aaaaaaaaa#",  //
                      "###########"});
    drawn.frame.states = Raster<CellState>(drawn.rooms.labels.box(), CellState::free);
    const Box chair{{25, 9}, {28, 12}};
    for_each_cell(chair, [&](Cell cell) { drawn.frame.states.at(cell) = CellState::occupied; });
    RoutePlanner planner(drawn.frame, drawn.rooms, 0.4);
    const auto route = route_between(planner, {1.0, 1.1}, {4.5, 1.1});
    ASSERT_TRUE(route);
    EXPECT_GT(route->points.size(), 2U);
    EXPECT_GT(route->length_m, 3.52);
    EXPECT_FALSE(planner.floor().fits({26, 10}));
}

TEST(RoutePlanner, SaysWhereARobotCanStand) {
    const DrawnRooms drawn = two_rooms();
    const RoutePlanner planner(drawn.frame, drawn.rooms, 0.4);
    EXPECT_FALSE(planner.standing_place({0.2, 0.2}, 0.5)) << "a wall";
    EXPECT_FALSE(planner.standing_place({-5.0, 100.0}, 0.5)) << "off the map";
    EXPECT_FALSE(planner.standing_place({1e300, 0.0}, 0.5));
    const auto near_wall = planner.standing_place({0.52, 3.0}, 0.5);
    ASSERT_TRUE(near_wall);
    EXPECT_NEAR(planner.middle_of(*near_wall).x, 0.75, 0.06);
    EXPECT_FALSE(planner.standing_place({0.52, 3.0}, 0.1)) << "too far for that";
}

TEST(RoutePlanner, SamePlaceIsAWayOfNoLength) {
    const DrawnRooms drawn = two_rooms();
    RoutePlanner planner(drawn.frame, drawn.rooms, 0.4);
    const auto route = route_between(planner, {1.0, 3.5}, {1.0, 3.5});
    ASSERT_TRUE(route);
    EXPECT_EQ(route->length_m, 0.0);
    EXPECT_EQ(route->points.size(), 2U);
}

TEST(RoutePlanner, PreparedOrNotTheWayIsTheSame) {
    const DrawnRooms drawn = two_rooms();
    RoutePlanner now(drawn.frame, drawn.rooms, 0.7);
    RoutePlanner before(drawn.frame, drawn.rooms, 0.7, Executor{2});
    before.prepare(Executor{2});
    EXPECT_EQ(route_between(now, {1.0, 3.5}, {5.5, 3.5})->points,
              route_between(before, {1.0, 3.5}, {5.5, 3.5})->points);
}

}  // namespace
}  // namespace quadcut
