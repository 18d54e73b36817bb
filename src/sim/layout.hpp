// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "sim/plan.hpp"
#include "sim/strip.hpp"

namespace quadcut::sim {

struct LayoutOptions {
    std::uint64_t seed = 1;
    /// Rooms, corridors and halls together; the plan has about as many.
    int num_rooms = 20;
    /// How often a wing is turned by 15 to 40 degrees against the one that it joins, 0..1.
    double turned_wings = 0.5;
    /// 0: as many wings as the rooms need. Others are joined by walkways, with a door at either
    /// end.
    int num_wings = 0;
    /// Direction of the first wing.
    double yaw_rad = 0.0;
    /// 0: doors; 1: corridors end in lobbies and round halls, many rooms have wide openings.
    double openness = 0.0;
};

struct Layout {
    Plan plan;
    /// By place in plan.rooms, from 0; a corridor that goes on into the next wing is of its first.
    std::vector<int> wing_of_room;
    Trade trade = Trade::office;
    int num_wings = 0;
    int num_turned_wings = 0;
};

/// Draws a building: wings of corridors with rooms on their sides, joined end to end.
[[nodiscard]] Layout draw_layout(const LayoutOptions& options);

}  // namespace quadcut::sim
