// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <gtest/gtest.h>

#include "quadcut/paper/line_of_sight.hpp"
#include "tests/oracle/visibility_oracle.hpp"
#include "tests/unit/paper/small_map.hpp"

namespace quadcut {
namespace {

BlockedCells blocked_cells(const test::States& states) {
    const Cell low = states.origin;
    BlockedCells blocked(low, {low.x + states.width - 1, low.y + states.height - 1});
    for (std::size_t i = 0; i < states.values.size(); ++i) {
        if (states.values[i] == CellState::free) blocked.open_square(states.cell(i), 1);
    }
    return blocked;
}

HalfCell random_point(Random& random, const test::States& states, std::uint64_t step) {
    const auto along = [&](std::int32_t low, std::int32_t cells) {
        const auto half_cells = static_cast<std::uint64_t>(2 * cells);
        return 2 * std::int64_t{low} +
               static_cast<std::int64_t>(step * random.below(half_cells / step + 1));
    };
    return {along(states.origin.x, states.width), along(states.origin.y, states.height)};
}

/// Compares many segments of one map, in both directions. Returns how many are clear.
int compare(Random& random, const test::States& states, std::uint64_t step, int num_segments) {
    const BlockedCells blocked = blocked_cells(states);
    int num_clear = 0;
    for (int i = 0; i < num_segments; ++i) {
        const HalfCell a = random_point(random, states, step);
        HalfCell b = random_point(random, states, step);
        // Segments along a line or a diagonal of the lattice are the delicate ones.
        const std::uint64_t kind = random.below(6);
        if (kind == 0) b.x = a.x;
        if (kind == 1) b.y = a.y;
        if (kind == 2) b.y = a.y + (b.x - a.x);
        if (kind == 3) b.y = a.y - (b.x - a.x);
        const std::int64_t low = 2 * std::int64_t{states.origin.y};
        if (a == b || b.y < low || b.y > low + 2 * states.height) continue;
        const bool expected = test::slow_line_of_sight(states, a, b);
        EXPECT_EQ(blocked.sees(a, b), expected) << a.x << ',' << a.y << " to " << b.x << ',' << b.y;
        EXPECT_EQ(blocked.sees(b, a), expected) << b.x << ',' << b.y << " to " << a.x << ',' << a.y;
        num_clear += expected ? 1 : 0;
    }
    return num_clear;
}

TEST(LineOfSightOracle, AllSegmentsOfAllMapsOfThreeByTwoCells) {
    constexpr std::int32_t kWidth = 3;
    constexpr std::int32_t kHeight = 2;
    for (unsigned pattern = 0; pattern < 1U << 6U; ++pattern) {
        test::States states({-1, -1}, kWidth, kHeight, CellState::free);
        for (unsigned i = 0; i < 6; ++i) {
            if ((pattern >> i & 1U) != 0) states.values[i] = CellState::occupied;
        }
        const BlockedCells blocked = blocked_cells(states);
        constexpr int kPoints = (2 * kWidth + 1) * (2 * kHeight + 1);
        const auto point = [](int i) {
            return HalfCell{i % (2 * kWidth + 1) - 2, i / (2 * kWidth + 1) - 2};
        };
        for (int i = 0; i < kPoints; ++i) {
            for (int j = 0; j < kPoints; ++j) {
                if (i == j) continue;
                EXPECT_EQ(blocked.sees(point(i), point(j)),
                          test::slow_line_of_sight(states, point(i), point(j)))
                    << "pattern " << pattern << ", points " << i << " and " << j;
            }
        }
    }
}

TEST(LineOfSightOracle, RandomSegmentsOnRandomMaps) {
    Random random(11);
    int num_clear = 0;
    for (int i = 0; i < 400; ++i) {
        const std::int32_t side = std::int32_t{4} << random.below(3);
        const test::States states = test::random_map(random, side, random.uniform(0.0, 0.2));
        num_clear += compare(random, states, 1, 40);
    }
    EXPECT_GT(num_clear, 2000);
}

TEST(LineOfSightOracle, SegmentsBetweenCornersOfCells) {
    Random random(12);
    int num_clear = 0;
    for (int i = 0; i < 400; ++i) {
        const std::int32_t side = std::int32_t{4} << random.below(2);
        const test::States states = test::random_map(random, side, random.uniform(0.0, 0.4));
        num_clear += compare(random, states, 2, 40);
    }
    EXPECT_GT(num_clear, 500);
}

TEST(LineOfSightOracle, LongSegmentsCrossWordsOfBits) {
    Random random(13);
    int num_clear = 0;
    for (int i = 0; i < 12; ++i) {
        test::States states({-100, 37}, 201, 9, CellState::free);
        for (int n = 0; n < 25; ++n) {
            states.values[random.below(states.values.size())] = CellState::occupied;
        }
        num_clear += compare(random, states, 1, 60);
    }
    EXPECT_GT(num_clear, 60);
}

}  // namespace
}  // namespace quadcut
