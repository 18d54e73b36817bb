// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/legend.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace quadcut::draw {
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

LegendBlock set_in_columns(std::vector<LegendLine>& lines, const Point& corner, double height,
                           const Typeface& typeface) {
    if (lines.empty()) return {};
    const double line_height = kLineHeight * lines.front().size;
    double area = 0.0;
    for (const LegendLine& line : lines) {
        area += line_height * (width_of(line, typeface) + kColumnGap * line.size);
    }
    const double column_height = std::max({height, std::sqrt(area), line_height});
    const auto per_column = static_cast<std::size_t>(column_height / line_height);
    double left = corner.x;
    double right = corner.x;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::size_t row = i % per_column;
        if (row == 0 && i > 0) left = right + kColumnGap * lines[i].size;
        lines[i].left = {left, corner.y + static_cast<double>(row) * line_height + lines[i].size};
        right = std::max(right, left + width_of(lines[i], typeface));
    }
    return {right - corner.x,
            static_cast<double>(std::min(per_column, lines.size())) * line_height};
}

}  // namespace quadcut::draw
