// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/wall_lines.hpp"

namespace quadcut {

/// The space in which widths are measured, 1 = open: the free cells of `kept`, and the furniture
/// that stands in them. Small isolated obstacles (legs of tables and chairs, bins) do not make a
/// room narrower; what is enclosed by one belongs to it. Obstacles that touch nothing else and
/// cover less than `max_furniture_m2`, holes included, are furniture unless they are a piece of a
/// wall: of a line, as `lines` of the same raster has them, or between two gaps.
/// `kept`: 1 = a free cell that is part of the result. O(cells).
[[nodiscard]] Raster<std::uint8_t> open_space(Raster<std::uint8_t> kept, double resolution_m,
                                              double max_furniture_m2, const WallLines& lines,
                                              const Executor& executor = {});

}  // namespace quadcut
