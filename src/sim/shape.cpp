// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadcut::sim {
namespace {

struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

Interval project(const Polygon& polygon, const Point& axis) {
    Interval interval;
    for (const Point& p : polygon) interval.add(p.x * axis.x + p.y * axis.y);
    return interval;
}

// Whether one of a's edge normals separates the two.
bool separated_by(const Polygon& a, const Polygon& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point& p = a[i];
        const Point& q = a[(i + 1) % a.size()];
        const double length = distance(p, q);
        if (length == 0.0) continue;
        const Point axis{(q.y - p.y) / length, (p.x - q.x) / length};
        const Interval on_a = project(a, axis);
        const Interval on_b = project(b, axis);
        constexpr double kTouch = 1e-9;
        if (on_a.high <= on_b.low + kTouch || on_b.high <= on_a.low + kTouch) return true;
    }
    return false;
}

double signed_area(const Polygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& p = polygon[i];
        const Point& q = polygon[(i + 1) % polygon.size()];
        twice += p.x * q.y - q.x * p.y;
    }
    return 0.5 * twice;
}

// The part of the horizontal line y inside a convex polygon; low > high when there is none.
Interval section(const Polygon& polygon, double y) {
    Interval interval;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& p = polygon[i];
        const Point& q = polygon[(i + 1) % polygon.size()];
        if ((p.y <= y) == (q.y <= y)) continue;
        interval.add(p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x));
    }
    return interval;
}

// First cell whose centre is at or above a coordinate.
std::int32_t first_center(double coordinate, double origin, double resolution) {
    return static_cast<std::int32_t>(std::ceil((coordinate - origin) / resolution - 0.5));
}

void add_span(std::vector<Span>& spans, const CellGrid& grid, const Interval& x, std::int32_t row) {
    if (x.low > x.high) return;
    const std::int32_t first = std::max(0, first_center(x.low, grid.origin.x, grid.resolution_m));
    const std::int32_t end =
        std::min(grid.width, first_center(x.high, grid.origin.x, grid.resolution_m));
    if (first < end) spans.push_back({{first, row}, end - first});
}

}  // namespace

void Rect::include(const Polygon& polygon) {
    const Interval x = project(polygon, {1.0, 0.0});
    const Interval y = project(polygon, {0.0, 1.0});
    *this = {std::min(x0, x.low), std::min(y0, y.low), std::max(x1, x.high), std::max(y1, y.high)};
}

Rect grow(const Rect& rect, double margin) {
    return {rect.x0 - margin, rect.y0 - margin, rect.x1 + margin, rect.y1 + margin};
}

bool overlap(const Rect& a, const Rect& b) {
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

Polygon to_polygon(const Frame& frame, const Rect& rect) {
    return {frame.map({rect.x0, rect.y0}), frame.map({rect.x1, rect.y0}),
            frame.map({rect.x1, rect.y1}), frame.map({rect.x0, rect.y1})};
}

Polygon grow(const Polygon& polygon, double margin) {
    const double outwards = signed_area(polygon) > 0.0 ? margin : -margin;
    const std::size_t n = polygon.size();
    const auto normal = [&](std::size_t i) {
        const Point& p = polygon[i];
        const Point& q = polygon[(i + 1) % n];
        const double length = distance(p, q);
        return Point{(q.y - p.y) / length, (p.x - q.x) / length};
    };
    Polygon grown;
    for (std::size_t i = 0; i < n; ++i) {
        const Point before = normal((i + n - 1) % n);
        const Point after = normal(i);
        // The corner moves along the bisector so that both edges move by the margin; less at a
        // sharp corner, which would become a spike.
        const double straightness = before.x * after.x + before.y * after.y;
        const double scale = outwards / (1.0 + std::max(straightness, -0.1));
        grown.push_back({polygon[i].x + scale * (before.x + after.x),
                         polygon[i].y + scale * (before.y + after.y)});
    }
    return grown;
}

bool overlap(const Polygon& a, const Polygon& b) {
    return !separated_by(a, b) && !separated_by(b, a);
}

double area(const Polygon& polygon) { return std::abs(signed_area(polygon)); }

Cell CellGrid::cell(const Point& p) const {
    return {static_cast<std::int32_t>(std::floor((p.x - origin.x) / resolution_m)),
            static_cast<std::int32_t>(std::floor((p.y - origin.y) / resolution_m))};
}

std::vector<Span> rasterise(const Polygon& polygon, const CellGrid& grid) {
    const Interval y = project(polygon, {0.0, 1.0});
    const std::int32_t first = std::max(0, first_center(y.low, grid.origin.y, grid.resolution_m));
    const std::int32_t end =
        std::min(grid.height, first_center(y.high, grid.origin.y, grid.resolution_m));
    std::vector<Span> spans;
    for (std::int32_t row = first; row < end; ++row) {
        add_span(spans, grid, section(polygon, grid.center({0, row}).y), row);
    }
    return spans;
}

std::vector<Span> rasterise_disc(const Point& center, double radius, const CellGrid& grid) {
    const Cell middle = grid.cell(center);
    const auto reach = static_cast<std::int32_t>(std::ceil(radius / grid.resolution_m));
    std::vector<Span> spans;
    for (std::int32_t row = middle.y - reach; row <= middle.y + reach; ++row) {
        if (row < 0 || row >= grid.height) continue;
        const double dy = grid.center({0, row}).y - center.y;
        const double half = radius * radius - dy * dy;
        const std::size_t before = spans.size();
        if (half >= 0.0) {
            const double dx = std::sqrt(half);
            add_span(spans, grid, {center.x - dx, center.x + dx}, row);
        }
        const bool found = spans.size() > before;
        if (row == middle.y && !found && grid.contains(middle)) spans.push_back({middle, 1});
    }
    return spans;
}

}  // namespace quadcut::sim
