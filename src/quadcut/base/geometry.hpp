// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace quadcut {

/// A point in the plane, metres.
struct Point {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const Point&, const Point&) = default;
};

/// A rigid transform of the plane: translation in metres, rotation in radians, counter-clockwise.
struct Pose {
    double x = 0.0;
    double y = 0.0;
    double yaw_rad = 0.0;
    friend bool operator==(const Pose&, const Pose&) = default;
};

/// The address of a square map cell. Cell (x, y) covers [x, x + 1) x [y, y + 1) in units of the
/// map's resolution; x grows to the right, y upwards.
struct Cell {
    std::int32_t x = 0;
    std::int32_t y = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
};

/// The cells low .. high, both corners included; empty when one side has none.
struct Box {
    Cell low{0, 0};
    Cell high{-1, -1};

    [[nodiscard]] bool is_empty() const { return low.x > high.x || low.y > high.y; }
    [[nodiscard]] std::int32_t width() const { return high.x - low.x + 1; }
    [[nodiscard]] std::int32_t height() const { return high.y - low.y + 1; }
    [[nodiscard]] bool contains(Cell cell) const {
        return cell.x >= low.x && cell.x <= high.x && cell.y >= low.y && cell.y <= high.y;
    }
    /// With so many cells more on each side.
    [[nodiscard]] Box grown(std::int32_t by) const {
        return {{low.x - by, low.y - by}, {high.x + by, high.y + by}};
    }
    [[nodiscard]] Box intersected(const Box& other) const {
        const Box common{{std::max(low.x, other.low.x), std::max(low.y, other.low.y)},
                         {std::min(high.x, other.high.x), std::min(high.y, other.high.y)}};
        return common.is_empty() ? Box{} : common;
    }
    /// Grows to the smallest box that holds `other` too, which is not empty.
    void include(const Box& other) {
        if (is_empty()) *this = other;
        low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
        high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    }
    friend bool operator==(const Box&, const Box&) = default;
};

/// Calls visit(cell) for all cells of a box, row by row.
template <typename Visit>
void for_each_cell(const Box& box, const Visit& visit) {
    for (Cell cell = box.low; cell.y <= box.high.y; ++cell.y) {
        for (cell.x = box.low.x; cell.x <= box.high.x; ++cell.x) visit(cell);
    }
}

/// `point_in_b` expressed in frame a.
[[nodiscard]] inline Point transform(const Pose& a_from_b, const Point& point_in_b) {
    const double c = std::cos(a_from_b.yaw_rad);
    const double s = std::sin(a_from_b.yaw_rad);
    return {a_from_b.x + c * point_in_b.x - s * point_in_b.y,
            a_from_b.y + s * point_in_b.x + c * point_in_b.y};
}

/// a_from_c = a_from_b * b_from_c.
[[nodiscard]] inline Pose compose(const Pose& a_from_b, const Pose& b_from_c) {
    const Point origin = transform(a_from_b, {b_from_c.x, b_from_c.y});
    return {origin.x, origin.y, a_from_b.yaw_rad + b_from_c.yaw_rad};
}

/// b_from_a.
[[nodiscard]] inline Pose inverse(const Pose& a_from_b) {
    const double c = std::cos(a_from_b.yaw_rad);
    const double s = std::sin(a_from_b.yaw_rad);
    return {-c * a_from_b.x - s * a_from_b.y, s * a_from_b.x - c * a_from_b.y, -a_from_b.yaw_rad};
}

[[nodiscard]] inline double distance(const Point& a, const Point& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace quadcut
