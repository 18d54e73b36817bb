// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <string>
#include <vector>

#include "draw/typeface.hpp"
#include "io/palette.hpp"
#include "quadcut/base/geometry.hpp"

namespace quadcut::draw {

/// A patch of colour and what it stands for. Pixels, y down.
struct LegendLine {
    io::Rgb ink;
    io::Rgb border_ink;
    std::string text;
    /// The left end of the base line.
    Point left;
    /// Of the letters.
    double size = 0.0;

    /// The corners of the patch.
    [[nodiscard]] std::array<Point, 4> swatch() const;
    [[nodiscard]] Point text_left() const;
};

/// The line around a patch, of the letters' size.
inline constexpr double kSwatchBorder = 0.09;

/// How far a line reaches.
[[nodiscard]] double width_of(const LegendLine& line, const Typeface& typeface);

/// How far lines reach together.
struct LegendBlock {
    double width = 0.0;
    double height = 0.0;
};

/// Sets the lines one below the other, in columns from `corner`, the upper left one: at most
/// `height` high, or as high as all of them are wide when they would be wider than that.
LegendBlock set_in_columns(std::vector<LegendLine>& lines, const Point& corner, double height,
                           const Typeface& typeface);

}  // namespace quadcut::draw
