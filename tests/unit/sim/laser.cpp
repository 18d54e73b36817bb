// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/laser.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/building.hpp"
#include "sim/robot.hpp"

namespace quadcut::sim {
namespace {

// Walks the ray from cell to cell (Amanatides and Woo): no squares, no shortcuts.
double walk(const GridMap& map, const Point& from, double angle, double max_range) {
    const Point p = transform(inverse(map.map_from_image), from);
    angle -= map.map_from_image.yaw_rad;
    const double r = map.resolution_m;
    const double direction[] = {std::cos(angle), std::sin(angle)};
    const double origin[] = {p.x / r, p.y / r};
    std::int32_t cell[2];
    double next[2];
    for (int k : {0, 1}) {
        cell[k] = static_cast<std::int32_t>(std::floor(origin[k]));
        const double border = direction[k] > 0.0 ? cell[k] + 1.0 : cell[k];
        next[k] = (border - origin[k]) / direction[k];
    }
    double t = 0.0;
    while (t * r < max_range) {
        if (!map.states.contains({cell[0], cell[1]})) return max_range;
        if (map.states.at({cell[0], cell[1]}) == CellState::occupied) return t * r;
        const int k = next[0] <= next[1] ? 0 : 1;
        t = next[k];
        cell[k] += direction[k] > 0.0 ? 1 : -1;
        next[k] += 1.0 / std::abs(direction[k]);
    }
    return max_range;
}

TEST(Laser, RayEndsWhereAWalkFromCellToCellEnds) {
    BuildingOptions options;
    options.furniture = 1.0;
    options.num_rooms = 20;
    for (const Pose& image : {Pose{0, 0, 0}, Pose{-3, 2, 0.7}}) {
        options.seed = 4;
        Building building = generate_building(options);
        building.map.map_from_image = image;
        const RayCaster caster(building.map);
        Random random(7);
        int num_hits = 0;
        for (int i = 0; i < 20000; ++i) {
            const Point in_image{random.uniform(0.0, 0.05 * building.map.states.width),
                                 random.uniform(0.0, 0.05 * building.map.states.height)};
            const Point from = transform(image, in_image);
            const double angle = random.uniform(-M_PI, M_PI);
            const double expected = walk(building.map, from, angle, 25.0);
            EXPECT_NEAR(caster.cast(from, angle, 25.0), expected, 1e-6);
            num_hits += expected < 25.0 ? 1 : 0;
        }
        EXPECT_GT(num_hits, 10000);
    }
}

GridMap corridor() {
    GridMap map;
    map.states = Raster<CellState>({0, 0}, 400, 40, CellState::free);
    for (std::int32_t x = 0; x < 400; ++x) {
        map.states.at({x, 0}) = CellState::occupied;
        map.states.at({x, 39}) = CellState::occupied;
    }
    for (std::int32_t y = 0; y < 40; ++y) map.states.at({399, y}) = CellState::occupied;
    return map;
}

TEST(Laser, AlongTheAxesToTheWallsFace) {
    const RayCaster caster(corridor());
    EXPECT_NEAR(caster.cast({1.0, 1.0}, 0.0, 30.0), 18.95, 1e-9);
    EXPECT_NEAR(caster.cast({1.0, 1.0}, M_PI / 2.0, 30.0), 0.95, 1e-9);
    EXPECT_NEAR(caster.cast({1.0, 1.0}, -M_PI / 2.0, 30.0), 0.95, 1e-9);
    EXPECT_EQ(caster.cast({1.0, 1.0}, M_PI, 30.0), 30.0) << "the map is open to the left";
    EXPECT_EQ(caster.cast({1.0, 1.0}, 0.0, 10.0), 10.0);
    EXPECT_EQ(caster.cast({-1.0, 1.0}, 0.0, 10.0), 10.0) << "from outside";
    EXPECT_EQ(caster.cast({19.97, 1.0}, 0.0, 10.0), 0.0) << "from inside a wall";
}

TEST(Laser, UnknownCellsAreSeenThrough) {
    GridMap map = corridor();
    for (std::int32_t y = 1; y < 39; ++y) map.states.at({200, y}) = CellState::unknown;
    EXPECT_NEAR(RayCaster(map).cast({1.0, 1.0}, 0.0, 30.0), 18.95, 1e-9);
}

TEST(Laser, DefaultsAreThePapersScanner) {
    const LaserOptions options;
    EXPECT_EQ(options.num_beams(), 1081);
    Random random(1);
    const Scan scan = simulate_scan(RayCaster(corridor()), {1, 1, 0.3}, options, random);
    EXPECT_EQ(scan.ranges_m.size(), 1081U);
    EXPECT_NEAR(scan.first_angle_rad, -2.35619449, 1e-8);
    EXPECT_NEAR(scan.angle_step_rad, 0.00436332313, 1e-10);
    EXPECT_EQ(scan.max_range_m, 30.0);
    EXPECT_EQ(scan.world_from_sensor, (Pose{1, 1, 0.3}));
}

TEST(Laser, NoiseAndDropoutsAreAsStated) {
    const RayCaster caster(corridor());
    LaserOptions options;
    options.range_noise_m = 0.02;
    options.dropout = 0.03;
    options.field_of_view_rad = 0.5 * M_PI;
    Random random(5);
    double sum = 0.0;
    double squares = 0.0;
    int num_returned = 0;
    int num_lost = 0;
    for (int k = 0; k < 60; ++k) {
        const Pose pose{10.0, 1.0, M_PI / 2.0};
        const Scan scan = simulate_scan(caster, pose, options, random);
        for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
            const auto range = static_cast<double>(scan.ranges_m[i]);
            if (range >= options.max_range_m) {
                ++num_lost;
                continue;
            }
            const double angle =
                pose.yaw_rad + scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
            const double error = range - caster.cast({pose.x, pose.y}, angle, 30.0);
            sum += error;
            squares += error * error;
            ++num_returned;
        }
    }
    const double n = num_returned;
    EXPECT_NEAR(sum / n, 0.0, 4.0 * 0.02 / std::sqrt(n));
    EXPECT_NEAR(std::sqrt(squares / n), 0.02, 0.0006);
    EXPECT_NEAR(num_lost / (n + num_lost), 0.03, 0.005);
}

TEST(Laser, WithoutNoiseItIsTheTruth) {
    LaserOptions options;
    options.range_noise_m = 0.0;
    options.dropout = 0.0;
    options.max_range_m = 5.0;
    const RayCaster caster(corridor());
    Random random(5);
    const Scan scan = simulate_scan(caster, {10, 1, 0}, options, random);
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
        const double angle = scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
        EXPECT_EQ(scan.ranges_m[i], static_cast<float>(caster.cast({10, 1}, angle, 5.0)));
        EXPECT_LE(scan.ranges_m[i], 5.0F);
    }
    EXPECT_EQ(scan.ranges_m[540], 5.0F) << "straight ahead there is nothing within 5 m";
}

}  // namespace
}  // namespace quadcut::sim
