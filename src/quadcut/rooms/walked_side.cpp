// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/walked_side.hpp"

#include <algorithm>
#include <cmath>

namespace quadcut {

SideOfSaddle side_of(const WalkedSide& walked, Among obstacles, const Direction& along) {
    SideOfSaddle side;
    side.reach_m = walked.reach_m;
    for (std::size_t i = 0; i < walked.within.size(); ++i) {
        const WalkedSide::Within& within = walked.within[i];
        side.peak_m[i] = static_cast<double>(within.peak_m[obstacles == Among::walls ? 0 : 1]);
        // Areas are noted at the last two only; the walk of no region has none.
        if (i == 0 || within.count == 0) continue;
        const auto count = static_cast<double>(within.count);
        const double sum_squares = along.x * along.x * static_cast<double>(within.sum_xx) +
                                   2.0 * along.x * along.y * static_cast<double>(within.sum_xy) +
                                   along.y * along.y * static_cast<double>(within.sum_yy);
        side.area_m2[i - 1] = count * walked.step_m * walked.step_m;
        side.spread_m[i - 1] = std::sqrt(std::max(0.0, sum_squares) / count) * walked.step_m;
    }
    return side;
}

}  // namespace quadcut
