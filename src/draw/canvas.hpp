// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "io/image.hpp"
#include "io/palette.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"

namespace quadcut::draw {

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

    /// What a line encloses, or the line itself, as thick as it is.
    enum class Ink : std::uint8_t { inside, line, closed_line };

    /// The points of a line end at `end`, and begin where those of the line before do.
    struct Line {
        std::size_t end = 0;
        double width = 0.0;
        /// The rows it reaches over, at most.
        double top = 0.0;
        double bottom = 0.0;
        Ink ink = Ink::inside;
    };
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }
    [[nodiscard]] const std::vector<Point>& points() const { return points_; }
    /// The corner of the shape's box with the least coordinates, and the opposite one.
    [[nodiscard]] Point low() const { return low_; }
    [[nodiscard]] Point high() const { return high_; }

private:
    void add(std::span<const Point> points, Ink ink, double width);

    std::vector<Line> lines_;
    std::vector<Point> points_;
    Point low_{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    Point high_{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
};

/// A picture that areas are painted on, with smooth edges: each pixel takes the colour by the share
/// of it that the area covers. What is painted is kept as lines, and becomes pixels, a band of rows
/// at a time, when it is encoded: a whole page of pixels never lies in memory.
class Canvas {
public:
    /// @pre width and height are positive.
    Canvas(std::int32_t width, std::int32_t height, io::Rgb paper);

    [[nodiscard]] std::int32_t width() const { return width_; }
    [[nodiscard]] std::int32_t height() const { return height_; }
    /// Paints the whole row: for a look at a few pixels.
    [[nodiscard]] io::Rgb at(std::int32_t x, std::int32_t y) const;

    /// What lies outside of the page is cut off.
    void fill(Shape shape, io::Rgb color, double opacity = 1.0);

    /// 8-bit RGB. O(lines + pixels); the same bytes on any number of threads.
    [[nodiscard]] std::string encode_png(const Executor& executor = {}) const;

private:
    struct Layer {
        Shape shape;
        io::Rgb color;
        float opacity = 1.0F;
    };

    void paint(const io::ImageBand& band) const;

    std::int32_t width_;
    std::int32_t height_;
    io::Rgb paper_;
    std::vector<Layer> layers_;
};

}  // namespace quadcut::draw
