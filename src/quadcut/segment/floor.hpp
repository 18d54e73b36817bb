// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// What is cut: connected free space, without specks and without the ground outside, laid out so
/// that the result does not depend on how the map lies.
struct Floor {
    Layout layout;
    Raster<std::uint8_t> kept;
    Raster<CellState> states;
};

[[nodiscard]] Floor lay_out_floor(const GridMap& map, std::span<const Point> trajectory,
                                  double min_component_m2, const Executor& executor);

}  // namespace quadcut
