// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/smooth_outline.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "tests/unit/io/floor_drawing.hpp"

namespace quadcut::io {
namespace {

/// The half plane under a line that rises by `rise` cells on 100, and 1 above.
Raster<std::uint16_t> slanted(double rise) {
    Raster<std::uint16_t> values({0, 0}, 100, 130, 2);
    for (std::size_t i = 0; i < values.values.size(); ++i) {
        const Cell cell = values.cell(i);
        if (cell.y + 0.5 < 12.0 + (cell.x + 0.5) * rise / 100.0) values.values[i] = 1;
    }
    return values;
}

TEST(SmoothOutline, KeepsSquareCorners) {
    const auto outlines =
        trace_outlines(test::drawn_values({"aaaa....", "aaaa....", "aaaaaaaa", "aaaaaaaa"}));
    const std::vector<HalfCell> expected = {{0, 0}, {16, 0}, {16, 4}, {8, 4}, {8, 8}, {0, 8}};
    EXPECT_EQ(smooth_ring(outlines[0].rings[0]), expected);
    EXPECT_DOUBLE_EQ(length_cells(expected), 24.0);
}

TEST(SmoothOutline, KeepsAThinWallAndALoneJog) {
    const std::vector<HalfCell> wall = {{0, 0}, {20, 0}, {20, 2}, {0, 2}};
    EXPECT_EQ(smooth_ring(trace_outlines(test::drawn_values({"aaaaaaaaaa"}))[0].rings[0]), wall);
    const auto jog = trace_outlines(
        test::drawn_values({"aaaaaaaaaaaaaaa..............", "aaaaaaaaaaaaaaaaaaaaaaaaaaaaa",
                            "aaaaaaaaaaaaaaaaaaaaaaaaaaaaa"}));
    EXPECT_EQ(smooth_ring(jog[0].rings[0]).size(), 6U);
}

TEST(SmoothOutline, DrawsStairsAsALine) {
    for (const double rise : {100.0, 50.0, 33.0, 20.0, 11.0, 7.0}) {
        const auto outlines = trace_outlines(slanted(rise));
        const std::vector<HalfCell> ring = smooth_ring(outlines[0].rings[0]);
        // Three corners of the raster, and a line that wavers at most once or twice.
        EXPECT_LE(ring.size(), 8U) << rise;
        for (const HalfCell point : ring) {
            if (point.x == 0 || point.x == 200 || point.y == 0) continue;
            EXPECT_NEAR(point.y / 2.0, 12.0 + point.x / 2.0 * rise / 100.0, 0.75) << rise;
        }
    }
}

TEST(SmoothOutline, SharedBordersStayShared) {
    Random random(11);
    for (int round = 0; round < 40; ++round) {
        // Blobs: random seeds, each cell to its nearest.
        Raster<std::uint16_t> values({0, 0}, 40, 30);
        std::vector<Cell> seeds;
        for (int i = 0; i < 9; ++i) {
            seeds.push_back({static_cast<std::int32_t>(random.below(40)),
                             static_cast<std::int32_t>(random.below(30))});
        }
        for (std::size_t i = 0; i < values.values.size(); ++i) {
            const Cell cell = values.cell(i);
            int least = INT32_MAX;
            for (std::size_t s = 0; s < seeds.size(); ++s) {
                const int dx = cell.x - seeds[s].x;
                const int dy = cell.y - seeds[s].y;
                if (dx * dx + dy * dy >= least) continue;
                least = dx * dx + dy * dy;
                values.values[i] = static_cast<std::uint16_t>(s % 4 + 1);
            }
        }
        // Every piece of border inside of the raster is walked once each way.
        std::map<std::tuple<int, int, int, int>, int> walked;
        for (const RegionOutline& outline : trace_outlines(values, round % 2 == 0 ? 0 : 1)) {
            for (const OutlineRing& line : outline.rings) {
                const std::vector<HalfCell> ring = smooth_ring(line);
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    const HalfCell a = ring[i];
                    const HalfCell b = ring[(i + 1) % ring.size()];
                    const bool at_frame = (a.x == b.x && (a.x == 0 || a.x == 80)) ||
                                          (a.y == b.y && (a.y == 0 || a.y == 60));
                    if (at_frame) continue;
                    ++walked[{a.x, a.y, b.x, b.y}];
                    --walked[{b.x, b.y, a.x, a.y}];
                }
            }
        }
        for (const auto& [edge, balance] : walked) EXPECT_EQ(balance, 0);
    }
}

double distance_to_segment(double x, double y, HalfCell a, HalfCell b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    double t = square == 0.0 ? 0.0 : ((x - a.x) * dx + (y - a.y) * dy) / square;
    t = std::clamp(t, 0.0, 1.0);
    return std::hypot(x - a.x - t * dx, y - a.y - t * dy);
}

TEST(SmoothOutline, PassesEveryCornerWithinACell) {
    Random random(12);
    for (int round = 0; round < 30; ++round) {
        Raster<std::uint16_t> values({0, 0}, 20, 20);
        for (std::uint16_t& value : values.values) value = random.uniform() < 0.7 ? 1 : 0;
        for (const RegionOutline& outline : trace_outlines(values)) {
            for (const OutlineRing& line : outline.rings) {
                const std::vector<HalfCell> ring = smooth_ring(line);
                for (const OutlinePoint& corner : line) {
                    double nearest = 1e9;
                    for (std::size_t i = 0; i < ring.size(); ++i) {
                        nearest = std::min(
                            nearest, distance_to_segment(2.0 * corner.x, 2.0 * corner.y, ring[i],
                                                         ring[(i + 1) % ring.size()]));
                    }
                    EXPECT_LE(nearest, 2.0);
                }
            }
        }
    }
}

}  // namespace
}  // namespace quadcut::io
