// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "eval/score.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"
#include "sim/building.hpp"

namespace quadcut {

/// Scores rooms against the true rooms of a building. The map may have another origin, extent,
/// direction and resolution: each cell of the building takes what the map has at its centre. Only
/// cells that the map knows as free count towards `cover`. O(cells).
[[nodiscard]] eval::RoomScore score_against_truth(const GridMap& map, const Segmentation& rooms,
                                                  const sim::Building& building);

}  // namespace quadcut
