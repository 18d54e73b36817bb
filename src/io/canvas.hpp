// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/image.hpp"
#include "io/palette.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"

namespace quadcut::io {

/// An area of the page, as lines around it. Pixels; x to the right, y down. What is enclosed once
/// or more, whichever way round, is inside; a hole runs against the line around it.
class Shape {
public:
    /// A closed polygon; the last point joins the first.
    void add_polygon(std::span<const Point> points);
    /// A thick line with round ends and joints.
    void add_line(std::span<const Point> points, double width);
    /// The same along a closed polygon.
    void add_closed_line(std::span<const Point> points, double width);
    void add_disc(Point center, double radius);

    /// A side of the area that is not level, from (x0, y0) to (x1, y1).
    struct Edge {
        float x0 = 0.0F;
        float y0 = 0.0F;
        float x1 = 0.0F;
        float y1 = 0.0F;
    };
    [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }

private:
    void add_edge(Point from, Point to);
    void add_discs(std::span<const Point> centers, double radius);
    void add_segment(Point from, Point to, double width);

    std::vector<Edge> edges_;
};

/// A picture that areas are painted on, with smooth edges: each pixel takes the colour by the share
/// of it that the area covers. What is painted is kept as lines, and becomes pixels, a band of rows
/// at a time, when it is encoded: a whole page of pixels never lies in memory.
class Canvas {
public:
    /// @pre width and height are positive.
    Canvas(std::int32_t width, std::int32_t height, Rgb paper);

    [[nodiscard]] std::int32_t width() const { return width_; }
    [[nodiscard]] std::int32_t height() const { return height_; }
    /// Paints the whole row: for a look at a few pixels.
    [[nodiscard]] Rgb at(std::int32_t x, std::int32_t y) const;

    /// What lies outside of the page is cut off.
    void fill(const Shape& shape, Rgb color, double opacity = 1.0);

    /// 8-bit RGB. O(edges + pixels); the same bytes on any number of threads.
    [[nodiscard]] std::string encode_png(const Executor& executor = {}) const;

private:
    /// An area painted with one colour: its edges end at `end`, and begin where those before do.
    struct Layer {
        std::size_t end = 0;
        Rgb color;
        float opacity = 1.0F;
    };

    /// `edges`: ascending places of those that the band meets.
    void paint(std::span<const std::uint32_t> edges, const ImageBand& band) const;

    std::int32_t width_;
    std::int32_t height_;
    Rgb paper_;
    std::vector<Shape::Edge> edges_;
    std::vector<Layer> layers_;
};

}  // namespace quadcut::io
