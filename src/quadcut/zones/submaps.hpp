// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

/// The result with `count` regions at most, as far as that can be had: where there are more rooms,
/// the rooms of each zone become one, and of the doors those between zones stay. The report has a
/// warning when there are more regions, since no doors join the parts of the building, or fewer.
/// Numbered anew, with default names. `rooms` is of the map, by segment(). O(cells).
[[nodiscard]] Segmentation joined_into_submaps(Segmentation rooms, std::size_t count,
                                               const GridMap& map, const Executor& executor = {});

}  // namespace quadcut
