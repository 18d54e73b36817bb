// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstdint>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/paper/line_of_sight.hpp"

/// Line of sight by its definition: slow, exact, and without anything of the production test.
namespace quadcut::test {

/// Exact for the small numbers of the tests. The denominator is positive.
struct Fraction {
    std::int64_t over = 0;
    std::int64_t under = 1;
    Fraction(std::int64_t a, std::int64_t b) : over(b < 0 ? -a : a), under(b < 0 ? -b : b) {}
};

/// A point, open edge or open square of the lattice: per axis either low < z < high or z = low =
/// high.
struct Box {
    std::array<std::int64_t, 2> low;
    std::array<std::int64_t, 2> high;
};

/// Whether the closed segment holds a point of the box. The parameters t at which the segment meets
/// a bounding line cut 0 .. 1 into pieces that are inside or outside as a whole, so it is enough to
/// look at these t, and once between each two of them.
inline bool meets(HalfCell a, HalfCell b, const Box& box) {
    const std::array<std::int64_t, 2> start{a.x, a.y};
    const std::array<std::int64_t, 2> way{b.x - a.x, b.y - a.y};
    std::array<Fraction, 6> turns{Fraction(0, 1), Fraction(1, 1), Fraction(0, 1),
                                  Fraction(0, 1), Fraction(0, 1), Fraction(0, 1)};
    std::size_t count = 2;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0) continue;
        turns[count++] = Fraction(box.low[axis] - start[axis], way[axis]);
        turns[count++] = Fraction(box.high[axis] - start[axis], way[axis]);
    }
    const auto holds = [&](const Fraction& t) {
        if (t.over < 0 || t.over > t.under) return false;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::int64_t z = start[axis] * t.under + t.over * way[axis];
            const std::int64_t low = box.low[axis] * t.under;
            const std::int64_t high = box.high[axis] * t.under;
            if (low == high ? z != low : (z <= low || z >= high)) return false;
        }
        return true;
    };
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const Fraction& s = turns[i];
            const Fraction& t = turns[j];
            if (holds({s.over * t.under + t.over * s.under, 2 * s.under * t.under})) return true;
        }
    }
    return false;
}

/// The rule of BlockedCells, cell by cell, edge by edge, corner by corner. Cells outside the map
/// block.
inline bool slow_line_of_sight(const Raster<CellState>& states, HalfCell a, HalfCell b) {
    const auto blocked = [&](std::int32_t x, std::int32_t y) {
        return !states.contains({x, y}) || states.at({x, y}) != CellState::free;
    };
    for (std::int32_t y = states.origin.y - 1; y <= states.origin.y + states.height; ++y) {
        for (std::int32_t x = states.origin.x - 1; x <= states.origin.x + states.width; ++x) {
            const std::int64_t left = 2 * std::int64_t{x};
            const std::int64_t low = 2 * std::int64_t{y};
            if (blocked(x, y) && meets(a, b, {{left, low}, {left + 2, low + 2}})) return false;
            const bool left_edge = blocked(x - 1, y) && blocked(x, y);
            if (left_edge && meets(a, b, {{left, low}, {left, low + 2}})) return false;
            const bool low_edge = blocked(x, y - 1) && blocked(x, y);
            if (low_edge && meets(a, b, {{left, low}, {left + 2, low}})) return false;
            const bool pinch = (blocked(x - 1, y - 1) && blocked(x, y)) ||
                               (blocked(x - 1, y) && blocked(x, y - 1));
            if (pinch && meets(a, b, {{left, low}, {left, low}})) return false;
        }
    }
    return true;
}

}  // namespace quadcut::test
