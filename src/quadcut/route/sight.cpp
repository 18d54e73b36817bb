// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/route/sight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace quadcut {
namespace {

/// More than the parts that are left of a line of 2^31 cells at any time.
constexpr std::size_t kMostHalvings = 64;

}  // namespace

float cells_between(Cell a, Cell b) {
    const auto x = static_cast<float>(a.x - b.x);
    const auto y = static_cast<float>(a.y - b.y);
    return std::sqrt(x * x + y * y);
}

float Sight::clearance_at(Cell cell) {
    ++num_cells_;
    return floor_.clearance_m.contains(cell) ? floor_.clearance_m.at(cell) : 0.0F;
}

bool Sight::can_step(Cell a, Cell b) {
    if (a.x == b.x || a.y == b.y) return true;
    return clearance_at({b.x, a.y}) >= floor_.radius_m &&
           clearance_at({a.x, b.y}) >= floor_.radius_m;
}

bool Sight::sees(Cell a, Cell b) {
    const std::int32_t num_steps = std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), 1});
    const double x = static_cast<double>(b.x - a.x) / num_steps;
    const double y = static_cast<double>(b.y - a.y) / num_steps;
    const double step_m = std::hypot(x, y) * floor_.resolution_m;
    const auto cell_at = [&](std::int32_t i) {
        return Cell{a.x + static_cast<std::int32_t>(std::lround(x * i)),
                    a.y + static_cast<std::int32_t>(std::lround(y * i))};
    };
    // Middle first, then the middles of what is left on both sides: where something is in the way,
    // that is found early.
    struct Part {
        std::int32_t low;
        std::int32_t high;
    };
    std::array<Part, kMostHalvings> left{{{0, num_steps}}};
    for (std::size_t num_left = 1; num_left > 0;) {
        const Part part = left[--num_left];
        if (part.low > part.high) continue;
        const std::int32_t middle = (part.low + part.high) / 2;
        const Cell cell = cell_at(middle);
        const double spare_m = static_cast<double>(clearance_at(cell) - floor_.radius_m);
        if (spare_m < 0.0) return false;
        // From one cell's centre to another's the clearance falls by no more than their distance,
        // which rounding makes a cell longer at most.
        // The cells beside a diagonal step are another one away.
        const double num_safe =
            std::max(0.0, (spare_m - 2.0 * floor_.resolution_m) / std::max(step_m, 1e-9));
        const auto safe = static_cast<std::int32_t>(std::min<double>(num_safe, num_steps));
        if (safe == 0 && middle < num_steps && !can_step(cell, cell_at(middle + 1))) return false;
        left[num_left++] = {part.low, middle - safe - 1};
        left[num_left++] = {middle + safe + 1, part.high};
    }
    return true;
}

}  // namespace quadcut
