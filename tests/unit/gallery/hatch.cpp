// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/hatch.hpp"

#include <gtest/gtest.h>

namespace quadcut::gallery {
namespace {

TEST(GalleryHatch, FillsThePolygonButNotItsHole) {
    constexpr io::Rgb kWhite{255, 255, 255};
    draw::Canvas canvas(100, 100, kWhite);
    const std::vector<std::vector<Point>> square_with_hole = {
        {{10, 10}, {90, 10}, {90, 90}, {10, 90}}, {{30, 30}, {30, 70}, {70, 70}, {70, 30}}};
    canvas.fill(hatch(square_with_hole, 8.0, 1.0), {0, 0, 0});
    const auto ink_in = [&](std::int32_t low, std::int32_t high, std::int32_t y) {
        std::int32_t sum = 0;
        for (std::int32_t x = low; x < high; ++x) sum += 255 - canvas.at(x, y).red;
        return sum / 255.0;
    };
    EXPECT_EQ(ink_in(0, 100, 5), 0.0) << "outside";
    EXPECT_EQ(ink_in(32, 68, 50), 0.0) << "in the hole";
    // A line of one pixel, slanted, each 8 sqrt(2) pixels of a row.
    EXPECT_NEAR(ink_in(10, 90, 20), 80.0 / 8.0, 2.0);
    EXPECT_NEAR(ink_in(10, 30, 50) + ink_in(70, 90, 50), 40.0 / 8.0, 2.0);
}

TEST(GalleryHatch, OfNothingIsNothing) { EXPECT_TRUE(hatch({}, 8.0, 1.0).lines().empty()); }

}  // namespace
}  // namespace quadcut::gallery
