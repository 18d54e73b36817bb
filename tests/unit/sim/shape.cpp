// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/shape.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace quadcut::sim {
namespace {

Frame turned(double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {{3.0, 2.0}, {c, s}, {-s, c}};
}

std::vector<int> count(const std::vector<Polygon>& polygons, const CellGrid& grid) {
    std::vector<int> hits(static_cast<std::size_t>(grid.width * grid.height), 0);
    for (const Polygon& polygon : polygons) {
        for (const Span& span : rasterise(polygon, grid)) {
            for (std::int32_t i = 0; i < span.count; ++i) {
                ++hits[static_cast<std::size_t>(span.first.y * grid.width + span.first.x + i)];
            }
        }
    }
    return hits;
}

TEST(Shape, TurnedRectangleHasTheCellsWhoseCentresAreInside) {
    const CellGrid grid{{0.0, 0.0}, 0.05, 140, 120};
    const Rect rect{-1.0, -0.5, 1.5, 0.8};
    const Frame frame = turned(0.5);
    const std::vector<int> hits = count({to_polygon(frame, rect)}, grid);
    int num_inside = 0;
    for (std::int32_t y = 0; y < grid.height; ++y) {
        for (std::int32_t x = 0; x < grid.width; ++x) {
            const bool inside = rect.contains(frame.local(grid.center({x, y})));
            num_inside += inside ? 1 : 0;
            EXPECT_EQ(hits[static_cast<std::size_t>(y * grid.width + x)], inside ? 1 : 0);
        }
    }
    EXPECT_NEAR(num_inside * 0.0025, rect.area(), 0.1);
}

TEST(Shape, NeighboursLeaveNoGapAndShareNoCell) {
    const CellGrid grid{{0.0, 0.0}, 0.05, 140, 120};
    for (const double angle : {0.0, 0.3, 0.7853981633974483, 1.2}) {
        const Frame frame = turned(angle);
        const std::vector<int> whole = count({to_polygon(frame, {-1, -1, 1, 1})}, grid);
        const std::vector<int> parts =
            count({to_polygon(frame, {-1, -1, 0.3, 1}), to_polygon(frame, {0.3, -1, 1, 1})}, grid);
        EXPECT_EQ(whole, parts) << angle;
    }
}

TEST(Shape, DiscAlwaysHasTheCellOfItsCentre) {
    const CellGrid grid{{0.0, 0.0}, 0.05, 40, 40};
    const std::vector<Span> tiny = rasterise_disc({1.01, 1.01}, 0.01, grid);
    ASSERT_EQ(tiny.size(), 1U);
    EXPECT_EQ(tiny[0].first, (Cell{20, 20}));
    EXPECT_EQ(tiny[0].count, 1);

    int cells = 0;
    for (const Span& span : rasterise_disc({1.0, 1.0}, 0.5, grid)) cells += span.count;
    EXPECT_NEAR(cells * 0.0025, M_PI * 0.25, 0.03);
}

TEST(Shape, OverlapNeedsSharedInside) {
    const Polygon a = to_polygon({}, {0, 0, 1, 1});
    EXPECT_FALSE(overlap(a, to_polygon({}, {1, 0, 2, 1})));
    EXPECT_TRUE(overlap(a, to_polygon({}, {0.9, 0, 2, 1})));
    // Their bounding boxes overlap, they do not.
    const Frame diagonal{{1.6, 1.6}, {M_SQRT1_2, M_SQRT1_2}, {-M_SQRT1_2, M_SQRT1_2}};
    EXPECT_FALSE(overlap(a, to_polygon(diagonal, {-0.7, -2, 0.7, 2})));
    EXPECT_TRUE(overlap(a, to_polygon(diagonal, {-0.95, -2, 0.7, 2})));
}

TEST(Shape, GrowMovesEveryEdge) {
    for (const Frame& frame : {turned(0.4), Frame{{0, 0}, {1, 0}, {0, -1}}}) {
        const Polygon grown = grow(to_polygon(frame, {0, 0, 2, 1}), 0.25);
        EXPECT_NEAR(area(grown), 2.5 * 1.5, 1e-9);
        EXPECT_TRUE(overlap(grown, to_polygon(frame, {2.1, 0.2, 2.2, 0.3})));
        EXPECT_FALSE(overlap(grown, to_polygon(frame, {2.3, 0.2, 2.4, 0.3})));
    }
}

TEST(Shape, FramesComposeAndTurnBack) {
    const Frame outer = turned(0.6);
    const Frame inner{{1.0, -2.0}, {0, 1}, {1, 0}};  // mirrored
    const Point p{0.3, 0.7};
    const Point q = compose(outer, inner).map(p);
    EXPECT_NEAR(distance(q, outer.map(inner.map(p))), 0.0, 1e-12);
    EXPECT_NEAR(distance(compose(outer, inner).local(q), p), 0.0, 1e-12);
}

}  // namespace
}  // namespace quadcut::sim
