// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "draw/floor_plan.hpp"

namespace quadcut::draw {

/// The plan as an SVG of the same size: a path with the id `room-7` and a tooltip for each room,
/// text as text. Lines are in half cells, so that coordinates are short whole numbers.
[[nodiscard]] std::string render_svg(const FloorPlan& plan);

}  // namespace quadcut::draw
