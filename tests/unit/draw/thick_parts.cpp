// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/thick_parts.hpp"

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"

namespace quadcut::draw {
namespace {

/// By the definition.
Raster<std::uint8_t> covered_by_squares(const Raster<std::uint8_t>& mask, std::int32_t side) {
    Raster<std::uint8_t> result(mask.origin, mask.width, mask.height);
    const auto is_set = [&](Cell cell) { return !mask.contains(cell) || mask.at(cell) != 0; };
    for (std::int32_t y = -side; y < mask.height + side; ++y) {
        for (std::int32_t x = -side; x < mask.width + side; ++x) {
            bool full = true;
            for (std::int32_t i = 0; i < side * side; ++i) {
                const Cell cell{mask.origin.x + x + i % side, mask.origin.y + y + i / side};
                full = full && is_set(cell);
            }
            for (std::int32_t i = 0; full && i < side * side; ++i) {
                const Cell cell{mask.origin.x + x + i % side, mask.origin.y + y + i / side};
                if (mask.contains(cell)) result.at(cell) = 1;
            }
        }
    }
    return result;
}

TEST(ThickParts, AreThoseThatSquaresCover) {
    Random random(21);
    for (int round = 0; round < 100; ++round) {
        Raster<std::uint8_t> mask({5, -2}, 1 + static_cast<std::int32_t>(random.below(16)),
                                  1 + static_cast<std::int32_t>(random.below(16)));
        for (std::uint8_t& cell : mask.values) cell = random.uniform() < 0.85 ? 1 : 0;
        const auto side = 1 + static_cast<std::int32_t>(random.below(5));
        EXPECT_EQ(find_thick_parts(mask, side).values, covered_by_squares(mask, side).values)
            << mask.width << " x " << mask.height << ", side " << side;
    }
}

TEST(ThickParts, DeepOnesHaveAMarginAllAround) {
    Random random(22);
    for (int round = 0; round < 100; ++round) {
        Raster<std::uint8_t> mask({5, -2}, 1 + static_cast<std::int32_t>(random.below(16)),
                                  1 + static_cast<std::int32_t>(random.below(16)));
        for (std::uint8_t& cell : mask.values) cell = random.uniform() < 0.9 ? 1 : 0;
        const auto margin = static_cast<std::int32_t>(random.below(4));
        const Raster<std::uint8_t> deep = find_deep_parts(mask, margin);
        for (std::size_t i = 0; i < mask.values.size(); ++i) {
            const Cell cell = mask.cell(i);
            bool expected = true;
            for (std::int32_t dy = -margin; dy <= margin; ++dy) {
                for (std::int32_t dx = -margin; dx <= margin; ++dx) {
                    const Cell near{cell.x + dx, cell.y + dy};
                    expected = expected && (!mask.contains(near) || mask.at(near) != 0);
                }
            }
            EXPECT_EQ(deep.values[i], expected ? 1 : 0);
        }
    }
}

}  // namespace
}  // namespace quadcut::draw
