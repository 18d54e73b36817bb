// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "apps/arguments.hpp"
#include "apps/progress.hpp"
#include "quadcut/base/option_field.hpp"
#include "sim/building.hpp"
#include "sim/robot.hpp"

namespace quadcut {

/// What `simulate` and `demo` let a user choose.
struct SimulationChoice {
    std::size_t seed = 1;
    std::size_t num_rooms = 20;
    double furniture = 0.5;
    double clutter = 0.0;
};

/// The choice's fields, bound to it.
[[nodiscard]] std::vector<OptionField> simulation_fields(SimulationChoice& choice);

struct Simulation {
    sim::BuildingOptions options;
    sim::Building building;
    sim::Exploration exploration;
};

/// Draws a building and sends a robot through it.
[[nodiscard]] Simulation simulate(const SimulationChoice& choice, Progress& progress);

}  // namespace quadcut
