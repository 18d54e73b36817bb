// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/random.hpp"
#include "sim/plan.hpp"

namespace quadcut::sim {

/// Adds the columns that stand out of the walls in some buildings: along corridors, where they
/// narrow them by up to a quarter, and along the outer walls of rooms. None stands before a door.
void add_columns(Plan& plan, Random random);

}  // namespace quadcut::sim
