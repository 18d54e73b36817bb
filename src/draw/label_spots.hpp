// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut::draw {

/// Places in each of these rooms (values of `ground`) where text may stand, in cells, at most 24
/// each: those that are farther from the room's border than what is around them, the roomiest
/// first. Of a bent or branching room some lie in every stretch. None of a room without a cell.
/// O(cells).
[[nodiscard]] std::vector<std::vector<Point>> find_label_spots(
    const Raster<std::uint16_t>& ground, const std::vector<std::uint16_t>& rooms,
    const Executor& executor = {});

}  // namespace quadcut::draw
