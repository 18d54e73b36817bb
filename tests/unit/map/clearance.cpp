// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/clearance.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "tests/unit/rooms/drawing.hpp"

namespace quadcut {
namespace {

/// The nearest blocked cell of all, those around the raster included.
double brute_force_clearance(const Raster<std::uint8_t>& open, Cell cell) {
    double nearest = 1e30;
    for (std::int32_t y = -1; y <= open.height; ++y) {
        for (std::int32_t x = -1; x <= open.width; ++x) {
            if (open.contains({x, y}) && open.at({x, y}) != 0) continue;
            nearest = std::min(nearest, std::hypot(cell.x - x, cell.y - y));
        }
    }
    return nearest - 0.5;
}

TEST(Clearance, EqualsBruteForceOnRandomMasks) {
    Random random(7);
    for (int round = 0; round < 40; ++round) {
        Raster<std::uint8_t> open({0, 0}, static_cast<std::int32_t>(1 + random.below(30)),
                                  static_cast<std::int32_t>(1 + random.below(30)));
        const double share = random.uniform();
        for (std::uint8_t& value : open.values) value = random.uniform() < share ? 1 : 0;
        const Raster<float> clearance = clearance_m(open, 0.1);
        for (std::size_t i = 0; i < open.values.size(); ++i) {
            const double expected =
                open.values[i] == 0 ? 0.0 : 0.1 * brute_force_clearance(open, open.cell(i));
            ASSERT_NEAR(clearance.values[i], expected, 1e-5) << "cell " << i;
        }
    }
}

TEST(Clearance, MiddleOfACorridorIsHalfItsWidth) {
    // Five free cells across.
    const Raster<std::uint8_t> open =
        test::drawn_mask({"###########", "...........", "...........", "...........", "...........",
                          "...........", "###########"});
    const Raster<float> clearance = clearance_m(open, 0.2);
    EXPECT_FLOAT_EQ(clearance.at({5, 3}), 2.5F * 0.2F);
    EXPECT_FLOAT_EQ(clearance.at({5, 1}), 0.5F * 0.2F);
    EXPECT_FLOAT_EQ(clearance.at({5, 0}), 0.0F);
}

TEST(Clearance, ThreadsDoNotChangeAByte) {
    Raster<std::uint8_t> open({0, 0}, 3000, 90);
    Random random(3);
    for (std::uint8_t& value : open.values) value = random.uniform() < 0.97 ? 1 : 0;
    const Raster<float> one = clearance_m(open, 0.05, {1});
    for (const int num_threads : {2, 3, 8}) {
        EXPECT_EQ(clearance_m(open, 0.05, {num_threads}).values, one.values);
    }
}

TEST(Clearance, IsTheSameInTheMemoryOfAnotherRaster) {
    Raster<std::uint8_t> open({2, 3}, 40, 30, 1);
    open.at({20, 10}) = 0;
    const Raster<float> fresh = clearance_m(open, 0.05);
    for (const std::int32_t side : {3, 200}) {
        const Raster<float> again =
            clearance_m(open, 0.05, {}, Raster<float>({0, 0}, side, side, 7.0F));
        EXPECT_EQ(again.box(), fresh.box());
        EXPECT_EQ(again.values, fresh.values);
    }
}

TEST(Clearance, EmptyRasterIsFine) {
    EXPECT_TRUE(clearance_m(Raster<std::uint8_t>{}, 0.05).values.empty());
}

}  // namespace
}  // namespace quadcut
