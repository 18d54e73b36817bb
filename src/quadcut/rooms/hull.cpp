// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/hull.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace quadcut {
namespace {

/// Positive where the way from a over b to c turns left.
double turn(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Adds points from `first` on; the corners before stay.
template <typename Iterator>
void add_chain(Iterator first, Iterator last, std::vector<Point>& corners) {
    const std::size_t start = corners.size();
    for (; first != last; ++first) {
        while (corners.size() >= start + 2 &&
               turn(corners[corners.size() - 2], corners.back(), *first) <= 0.0) {
            corners.pop_back();
        }
        corners.push_back(*first);
    }
    corners.pop_back();
}

/// A corner that lies farther on; those before that are in its shadow go. `side` 1: a chain that
/// turns left.
void add_corner(const Point& corner, double side, std::vector<Point>& chain) {
    while (chain.size() >= 2 && side * turn(chain[chain.size() - 2], chain.back(), corner) <= 0.0) {
        chain.pop_back();
    }
    chain.push_back(corner);
}

double enclosed_area(const std::vector<Point>& corners) {
    double area = 0.0;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        area += 0.5 * turn(corners[0], corners[i - 1], corners[i]);
    }
    return area;
}

}  // namespace

Hull hull_of(std::vector<Point> points) {
    std::sort(points.begin(), points.end(), [](const Point& p, const Point& q) {
        return std::tie(p.x, p.y) < std::tie(q.x, q.y);
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    Hull hull;
    if (points.size() < 3) {
        hull.corners = std::move(points);
        return hull;
    }
    add_chain(points.begin(), points.end(), hull.corners);
    add_chain(points.rbegin(), points.rend(), hull.corners);
    hull.area = enclosed_area(hull.corners);
    return hull;
}

void HullOfRows::add(double y, double begin, double end) {
    if (is_open_ && y == y_) {
        begin_ = std::min(begin_, begin);
        end_ = std::max(end_, end);
        return;
    }
    close_row();
    is_open_ = true;
    y_ = y;
    begin_ = begin;
    end_ = end;
}

void HullOfRows::close_row() {
    if (!is_open_) return;
    for (const double y : {y_, y_ + 1.0}) {
        add_corner({begin_, y}, -1.0, left_);
        add_corner({end_, y}, 1.0, right_);
    }
}

Hull HullOfRows::take() {
    close_row();
    Hull hull;
    hull.corners = std::move(right_);
    hull.corners.insert(hull.corners.end(), left_.rbegin(), left_.rend());
    hull.area = enclosed_area(hull.corners);
    return hull;
}

Hull hull_of(const Hull& a, const Hull& b) {
    std::vector<Point> points = a.corners;
    points.insert(points.end(), b.corners.begin(), b.corners.end());
    return hull_of(std::move(points));
}

Rectangle smallest_rectangle(const Hull& hull) {
    Rectangle best;
    double least = -1.0;
    const std::size_t count = hull.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Point& from = hull.corners[i];
        const Point& to = hull.corners[(i + 1) % count];
        const double side = std::hypot(to.x - from.x, to.y - from.y);
        if (side == 0.0) continue;
        const Point along{(to.x - from.x) / side, (to.y - from.y) / side};
        double low = 0.0;
        double high = 0.0;
        double height = 0.0;
        for (const Point& corner : hull.corners) {
            const double x = corner.x - from.x;
            const double y = corner.y - from.y;
            low = std::min(low, x * along.x + y * along.y);
            high = std::max(high, x * along.x + y * along.y);
            height = std::max(height, y * along.x - x * along.y);
        }
        const double area = (high - low) * height;
        if (least >= 0.0 && area >= least) continue;
        least = area;
        best = {std::max(high - low, height), std::min(high - low, height)};
    }
    return best;
}

}  // namespace quadcut
