// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/integrate.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"
#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

constexpr double kStep = 0.01;

// A sensor at (x, y) that sees `range_m` everywhere around.
Scan round_scan(double x, double y, float range_m) {
    Scan scan;
    scan.world_from_sensor = {x, y, 0.0};
    scan.first_angle_rad = -std::numbers::pi;
    scan.angle_step_rad = kStep;
    scan.max_range_m = 80.0;
    scan.ranges_m.assign(628, range_m);
    return scan;
}

// The same with other readings between two bearings.
Scan with_sector(Scan scan, double from_rad, double to_rad, float range_m) {
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
        const double angle = scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
        if (angle > from_rad && angle < to_rad) {
            scan.ranges_m[i] = range_m;
        }
    }
    return scan;
}

// All that a map holds.
struct Contents {
    Box tiles;
    std::vector<std::array<std::int8_t, kTileCells>> log_odds;
    friend bool operator==(const Contents&, const Contents&) = default;
};

Contents contents_of(const OccupancyMap& map) {
    Contents contents{map.written_tiles(), {}};
    for (Cell tile = contents.tiles.low; tile.y <= contents.tiles.high.y; ++tile.y) {
        for (tile.x = contents.tiles.low.x; tile.x <= contents.tiles.high.x; ++tile.x) {
            contents.log_odds.push_back(map.tile(tile).values);
        }
    }
    return contents;
}

TEST(Integrate, ARoundRoomIsFreeWithAWallAround) {
    OccupancyMap map(0.05);
    const MapUpdate update = integrate_scan(map, round_scan(1.0, 1.0, 2.0F));
    for (double angle = -3.0; angle < 3.0; angle += 0.1) {
        const auto at = [&](double range) {
            return map.state(
                map.cell_at({1.0 + range * std::cos(angle), 1.0 + range * std::sin(angle)}));
        };
        EXPECT_EQ(at(0.5), CellState::free);
        EXPECT_EQ(at(1.8), CellState::free);
        EXPECT_EQ(at(2.2), CellState::unknown);
    }
    EXPECT_EQ(map.state(map.cell_at({1.0, 2.999})), CellState::occupied);
    EXPECT_GT(update.nodes_rebuilt, 0U);
    ASSERT_TRUE(update.covering);
    EXPECT_LE(update.covering->lower_left.x, map.cell_at({-1.0, 0.0}).x);
}

TEST(Integrate, ACellIsCountedOnceAScanHoweverManyBeamsCrossIt) {
    OccupancyMap map(0.05);
    integrate_scan(map, round_scan(0.0, 0.0, 2.0F));
    EXPECT_EQ(map.log_odds({0, 0}), -1);
    EXPECT_EQ(map.log_odds({1, 1}), -1);
    EXPECT_EQ(map.log_odds(map.cell_at({0.0, 1.999})), 3);
    integrate_scan(map, round_scan(0.0, 0.0, 2.0F));
    EXPECT_EQ(map.log_odds({1, 1}), -2);
}

TEST(Integrate, InvalidAndNoReturnBeamsSayNothing) {
    OccupancyMap map(0.05);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float range : {nan, infinity, -infinity, 0.0F, -1.0F, 80.0F, 81.83F}) {
        integrate_scan(map, round_scan(0.0, 0.0, range));
    }
    EXPECT_EQ(map.num_leaves(), 1U);
    EXPECT_TRUE(map.to_raster().values.empty());
    // A gap in the readings is a gap in the map.
    integrate_scan(map, with_sector(round_scan(0.0, 0.0, 3.0F), 0.5, 1.0, 80.0F));
    EXPECT_EQ(map.state(map.cell_at({2.0 * std::cos(0.75), 2.0 * std::sin(0.75)})),
              CellState::unknown);
    EXPECT_EQ(map.state(map.cell_at({2.0 * std::cos(0.25), 2.0 * std::sin(0.25)})),
              CellState::free);
}

TEST(Integrate, BehindTheNearerOfTwoBeamsNothingIsCleared) {
    OccupancyMap map(0.05);
    Scan scan = round_scan(0.0, 0.0, 1.0F);
    scan.angle_step_rad = 0.05;
    scan.first_angle_rad = -0.025;
    scan.ranges_m = {3.0F, 1.0F};
    integrate_scan(map, scan);
    EXPECT_EQ(map.state(map.cell_at({0.8, 0.01})), CellState::free);
    EXPECT_EQ(map.state(map.cell_at({2.5, 2.5 * std::sin(-0.025)})), CellState::free);
    EXPECT_EQ(map.state(map.cell_at({2.5, 2.5 * std::sin(0.025)})), CellState::unknown);
}

TEST(Integrate, BeamsAreUsedAsFarAsTheyAreCloseTogether) {
    OccupancyMap map(0.05);
    Scan scan = round_scan(0.0, 0.0, 20.0F);
    scan.angle_step_rad = 0.02;
    scan.ranges_m.resize(314);
    integrate_scan(map, scan);
    // 0.2 m apart at 10 m.
    EXPECT_EQ(map.state(map.cell_at({9.5, 0.0})), CellState::free);
    EXPECT_EQ(map.state(map.cell_at({10.5, 0.0})), CellState::unknown);
    EXPECT_EQ(map.state(map.cell_at({19.99, 0.0})), CellState::unknown);
}

