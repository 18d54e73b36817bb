// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

/// One line of a plot.
struct Curve {
    std::string name;
    std::vector<Point> points;
};

/// Curves over one axis, as an SVG.
struct Plot {
    std::string title;
    std::string x_name;
    std::string y_name;
    std::vector<Curve> curves;
    /// The top of the y axis; 0: as high as the curves.
    double y_max = 0.0;
};

namespace plot {

inline constexpr double kWidth = 900.0;
inline constexpr double kHeight = 360.0;
inline constexpr double kLeft = 70.0;
inline constexpr double kRight = 20.0;
inline constexpr double kTop = 50.0;
inline constexpr double kBottom = 50.0;
inline constexpr std::array<const char*, 4> kColors{"#1f5fa8", "#c8502d", "#3c8c4a", "#7a5ba6"};

inline std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.5g", value);
    return text.data();
}

inline std::string text(double x, double y, const char* anchor, const std::string& words,
                        const char* color = "#333") {
    return "<text x='" + number(x) + "' y='" + number(y) + "' text-anchor='" + anchor + "' fill='" +
           color + "'>" + words + "</text>\n";
}

/// A round number of about a fifth of the range.
inline double tick(double range) {
    const double rough = std::max(range, 1e-9) / 5.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (rough <= step * power) return step * power;
    }
    return 10.0 * power;
}

}  // namespace plot

[[nodiscard]] inline std::string to_svg(const Plot& plot) {
    using plot::kBottom, plot::kHeight, plot::kLeft, plot::kRight, plot::kTop, plot::kWidth;
    using plot::number;
    double x_max = 0.0;
    double y_max = plot.y_max;
    for (const Curve& curve : plot.curves) {
        for (const Point& point : curve.points) {
            x_max = std::max(x_max, point.x);
            if (plot.y_max == 0.0) y_max = std::max(y_max, point.y);
        }
    }
    x_max = std::max(x_max, 1e-9);
    y_max = std::max(y_max, 1e-9);
    const auto px = [&](double x) { return kLeft + x / x_max * (kWidth - kLeft - kRight); };
    const auto py = [&](double y) {
        return kHeight - kBottom - std::min(y, y_max) / y_max * (kHeight - kTop - kBottom);
    };
    std::string svg = "<svg xmlns='http://www.w3.org/2000/svg' width='" + number(kWidth) +
                      "' height='" + number(kHeight) +
                      "' font-family='sans-serif' font-size='12'>\n"
                      "<rect width='100%' height='100%' fill='white'/>\n";
    svg += plot::text(kLeft, 20.0, "start", plot.title);
    const double y_step = plot::tick(y_max);
    for (double y = 0.0; y <= y_max * 1.0001; y += y_step) {
        svg += "<line x1='" + number(kLeft) + "' x2='" + number(kWidth - kRight) + "' y1='" +
               number(py(y)) + "' y2='" + number(py(y)) + "' stroke='#ddd'/>\n";
        svg += plot::text(kLeft - 6.0, py(y) + 4.0, "end", number(y));
    }
    const double x_step = plot::tick(x_max);
    for (double x = 0.0; x <= x_max * 1.0001; x += x_step) {
        svg += plot::text(px(x), kHeight - kBottom + 18.0, "middle", number(x));
    }
    svg += plot::text((kLeft + kWidth) / 2.0, kHeight - 10.0, "middle", plot.x_name);
    svg += plot::text(kLeft - 50.0, kTop - 12.0, "start", plot.y_name);
    double legend = kWidth - kRight;
    for (std::size_t i = plot.curves.size(); i-- > 0;) {
        const Curve& curve = plot.curves[i];
        const char* color = plot::kColors[i % plot::kColors.size()];
        svg +=
            "<polyline fill='none' stroke='" + std::string(color) + "' stroke-width='1.2' points='";
        for (const Point& point : curve.points) {
            svg += number(px(point.x)) + "," + number(py(point.y)) + " ";
        }
        svg += "'/>\n";
        svg += plot::text(legend, 20.0, "end", curve.name, color);
        legend -= 8.0 * static_cast<double>(curve.name.size()) + 20.0;
    }
    return svg + "</svg>\n";
}

}  // namespace quadcut
