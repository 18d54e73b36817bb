// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

enum class CurveStyle : std::uint8_t { line, dots };

/// One line, or cloud of dots, of a plot.
struct Curve {
    std::string name;
    std::vector<Point> points;
    CurveStyle style = CurveStyle::line;
};

/// Curves over one axis. Axes begin at 0 but logarithmic ones; their names say the unit.
struct Plot {
    std::string title;
    std::string x_name;
    std::string y_name;
    std::vector<Curve> curves;
    /// The top of the y axis; 0: as high as the curves.
    double y_max = 0.0;
    /// Ticks of the x axis at whole numbers only: counts.
    bool is_x_whole = false;
    /// A logarithmic y axis from the power of ten below the lowest value; what is not above 0 is
    /// left out.
    bool is_y_log = false;
};

/// One bar of each group.
struct BarSeries {
    std::string name;
    /// One for each group; not above 0: no bar.
    std::vector<double> values;
};

/// Groups of bars, each with its value above it. The y axis is logarithmic when the values span
/// more than a factor of 30, and then begins at a power of ten.
struct BarPlot {
    std::string title;
    std::string y_name;
    std::string x_name;
    std::vector<std::string> groups;
    std::vector<BarSeries> series;
};

/// As SVG: a picture of its own for light and dark pages, legible at half its size. Names are plain
/// text; what is not finite is left out.
[[nodiscard]] std::string to_svg(const Plot& plot);
[[nodiscard]] std::string to_svg(const BarPlot& plot);

}  // namespace quadcut
