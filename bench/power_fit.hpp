// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

/// y = factor * x^exponent.
struct PowerFit {
    double exponent = 0.0;
    double factor = 0.0;
    /// How far a point lies from the line at most, as a factor >= 1.
    double largest_deviation = 1.0;
    std::size_t num_points = 0;
};

/// Least squares of the logarithms. Points that are not positive do not count; with fewer than two
/// of different x, all is 0.
inline PowerFit fit_power(std::span<const Point> points) {
    double n = 0.0;
    double sum_x = 0.0;
    double sum_y = 0.0;
    double sum_xx = 0.0;
    double sum_xy = 0.0;
    for (const Point& point : points) {
        if (!(point.x > 0.0 && point.y > 0.0)) continue;
        const double x = std::log(point.x);
        const double y = std::log(point.y);
        n += 1.0;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    PowerFit fit;
    fit.num_points = static_cast<std::size_t>(n);
    const double spread = n * sum_xx - sum_x * sum_x;
    if (n < 2.0 || spread <= 1e-12 * n * sum_xx) return fit;
    fit.exponent = (n * sum_xy - sum_x * sum_y) / spread;
    fit.factor = std::exp((sum_y - fit.exponent * sum_x) / n);
    for (const Point& point : points) {
        if (!(point.x > 0.0 && point.y > 0.0)) continue;
        const double ratio = point.y / (fit.factor * std::pow(point.x, fit.exponent));
        fit.largest_deviation = std::max(fit.largest_deviation, std::max(ratio, 1.0 / ratio));
    }
    return fit;
}

}  // namespace quadcut
