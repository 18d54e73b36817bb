// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

/// A convex polygon, its corners counter-clockwise; fewer than three enclose nothing.
struct Hull {
    std::vector<Point> corners;
    double area = 0.0;
};

/// The convex hull of points (Andrew's monotone chain, 1979). O(points log points).
[[nodiscard]] Hull hull_of(std::vector<Point> points);

/// The hull of both. O(corners log corners).
[[nodiscard]] Hull hull_of(const Hull& a, const Hull& b);

/// The hull of what comes row by row from below, without sorting.
class HullOfRows {
public:
    /// The cells begin .. end - 1 of a row. Rows come in order, of one row as many as like.
    void add(double y, double begin, double end);
    [[nodiscard]] Hull take();

private:
    void close_row();

    std::vector<Point> left_;
    std::vector<Point> right_;
    bool is_open_ = false;
    double y_ = 0.0;
    double begin_ = 0.0;
    double end_ = 0.0;
};

/// The sides of the smallest rectangle around a hull, whatever its direction.
struct Rectangle {
    double length = 0.0;
    double width = 0.0;
};

/// One of its sides lies on a side of the hull (Freeman and Shapira, 1975). O(corners^2).
[[nodiscard]] Rectangle smallest_rectangle(const Hull& hull);

}  // namespace quadcut
