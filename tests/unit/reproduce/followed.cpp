// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/followed.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "reproduce/partition.hpp"
#include "tests/unit/rooms/drawing.hpp"

namespace quadcut::reproduce {
namespace {

/// Three regions beside each other, 1 m x 1 m each, on a map that begins at (10, 0).
draw::Moment three_regions(const std::vector<Point>& way) {
    draw::Moment moment;
    moment.map = test::drawn_map({"..."}, 0.1, 10);
    moment.map.map_from_image.x = 10.0;
    Raster<std::uint32_t> labels(moment.map.states.box());
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        labels.values[i] = static_cast<std::uint32_t>(labels.cell(i).x / 10 + 1);
    }
    moment.rooms = as_segmentation(labels, moment.map);
    moment.way = way;
    return moment;
}

TEST(Followed, RegionsThatTheWayDoesNotCrossAreCounted) {
    EXPECT_EQ(count_uncrossed(three_regions({})), 3U);
    EXPECT_EQ(count_uncrossed(three_regions({{10.5, 0.5}})), 2U);
    EXPECT_EQ(count_uncrossed(three_regions({{10.5, 0.5}, {11.5, 0.5}})), 1U);
    // Between two poses the robot went straight on.
    EXPECT_EQ(count_uncrossed(three_regions({{10.5, 0.5}, {12.5, 0.5}})), 0U);
    EXPECT_EQ(count_uncrossed(three_regions({{10.5, 5.0}, {12.5, 5.0}})), 3U);
}

TEST(Followed, MeanAndMedian) {
    EXPECT_EQ(mean({}), 0.0);
    EXPECT_EQ(mean({{1.0, 2.0}, {2.0, 4.0}}), 3.0);
    EXPECT_EQ(median({}), 0.0);
    EXPECT_EQ(median(heights({{1.0, 7.0}, {2.0, 1.0}, {3.0, 3.0}})), 3.0);
}

}  // namespace
}  // namespace quadcut::reproduce
