// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/raster.hpp"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "quadcut/map/morton.hpp"

namespace quadcut {
namespace {

TEST(Raster, AllCellsHaveTheValueFromThreadsToo) {
    for (const int num_threads : {1, 2, 3, 8}) {
        // More than one chunk, and a rest.
        const Raster<std::uint16_t> raster({-4, 7}, 1201, 733, 513, {num_threads});
        ASSERT_EQ(raster.values.size(), 1201U * 733U);
        EXPECT_TRUE(std::all_of(raster.values.begin(), raster.values.end(),
                                [](std::uint16_t value) { return value == 513; }));
    }
    const Raster<float> zeros(Box{{1, 2}, {3, 4}});
    EXPECT_EQ(zeros.values, Raster<float>::Values(9, 0.0F));
    EXPECT_TRUE(Raster<float>({0, 0}, 0, 5).values.empty());
}

TEST(Raster, BlocksOfABoxAreNumberedFromItsLowerLeft) {
    const Box box{{-300, -100}, {500, 400}};
    EXPECT_EQ(block_code({-300, -100}, box), 0U);
    EXPECT_EQ(block_code({-237, -37}, box), 0U);
    EXPECT_EQ(block_code({-236, -37}, box), 1U);
    EXPECT_EQ(block_code({-300, -36}, box), 2U);
}

}  // namespace
}  // namespace quadcut
