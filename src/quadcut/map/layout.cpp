// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/layout.hpp"

namespace quadcut {
namespace {

/// About the mean.
double spread(const AxisMoments& m) { return m.s2 / m.n - m.s1 * m.s1 / (m.n * m.n); }
double skew(const AxisMoments& m) {
    const double mean = m.s1 / m.n;
    return m.s3 / m.n - 3.0 * mean * m.s2 / m.n + 2.0 * mean * mean * mean;
}

void add(AxisMoments& moments, double at) {
    moments.n += 1.0;
    moments.s1 += at;
    moments.s2 += at * at;
    moments.s3 += at * at * at;
}

}  // namespace

Layout standard_orientation(const AxisMoments& x, const AxisMoments& y) {
    Layout layout;
    layout.is_transposed = spread(y) > spread(x);
    const bool x_back = skew(x) < 0.0;
    const bool y_back = skew(y) < 0.0;
    layout.is_x_reversed = layout.is_transposed ? y_back : x_back;
    layout.is_y_reversed = layout.is_transposed ? x_back : y_back;
    return layout;
}

Layout standard_layout(const Raster<std::uint8_t>& mask) {
    Box box;
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        if (mask.values[i] != 0) box.include({mask.cell(i), mask.cell(i)});
    }
    if (box.is_empty()) return {};
    // About the middle of the box, where the sums are exact.
    AxisMoments x;
    AxisMoments y;
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        if (mask.values[i] == 0) continue;
        const Cell cell = mask.cell(i);
        add(x, cell.x - 0.5 * (box.low.x + box.high.x));
        add(y, cell.y - 0.5 * (box.low.y + box.high.y));
    }
    Layout layout = standard_orientation(x, y);
    layout.box = {{box.low.x - 1, box.low.y - 1}, {box.high.x + 1, box.high.y + 1}};
    return layout;
}

}  // namespace quadcut
