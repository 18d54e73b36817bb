// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

/// The whole number below and above a value. @pre |value| < 2^31. Without SSE 4.1 std::floor and
/// std::ceil are calls.
[[nodiscard]] inline std::int32_t floor_to_int(double value) {
    const auto toward_zero = static_cast<std::int32_t>(value);
    return toward_zero - (static_cast<double>(toward_zero) > value ? 1 : 0);
}
[[nodiscard]] inline std::int32_t ceil_to_int(double value) {
    const auto toward_zero = static_cast<std::int32_t>(value);
    return toward_zero + (static_cast<double>(toward_zero) < value ? 1 : 0);
}

/// The cell that holds a point; both in cells. @pre |point| < 2^31.
[[nodiscard]] inline Cell cell_of(const Point& point) {
    return {floor_to_int(point.x), floor_to_int(point.y)};
}

/// The point `length` times `direction` away.
[[nodiscard]] inline Point along(const Point& from, const Point& direction, double length) {
    return {from.x + direction.x * length, from.y + direction.y * length};
}

/// Calls `visit(Cell, double t)` for the cells that the straight line crosses, in order, where t in
/// 0 .. 1 says how far along the line it enters the cell. Ends early when `visit` returns false.
/// Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", 1987. O(cells crossed).
template <typename Visitor>
void walk_line(const Point& from, const Point& to, Visitor&& visit) {
    Cell cell = cell_of(from);
    const Cell last = cell_of(to);
    const Point length{to.x - from.x, to.y - from.y};
    const Cell step{length.x < 0.0 ? -1 : 1, length.y < 0.0 ? -1 : 1};
    // How far along the line the next border between columns (rows) is, and how far the one after.
    // Where there is none it is beyond the end.
    const auto first_border = [](double start, double extent, std::int32_t at, std::int32_t way) {
        return extent == 0.0 ? 2.0 : ((way > 0 ? at + 1.0 : at) - start) / extent;
    };
    Point border{first_border(from.x, length.x, cell.x, step.x),
                 first_border(from.y, length.y, cell.y, step.y)};
    const Point every{length.x == 0.0 ? 2.0 : std::abs(1.0 / length.x),
                      length.y == 0.0 ? 2.0 : std::abs(1.0 / length.y)};
    double t = 0.0;
    // Counting the borders makes the end exact whatever the rounding.
    int num_left = std::abs(last.x - cell.x) + std::abs(last.y - cell.y);
    while (visit(cell, t) && num_left > 0) {
        if (cell.y == last.y || (cell.x != last.x && border.x < border.y)) {
            t = border.x;
            border.x += every.x;
            cell.x += step.x;
        } else {
            t = border.y;
            border.y += every.y;
            cell.y += step.y;
        }
        --num_left;
    }
}

}  // namespace quadcut
