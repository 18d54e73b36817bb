// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "quadcut/map/line_walk.hpp"
#include "quadcut/map/scan_cells.hpp"

// Scans as bits against the definition, cell by cell: bearing, beams on both sides, ranges.
namespace quadcut {
namespace {

/// With cells of 1 m.
constexpr IntegrateOptions kLimits{.usable_range_m = 200.0, .widest_gap_m = 5.0};

struct RandomScan {
    Scan scan;
    Pose sensor;  // in cells
};

// Long walls with jumps, dropouts and no-returns, at any field of view up to a whole turn.
RandomScan random_scan(Random& random) {
    RandomScan made;
    const int num_beams = 2 + static_cast<int>(random.below(200));
    const double field = random.uniform(0.5, 2.0 * std::numbers::pi);
    made.scan.first_angle_rad = random.uniform(-4.0, 4.0);
    made.scan.angle_step_rad = (random.below(2) == 0 ? 1.0 : -1.0) * field / num_beams;
    made.scan.max_range_m = 81.0;
    double range = random.uniform(5.0, 80.0);
    for (int i = 0; i < num_beams; ++i) {
        range = random.below(8) == 0 ? random.uniform(0.5, 90.0)
                                     : std::max(0.5, range + random.uniform(-1.0, 1.0));
        made.scan.ranges_m.push_back(static_cast<float>(range));
        if (random.below(20) == 0) {
            made.scan.ranges_m.back() = 81.0F;
        } else if (random.below(20) == 0) {
            made.scan.ranges_m.back() = std::numeric_limits<float>::quiet_NaN();
        }
    }
    made.sensor = {random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0),
                   random.uniform(-3.0, 3.0)};
    return made;
}

// How many beams' spacings after the first beam a cell's centre lies; negative when outside.
double beam_position(const RandomScan& made, Cell cell) {
    const double bearing = std::atan2(cell.y + 0.5 - made.sensor.y, cell.x + 0.5 - made.sensor.x) -
                           made.sensor.yaw_rad - made.scan.first_angle_rad;
    const double sign = made.scan.angle_step_rad < 0.0 ? -1.0 : 1.0;
    const double turn = 2.0 * std::numbers::pi;
    const double angle = sign * bearing - turn * std::floor(sign * bearing / turn);
    return angle / std::abs(made.scan.angle_step_rad);
}

class ScanBits : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ScanBits, AreWhatTheDefinitionSays) {
    Random random(GetParam());
    const RandomScan made = random_scan(random);
    const std::vector<Beam> beams = beams_of(made.scan, made.sensor.yaw_rad, 1.0, kLimits);
    const Point sensor{made.sensor.x, made.sensor.y};
    const ScanCells cells = cells_of(beams, sensor, made.scan.angle_step_rad);

    const BitRaster empty({-400, -400}, {400, 400});
    BitRaster crossed = empty;
    BitRaster hit = empty;
    for (const Beam& beam : beams) {
        const auto at = [&](double length) {
            return Point{sensor.x + beam.direction.x * length,
                         sensor.y + beam.direction.y * length};
        };
        if (beam.range > 0.0) {
            walk_line(sensor, at(beam.reach), [&](Cell cell, double) {
                crossed.set(cell);
                return true;
            });
        }
        if (beam.hits) {
            hit.set(cell_of(at(beam.range)));
        }
    }
    for (std::int32_t y = -300; y < 300; ++y) {
        for (std::int32_t x = -300; x < 300; ++x) {
            const Cell cell{x, y};
            ASSERT_EQ(cells.hit.test(cell), hit.test(cell));
            const double position = beam_position(made, cell);
            const double distance = std::hypot(x + 0.5 - sensor.x, y + 0.5 - sensor.y);
            const auto left = static_cast<std::size_t>(position);
            // Rounding may decide on the border between two beams, and the chord between two end
            // points runs a little nearer than their circle.
            const double to_beam = std::abs(position - std::round(position)) * distance;
            double reach = 0.0;
            if (left + 1 < beams.size()) {
                reach = std::min(beams[left].reach, beams[left + 1].reach);
            }
            const double chord = reach * std::cos(made.scan.angle_step_rad / 2.0);
            if (distance < chord - 1e-6 && to_beam > 1e-6) {
                ASSERT_TRUE(cells.free.test(cell)) << x << ' ' << y;
            }
            if (distance > reach + 1e-6 && to_beam > 1e-6 && !crossed.test(cell)) {
                ASSERT_FALSE(cells.free.test(cell)) << x << ' ' << y;
            }
        }
    }
}

// No cell is free that lies behind a wall, however flat the wall is seen.
TEST_P(ScanBits, NothingBehindAWallIsFree) {
    Random random(GetParam());
    RandomScan made;
    made.sensor = {random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0),
                   random.uniform(-3.0, 3.0)};
    made.scan.angle_step_rad = random.uniform(0.004, 0.02);
    made.scan.max_range_m = 1000.0;
    // A corridor: walls at 20 and -30 cells from its axis, seen at all angles down to grazing.
    for (double angle = -1.5; angle < 1.5; angle += made.scan.angle_step_rad) {
        const double across = std::sin(angle);
        const double range = across > 0.0 ? 20.0 / across : -30.0 / across;
        made.scan.ranges_m.push_back(static_cast<float>(std::min(range, 1000.0)));
    }
    made.scan.first_angle_rad = -1.5;
    const std::vector<Beam> beams = beams_of(made.scan, made.sensor.yaw_rad, 1.0, kLimits);
    const ScanCells cells =
        cells_of(beams, {made.sensor.x, made.sensor.y}, made.scan.angle_step_rad);
    const Pose sensor_from_map = inverse(made.sensor);
    int num_free = 0;
    for (std::int32_t y = -400; y < 400; ++y) {
        for (std::int32_t x = -400; x < 400; ++x) {
            if (cells.free.test({x, y})) {
                ++num_free;
                const double across = transform(sensor_from_map, {x + 0.5, y + 0.5}).y;
                // A beam clears cells that it crosses; their centres are half a diagonal away at
                // most.
                ASSERT_LT(across, 20.0 + std::numbers::sqrt2 / 2.0);
                ASSERT_GT(across, -30.0 - std::numbers::sqrt2 / 2.0);
            }
        }
    }
    EXPECT_GT(num_free, 2000);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ScanBits, testing::Range<std::uint64_t>(1, 41));

}  // namespace
}  // namespace quadcut
