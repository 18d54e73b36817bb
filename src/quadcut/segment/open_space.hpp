// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {

/// The space in which widths are measured, 1 = open: the free cells of `kept`, and the furniture
/// that stands in them. Small isolated obstacles (legs of tables and chairs, bins) do not make a
/// room narrower; what is enclosed by one belongs to it. Obstacles that touch nothing else and
/// cover less than `max_furniture_m2`, holes included, are furniture if the rule agrees.
/// `kept`: 1 = a free cell that is part of the result. O(cells).
[[nodiscard]] Raster<std::uint8_t> open_space(Raster<std::uint8_t> kept, double resolution_m,
                                              double max_furniture_m2,
                                              FurnitureRule rule = FurnitureRule::off_wall,
                                              const Executor& executor = {});

}  // namespace quadcut
