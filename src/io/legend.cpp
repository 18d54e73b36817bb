// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/legend.hpp"

#include <algorithm>
#include <cstddef>

namespace quadcut::io {
namespace {

// Of the letters' size.
constexpr double kSwatchWidth = 1.3;
constexpr double kSwatchHeight = 0.75;
constexpr double kSwatchGap = 0.5;
constexpr double kLineHeight = 1.5;
constexpr double kColumnGap = 1.5;

}  // namespace

std::array<Point, 4> LegendLine::swatch() const {
    const double right = left.x + kSwatchWidth * size;
    const double top = left.y - kSwatchHeight * size;
    return {{{left.x, left.y}, {right, left.y}, {right, top}, {left.x, top}}};
}

Point LegendLine::text_left() const {
    return {left.x + (kSwatchWidth + kSwatchGap) * size, left.y};
}

double width_of(const LegendLine& line, const Typeface& typeface) {
    return (kSwatchWidth + kSwatchGap) * line.size + typeface.width(line.text, line.size);
}

double set_in_columns(std::vector<LegendLine>& lines, const Point& corner, double height,
                      const Typeface& typeface) {
    if (lines.empty()) return 0.0;
    const double line_height = kLineHeight * lines.front().size;
    const auto per_column = static_cast<std::size_t>(std::max(height / line_height, 1.0));
    double left = corner.x;
    double right = corner.x;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::size_t row = i % per_column;
        if (row == 0 && i > 0) left = right + kColumnGap * lines[i].size;
        lines[i].left = {left, corner.y + static_cast<double>(row) * line_height + lines[i].size};
        right = std::max(right, left + width_of(lines[i], typeface));
    }
    return right - corner.x;
}

}  // namespace quadcut::io
