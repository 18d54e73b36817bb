// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/layout.hpp"

namespace quadcut {
namespace {

/// Sums over the cells of a mask about the middle of its box, where they are exact.
struct Moments {
    double count = 0.0;
    double x = 0.0, y = 0.0;
    double xx = 0.0, yy = 0.0;
    double xxx = 0.0, yyy = 0.0;

    void add(double dx, double dy) {
        count += 1.0;
        x += dx;
        y += dy;
        xx += dx * dx;
        yy += dy * dy;
        xxx += dx * dx * dx;
        yyy += dy * dy * dy;
    }
};

/// About the mean, of one axis.
double spread(double n, double s1, double s2) { return s2 / n - s1 * s1 / (n * n); }
double skew(double n, double s1, double s2, double s3) {
    const double mean = s1 / n;
    return s3 / n - 3.0 * mean * s2 / n + 2.0 * mean * mean * mean;
}

}  // namespace

Layout standard_layout(const Raster<std::uint8_t>& mask) {
    Box box;
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        if (mask.values[i] != 0) box.include({mask.cell(i), mask.cell(i)});
    }
    if (box.is_empty()) return {};
    Moments sum;
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        if (mask.values[i] == 0) continue;
        const Cell cell = mask.cell(i);
        sum.add(cell.x - 0.5 * (box.low.x + box.high.x), cell.y - 0.5 * (box.low.y + box.high.y));
    }
    Layout layout;
    layout.box = {{box.low.x - 1, box.low.y - 1}, {box.high.x + 1, box.high.y + 1}};
    layout.is_transposed = spread(sum.count, sum.y, sum.yy) > spread(sum.count, sum.x, sum.xx);
    const bool x_back = skew(sum.count, sum.x, sum.xx, sum.xxx) < 0.0;
    const bool y_back = skew(sum.count, sum.y, sum.yy, sum.yyy) < 0.0;
    layout.is_x_reversed = layout.is_transposed ? y_back : x_back;
    layout.is_y_reversed = layout.is_transposed ? x_back : y_back;
    return layout;
}

}  // namespace quadcut
