// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadcut/route/gates.hpp"
#include "quadcut/route/sight.hpp"

namespace quadcut {

/// A point of a way that is being made: a corner, an end, a hub, or a crossing of a gate.
struct Bend {
    static constexpr std::uint32_t kNone = ~0U;

    Cell cell;
    std::uint32_t gate = kNone;
    /// The node of the hub that it is, in the graph of its room.
    std::uint32_t hub = kNone;
};

/// The way pulled straight: it crosses each gate where that is shortest, and what it need not touch
/// is left out; then its bends keep 0.15 m more off the walls where there is space. @pre from each
/// bend the robot can go straight to the next
[[nodiscard]] std::vector<Bend> pull_straight(std::vector<Bend> way, std::span<const Gate> gates,
                                              Sight& sight, double radius_m);

}  // namespace quadcut
