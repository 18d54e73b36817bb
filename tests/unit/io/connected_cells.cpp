// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/connected_cells.hpp"

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"
#include "tests/unit/io/floor_drawing.hpp"

namespace quadcut::io {
namespace {

TEST(ConnectedCells, AreNumberedByFirstCellFromTheLowestRow) {
    const CellRegions regions = number_connected(test::drawn_values({"a.b", "aab", "b.a"}));
    EXPECT_EQ(regions.values, (std::vector<std::uint32_t>{2, 1, 1, 2}));
    EXPECT_EQ(regions.num_cells, (std::vector<std::size_t>{1, 1, 3, 2}));
    EXPECT_EQ(regions.numbers.values, (std::vector<std::uint32_t>{1, 0, 2, 3, 3, 4, 3, 0, 4}));
}

TEST(ConnectedCells, JoinAcrossCornersForOneValueOnly) {
    const std::vector<std::string> drawing = {"ab", "ba"};
    EXPECT_EQ(number_connected(test::drawn_values(drawing)).values.size(), 4U);
    EXPECT_EQ(number_connected(test::drawn_values(drawing), 1).values,
              (std::vector<std::uint32_t>{2, 1, 2}));
}

TEST(ConnectedCells, JoinArmsThatMeetLate) {
    const CellRegions regions = number_connected(test::drawn_values({"aaaaa", "a.a.a", "a.a.a"}));
    EXPECT_EQ(regions.num_cells, (std::vector<std::size_t>{11}));
}

/// Regions by plain flooding, numbered alike.
Raster<std::uint32_t> flooded(const Raster<std::uint32_t>& values, std::uint32_t diagonal_value) {
    Raster<std::uint32_t> numbers(values.origin, values.width, values.height);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < values.values.size(); ++i) {
        if (values.values[i] == 0 || numbers.values[i] != 0) continue;
        numbers.values[i] = ++count;
        std::vector<Cell> open{values.cell(i)};
        while (!open.empty()) {
            const Cell cell = open.back();
            open.pop_back();
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const Cell next{cell.x + dx, cell.y + dy};
                    const bool allowed = dx == 0 || dy == 0 || values.values[i] == diagonal_value;
                    if (!allowed || !values.contains(next) || numbers.at(next) != 0 ||
                        values.at(next) != values.values[i]) {
                        continue;
                    }
                    numbers.at(next) = count;
                    open.push_back(next);
                }
            }
        }
    }
    return numbers;
}

TEST(ConnectedCells, AreThoseOfPlainFlooding) {
    Random random(5);
    for (int round = 0; round < 100; ++round) {
        Raster<std::uint32_t> values({3, -4}, 1 + static_cast<std::int32_t>(random.below(20)),
                                     1 + static_cast<std::int32_t>(random.below(20)));
        for (std::uint32_t& value : values.values) {
            value = static_cast<std::uint32_t>(random.below(4));
        }
        EXPECT_EQ(number_connected(values, 2).numbers.values, flooded(values, 2).values);
    }
}

}  // namespace
}  // namespace quadcut::io
