// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quadcut/route/sight.hpp"

namespace quadcut {

/// Two cells beside each other, one in each of two rooms, where the robot fits.
using GateCells = std::array<Cell, 2>;

/// A part of the border of two rooms that the robot fits through.
struct Gate {
    /// Labels of the rooms, the smaller one first; the cells of `border` are in this order.
    std::array<std::uint16_t, 2> rooms{};
    /// From one end of the border to the other; never empty.
    std::vector<GateCells> border;
    /// The places in `border` where ways may cross: the middle of a narrow gate; of a wide one both
    /// ends, and others between them.
    std::vector<std::uint32_t> crossings;
};

/// All gates, by rooms, then in the order of their first cells. O(cells).
[[nodiscard]] std::vector<Gate> find_gates(const RobotFloor& floor);

}  // namespace quadcut
