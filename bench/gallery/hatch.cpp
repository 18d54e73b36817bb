// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/hatch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace quadcut::gallery {

draw::Shape hatch(const std::vector<std::vector<Point>>& polygons, double spacing,
                  double line_width) {
    // A line holds the points of one x + y.
    const double step = spacing * std::numbers::sqrt2;
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    for (const std::vector<Point>& polygon : polygons) {
        for (const Point& point : polygon) {
            low = std::min(low, point.x + point.y);
            high = std::max(high, point.x + point.y);
        }
    }
    draw::Shape shape;
    for (double sum = std::ceil(low / step) * step; sum < high; sum += step) {
        std::vector<double> crossings;
        for (const std::vector<Point>& polygon : polygons) {
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Point& from = polygon[i];
                const Point& to = polygon[(i + 1) % polygon.size()];
                const double a = from.x + from.y - sum;
                const double b = to.x + to.y - sum;
                // Half open, so that a corner on the line counts once.
                if ((a < 0.0) == (b < 0.0)) continue;
                crossings.push_back(from.x + (to.x - from.x) * a / (a - b));
            }
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const std::array<Point, 2> line = {Point{crossings[i], sum - crossings[i]},
                                               Point{crossings[i + 1], sum - crossings[i + 1]}};
            shape.add_line(line, line_width);
        }
    }
    return shape;
}

}  // namespace quadcut::gallery
