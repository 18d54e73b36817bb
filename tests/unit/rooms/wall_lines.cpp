// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/wall_lines.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "quadcut/base/geometry.hpp"

namespace quadcut {
namespace {

constexpr double kResolutionM = 0.05;
constexpr double kMaxGapM = 4.0;

/// A hall of 10 x 6 m with walls around it, into which walls are put.
struct Hall {
    Raster<std::uint8_t> free{{0, 0}, 200, 120};

    Hall() {
        for (std::int32_t y = 2; y < 118; ++y) {
            for (std::int32_t x = 2; x < 198; ++x) free.at({x, y}) = 1;
        }
    }
    /// An upright wall 0.1 m thick.
    void put_wall(std::int32_t x, std::int32_t begin, std::int32_t end) {
        for (std::int32_t y = begin; y < end; ++y) {
            free.at({x, y}) = 0;
            free.at({x + 1, y}) = 0;
        }
    }
    /// How many cells of the column of the wall, from begin to end, are in a line.
    [[nodiscard]] int num_in_line(std::int32_t x, std::int32_t begin, std::int32_t end) const {
        const WallLines lines = find_wall_lines(free, kResolutionM, kMaxGapM);
        int count = 0;
        for (std::int32_t y = begin; y < end; ++y) {
            const bool is_there =
                lines.more_dm.at({x - 1, y}) != 0 || lines.more_dm.at({x, y}) != 0 ||
                lines.more_dm.at({x + 1, y}) != 0 || lines.more_dm.at({x + 2, y}) != 0;
            count += is_there ? 1 : 0;
        }
        return count;
    }
};

TEST(WallLines, AnEmptyHallHasNone) {
    const Hall hall;
    const WallLines lines = find_wall_lines(hall.free, kResolutionM, kMaxGapM);
    for (const std::uint8_t dm : lines.more_dm.values) ASSERT_EQ(dm, 0);
}

TEST(WallLines, AGapBetweenTwoPiecesOfAWallIsBridged) {
    Hall hall;
    hall.put_wall(100, 2, 40);
    hall.put_wall(100, 80, 118);
    // 2 m.
    EXPECT_EQ(hall.num_in_line(100, 40, 80), 40);
    const WallLines lines = find_wall_lines(hall.free, kResolutionM, kMaxGapM);
    for (std::size_t i = 0; i < hall.free.values.size(); ++i) {
        if (hall.free.values[i] != 0) continue;
        ASSERT_EQ(lines.more_dm.values[i], 0) << "only what is free";
    }
}

TEST(WallLines, AGapThatIsTooWideIsNot) {
    Hall hall;
    hall.put_wall(100, 2, 16);
    hall.put_wall(100, 104, 118);
    EXPECT_EQ(hall.num_in_line(100, 16, 104), 0);
}

TEST(WallLines, AWallGoesOnUpToACrossingOne) {
    Hall hall;
    hall.put_wall(100, 2, 70);
    EXPECT_EQ(hall.num_in_line(100, 70, 118), 48);
}

TEST(WallLines, PostsThatNoRobotFitsBetweenAreAWall) {
    Hall hall;
    // 0.1 m of post, 0.1 m of gap.
    for (std::int32_t y = 2; y < 62; y += 4) hall.put_wall(100, y, y + 2);
    EXPECT_EQ(hall.num_in_line(100, 62, 118), 56) << "up to the wall of the hall";
}

TEST(WallLines, ADottedWallIsOne) {
    Hall hall;
    // One cell thick; each third one was not hit, nor the last metres up to the wall of the hall.
    for (std::int32_t y = 2; y < 80; ++y) hall.free.at({100, y}) = y % 3 == 0 ? 1 : 0;
    const WallLines lines = find_wall_lines(hall.free, kResolutionM, kMaxGapM);
    EXPECT_TRUE(lines.is_wall({100.5, 40.5}));
    EXPECT_FALSE(lines.is_wall({50.5, 40.5}));
    EXPECT_EQ(hall.num_in_line(100, 80, 118), 38);
}

TEST(WallLines, LegsARobotFitsBetweenAreNone) {
    Hall hall;
    for (std::int32_t y = 20; y < 100; y += 20) hall.put_wall(100, y, y + 2);
    EXPECT_EQ(hall.num_in_line(100, 22, 98), 0);
}

/// Everything in a building that stands at an angle, 1 = free.
Raster<std::uint8_t> turned_walls(double angle) {
    Raster<std::uint8_t> free({0, 0}, 240, 240, 1);
    const Point along{std::cos(angle), std::sin(angle)};
    for (const double aside : {-60.0, 0.0, 60.0}) {
        for (double t = -90.0; t <= 90.0; t += 0.4) {
            // The middle wall has a door of 1 m.
            if (aside == 0.0 && std::abs(t) < 10.0) continue;
            for (const double off : {0.0, 0.7, 1.4}) {
                free.at(
                    {static_cast<std::int32_t>(120.0 + t * along.x - (aside + off) * along.y),
                     static_cast<std::int32_t>(120.0 + t * along.y + (aside + off) * along.x)}) = 0;
            }
        }
    }
    return free;
}

TEST(WallLines, TheDirectionOfABuildingIsFoundAndItsDoorsClosed) {
    for (const double degrees : {0.0, 17.0, 45.0, 71.0}) {
        const double angle = degrees * std::numbers::pi / 180.0;
        const Raster<std::uint8_t> free = turned_walls(angle);
        const std::vector<double> found = main_directions(free, kResolutionM);
        ASSERT_FALSE(found.empty());
        EXPECT_NEAR(found.front(), angle, 0.03) << degrees;
        const WallLines lines = find_wall_lines(free, kResolutionM, kMaxGapM);
        int num_near = 0;
        for (std::int32_t y = 116; y < 125; ++y) {
            for (std::int32_t x = 116; x < 125; ++x) num_near += lines.more_dm.at({x, y}) != 0;
        }
        EXPECT_GE(num_near, 5) << degrees;
    }
}

TEST(WallLines, ABuildingOfTwoDirectionsHasBoth) {
    Raster<std::uint8_t> free = turned_walls(0.0);
    const Raster<std::uint8_t> other = turned_walls(0.6);
    for (std::size_t i = 0; i < free.values.size(); ++i) {
        if (other.values[i] == 0) free.values[i] = 0;
    }
    const std::vector<double> found = main_directions(free, kResolutionM);
    ASSERT_GE(found.size(), 2U);
    EXPECT_NEAR(std::min(found[0], found[1]), 0.0, 0.03);
    EXPECT_NEAR(std::max(found[0], found[1]), 0.6, 0.03);
}

}  // namespace
}  // namespace quadcut
