// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/basins.hpp"
#include "quadcut/rooms/wall_lines.hpp"

namespace quadcut {
namespace {

TEST(SpreadLabels, WhatStandsOnTheFloorBelongsToWhatIsAroundIt) {
    // A hole of 120 x 120 cells with a corner: each cell of it is come by on very many ways.
    Raster<std::uint32_t> labels({0, 0}, 140, 140, 1);
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const Cell cell = labels.cell(i);
        const bool is_right = cell.x >= 70;
        if (is_right) labels.values[i] = 2;
        const bool is_hole = cell.x >= 10 && cell.y >= 10 && cell.x < 130 && cell.y < 130;
        if (is_hole && (cell.x < 70 || cell.y < 70)) labels.values[i] = 0;
    }
    const Raster<std::uint8_t> open(labels.box(), 1);
    spread_labels(open, labels);
    EXPECT_EQ(std::count(labels.values.begin(), labels.values.end(), 0U), 0);
    EXPECT_EQ(labels.at({12, 60}), 1U);
    EXPECT_EQ(labels.at({127, 40}), 2U);
}

TEST(SpreadLabels, WhatIsNotOpenStaysBare) {
    Raster<std::uint32_t> labels({0, 0}, 3, 1);
    labels.values = {1, 0, 0};
    Raster<std::uint8_t> open(labels.box(), 1);
    open.values[2] = 0;
    spread_labels(open, labels);
    EXPECT_EQ(labels.values, (decltype(labels.values){1, 1, 0}));
}

TEST(SplitAtLines, EachPartHasALabelOfItsOwn) {
    Raster<std::uint32_t> labels({0, 0}, 5, 2, 1);
    WallLines lines{{}, Raster<std::uint8_t>(labels.box()), Raster<std::uint8_t>(labels.box())};
    for (const std::int32_t y : {0, 1}) lines.more_dm.at({2, y}) = 12;
    EXPECT_EQ(split_at_lines(lines, labels), 2U);
    EXPECT_EQ(labels.values, (decltype(labels.values){1, 1, 0, 2, 2, 1, 1, 0, 2, 2}));
}

}  // namespace
}  // namespace quadcut