TEST(Integrate, ADoorThatOpensIsSeenOpen) {
    OccupancyMap map(0.05);
    const Scan closed = round_scan(0.0, 0.0, 2.0F);
    const Scan open = with_sector(closed, -0.2, 0.2, 6.0F);
    for (int i = 0; i < 20; ++i) {
        integrate_scan(map, closed);
    }
    EXPECT_EQ(map.state(map.cell_at({1.999, 0.0})), CellState::occupied);
    for (int i = 0; i < 20; ++i) {
        integrate_scan(map, open);
    }
    EXPECT_EQ(map.state(map.cell_at({1.999, 0.0})), CellState::free);
    EXPECT_EQ(map.state(map.cell_at({5.0, 0.0})), CellState::free);
}

TEST(Integrate, AWallTheMapIsSureOfStopsAFarBeam) {
    OccupancyMap map(0.05);
    const Scan wall = round_scan(0.0, 0.0, 4.0F);
    for (int i = 0; i < 4; ++i) {
        integrate_scan(map, wall);
    }
    const int before = map.log_odds(map.cell_at({3.999, 0.01}));
    EXPECT_GE(before, IntegrateOptions{}.sure);
    // A scan that looks through it: its pose must be wrong.
    integrate_scan(map, with_sector(wall, -0.2, 0.2, 8.0F));
    EXPECT_EQ(map.log_odds(map.cell_at({3.999, 0.01})), before);
    EXPECT_EQ(map.state(map.cell_at({6.0, 0.0})), CellState::unknown);
    EXPECT_EQ(map.state(map.cell_at({7.999, 0.01})), CellState::unknown);
    EXPECT_EQ(map.state(map.cell_at({3.0, 0.0})), CellState::free);
}

TEST(Integrate, InThePaperOneMissClearsAndOneHitMarks) {
    OccupancyMap map(0.05);
    const Scan closed = round_scan(0.0, 0.0, 4.0F);
    for (int i = 0; i < 10; ++i) {
        integrate_scan(map, closed, latest_scan_wins());
    }
    const Cell wall = map.cell_at({3.999, 0.01});
    EXPECT_EQ(map.state(wall), CellState::occupied);
    integrate_scan(map, with_sector(closed, -0.2, 0.2, 6.0F), latest_scan_wins());
    EXPECT_EQ(map.state(wall), CellState::free);
    integrate_scan(map, closed, latest_scan_wins());
    EXPECT_EQ(map.state(wall), CellState::occupied);
}

TEST(Integrate, AScanWithoutAPlaceChangesNothing) {
    OccupancyMap map(0.05);
    integrate_scan(map, round_scan(0.0, 0.0, 2.0F));
    const Contents before = contents_of(map);
    const double nan = std::nan("");
    for (const Pose pose : {Pose{nan, 0.0, 0.0}, Pose{0.0, nan, 0.0}, Pose{0.0, 0.0, nan},
                            Pose{1e9, 0.0, 0.0}, Pose{0.0, -1e300, 0.0}, Pose{1e6, 1e6, 0.0}}) {
        Scan scan = round_scan(0.0, 0.0, 2.0F);
        scan.world_from_sensor = pose;
        EXPECT_THROW(integrate_scan(map, scan), InputError);
    }
    for (const double step : {nan, 1e300, -1e300}) {
        Scan scan = round_scan(0.0, 0.0, 2.0F);
        scan.angle_step_rad = step;
        EXPECT_THROW(integrate_scan(map, scan), InputError);
    }
    EXPECT_TRUE(contents_of(map) == before);
}

TEST(Integrate, AFinerMapThanTheRangeAllowsIsRefused) {
    OccupancyMap map(0.001);
    EXPECT_THROW(integrate_scan(map, round_scan(0.0, 0.0, 2.0F)), InputError);
}

TEST(Integrate, SingleBeamsAndNoneAreScans) {
    OccupancyMap map(0.05);
    Scan scan = round_scan(0.0, 0.0, 2.0F);
    scan.ranges_m.clear();
    EXPECT_EQ(integrate_scan(map, scan).nodes_rebuilt, 0U);
    scan.first_angle_rad = 0.0;
    scan.angle_step_rad = 0.0;
    scan.ranges_m = {2.0F};
    integrate_scan(map, scan);
    EXPECT_EQ(map.state(map.cell_at({1.0, 0.01})), CellState::free);
    EXPECT_EQ(map.state(map.cell_at({1.0, 0.06})), CellState::unknown);
}

TEST(Integrate, MoreThanAWholeTurnIsNoHole) {
    OccupancyMap map(0.05);
    Scan scan = round_scan(0.0, 0.0, 2.0F);
    scan.ranges_m.assign(900, 2.0F);
    integrate_scan(map, scan);
    for (double angle = -3.1; angle < 3.1; angle += 0.05) {
        EXPECT_EQ(map.state(map.cell_at({1.5 * std::cos(angle), 1.5 * std::sin(angle)})),
                  CellState::free);
    }
}

TEST(Integrate, AWholeLogIsItsScansOneByOne) {
    Random random(11);
    std::vector<Scan> scans;
    for (int i = 0; i < 40; ++i) {
        scans.push_back(with_sector(round_scan(0.1 * i, -0.2 * i, 3.0F), -1.0, 0.5,
                                    static_cast<float>(random.uniform(0.5, 9.0))));
    }
    OccupancyMap one_by_one(0.05);
    for (const Scan& scan : scans) {
        integrate_scan(one_by_one, scan);
    }
    std::size_t num_done = 0;
    const OccupancyMap whole =
        map_from_scans(scans, 0.05, {}, [&](std::size_t done) { num_done = done; });
    EXPECT_TRUE(contents_of(whole) == contents_of(one_by_one));
    EXPECT_EQ(num_done, scans.size());
    scans[7].world_from_sensor.x = 1e12;
    try {
        static_cast<void>(map_from_scans(scans, 0.05));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("scan 7"), std::string::npos);
    }
}

}  // namespace
}  // namespace quadcut
