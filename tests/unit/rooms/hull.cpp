// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/hull.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

TEST(Hull, LeavesOutWhatLiesInsideOrOnASide) {
    const Hull hull = hull_of({{0, 0}, {4, 0}, {2, 0}, {4, 3}, {0, 3}, {1, 1}, {0, 0}});
    EXPECT_EQ(hull.corners.size(), 4U);
    EXPECT_DOUBLE_EQ(hull.area, 12.0);
}

TEST(Hull, FewerThanThreePointsEncloseNothing) {
    EXPECT_EQ(hull_of({{1, 2}, {1, 2}}).corners.size(), 1U);
    EXPECT_EQ(hull_of({{1, 2}, {3, 4}}).area, 0.0);
    EXPECT_EQ(hull_of(std::vector<Point>{}).corners.size(), 0U);
}

TEST(Hull, OfTwoHullsIsThatOfAllTheirPoints) {
    const std::vector<Point> left{{0, 0}, {2, 0}, {1, 3}};
    const std::vector<Point> right{{5, 1}, {7, 0}, {6, 4}};
    std::vector<Point> all = left;
    all.insert(all.end(), right.begin(), right.end());
    const Hull both = hull_of(hull_of(left), hull_of(right));
    EXPECT_EQ(both.corners, hull_of(all).corners);
    EXPECT_DOUBLE_EQ(both.area, hull_of(all).area);
}

TEST(Hull, RowsOfCellsAreEnclosedWithTheirFarSides) {
    HullOfRows rows;
    rows.add(0, 2, 3);
    // Two runs of one row.
    rows.add(1, 1, 2);
    rows.add(1, 3, 4);
    rows.add(2, 2, 3);
    // A plus of cells, three wide: its hull is an octagon without the four corner triangles.
    EXPECT_DOUBLE_EQ(rows.take().area, 9.0 - 4.0 * 0.5);
    EXPECT_DOUBLE_EQ(HullOfRows().take().area, 0.0);
}

TEST(Hull, TheSmallestRectangleMayLieAcross) {
    // A square of side 2 that stands on its corner.
    const double half = std::sqrt(2.0);
    const Rectangle turned =
        smallest_rectangle(hull_of({{0, -half}, {half, 0}, {0, half}, {-half, 0}}));
    EXPECT_NEAR(turned.length, 2.0, 1e-12);
    EXPECT_NEAR(turned.width, 2.0, 1e-12);
    const Rectangle upright = smallest_rectangle(hull_of({{0, 0}, {1, 0}, {1, 5}, {0, 5}}));
    EXPECT_DOUBLE_EQ(upright.length, 5.0);
    EXPECT_DOUBLE_EQ(upright.width, 1.0);
    EXPECT_EQ(smallest_rectangle({}).length, 0.0);
}

}  // namespace
}  // namespace quadcut
