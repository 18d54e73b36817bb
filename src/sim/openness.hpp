// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>

#include "quadcut/base/random.hpp"
#include "sim/plan.hpp"

namespace quadcut::sim {

/// A hall that a corridor enters at its full width, without a door.
struct Lobby {
    /// Lobby or round hall, beyond the corridor's end.
    Rect rect;
    double radius_m = 0.0;  ///< 0: not round
    double corridor_m = 2.0;

    /// What must be free for it, in the frame of the corridor's end: origin in the middle of the
    /// end line, v outwards.
    [[nodiscard]] Rect space() const;
};

[[nodiscard]] Lobby draw_lobby(double corridor_m, Random& random);
/// Adds it to the plan at the end of a corridor.
void add_lobby(Plan& plan, const Lobby& lobby, const Frame& end, std::size_t corridor);

/// Opens a share of the doors up to four fifths of the wall between the two rooms, 10 m at most: no
/// leaf any more.
void widen_doors(Plan& plan, double share, Random random);

}  // namespace quadcut::sim
