// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>

#include "quadcut/base/random.hpp"
#include "sim/plan.hpp"
#include "sim/skeleton.hpp"

namespace quadcut::sim {

/// What kind of house a building is: which rooms it has.
enum class Trade : std::uint8_t { office, home, clinic, school };

/// Divides a row along a corridor into rooms with doors and adds them to the plan. `strip.frame`
/// is given in the plan's frame, `corridor` is the corridor's room in the plan.
void fill_strip(Plan& plan, const Strip& strip, std::size_t corridor, const WingStyle& style,
                Trade trade, Random& random);

}  // namespace quadcut::sim
