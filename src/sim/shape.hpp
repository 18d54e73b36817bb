// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"

namespace quadcut::sim {

/// Convex, corners in order, either orientation.
using Polygon = std::vector<Point>;

/// An axis-parallel rectangle in some frame, metres.
struct Rect {
    double x0 = 0.0;
    double y0 = 0.0;
    double x1 = 0.0;
    double y1 = 0.0;

    [[nodiscard]] double width() const { return x1 - x0; }
    [[nodiscard]] double height() const { return y1 - y0; }
    [[nodiscard]] double area() const { return width() * height(); }
    [[nodiscard]] Point center() const { return {0.5 * (x0 + x1), 0.5 * (y0 + y1)}; }
    [[nodiscard]] bool contains(const Point& p) const {
        return p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1;
    }
    /// Grows to hold all corners of a polygon.
    void include(const Polygon& polygon);
};

/// What a rectangle grows from.
inline constexpr Rect kNoRect{1e9, 1e9, -1e9, -1e9};

/// A frame of the plane: two unit vectors at right angles, in either handedness, so that a layout
/// can be mirrored. Quarter turns are exact.
struct Frame {
    Point origin;
    Point u{1.0, 0.0};
    Point v{0.0, 1.0};

    /// A point of this frame, in the frame's parent.
    [[nodiscard]] Point map(const Point& local) const {
        return {origin.x + local.x * u.x + local.y * v.x, origin.y + local.x * u.y + local.y * v.y};
    }
    /// A direction of this frame, in the frame's parent.
    [[nodiscard]] Point turn(const Point& local) const {
        return {local.x * u.x + local.y * v.x, local.x * u.y + local.y * v.y};
    }
    /// A point of the parent, in this frame.
    [[nodiscard]] Point local(const Point& parent) const {
        const Point d{parent.x - origin.x, parent.y - origin.y};
        return {d.x * u.x + d.y * u.y, d.x * v.x + d.y * v.y};
    }
    /// The same frame with another origin, given in this frame.
    [[nodiscard]] Frame at(const Point& local_origin) const { return {map(local_origin), u, v}; }
    /// The same place with the axes exchanged.
    [[nodiscard]] Frame swapped() const { return {origin, v, u}; }
};

/// a_from_c = a_from_b * b_from_c.
[[nodiscard]] inline Frame compose(const Frame& outer, const Frame& inner) {
    return {outer.map(inner.origin), outer.turn(inner.u), outer.turn(inner.v)};
}

[[nodiscard]] Rect grow(const Rect& rect, double margin);
[[nodiscard]] bool overlap(const Rect& a, const Rect& b);
[[nodiscard]] Polygon to_polygon(const Frame& frame, const Rect& rect);
/// Each edge moved outwards by `margin`; corners sharper than a right angle are blunted.
[[nodiscard]] Polygon grow(const Polygon& polygon, double margin);
/// Whether two convex polygons share more than their borders (separating axes).
[[nodiscard]] bool overlap(const Polygon& a, const Polygon& b);
[[nodiscard]] double area(const Polygon& polygon);

/// Cells of a raster: square, cell (0, 0) with its lower left corner at `origin`.
struct CellGrid {
    Point origin;
    double resolution_m = 0.05;
    std::int32_t width = 0;
    std::int32_t height = 0;

    [[nodiscard]] Cell cell(const Point& p) const;
    [[nodiscard]] Point center(const Cell& cell) const {
        return {origin.x + (cell.x + 0.5) * resolution_m, origin.y + (cell.y + 0.5) * resolution_m};
    }
    [[nodiscard]] bool contains(const Cell& cell) const {
        return cell.x >= 0 && cell.y >= 0 && cell.x < width && cell.y < height;
    }
};

/// Cells [first.x, first.x + count) of row first.y.
struct Span {
    Cell first;
    std::int32_t count = 0;
};

/// The cells whose centres lie in the polygon, by rows from below. Polygons that share an edge
/// leave no gap between them.
[[nodiscard]] std::vector<Span> rasterise(const Polygon& polygon, const CellGrid& grid);
/// The cells whose centres lie in the disc, and the one that holds its centre.
[[nodiscard]] std::vector<Span> rasterise_disc(const Point& center, double radius,
                                               const CellGrid& grid);

}  // namespace quadcut::sim
