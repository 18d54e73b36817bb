// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "quadcut/map/occupancy_map.hpp"

namespace quadcut {

/// The occupied cells of a map.
[[nodiscard]] std::vector<Cell> obstacles_of(const OccupancyMap& map);

/// Builds nanoflann's KD-tree of obstacle points: the map that the paper compares its quadtree with
/// (Fig 13), which is not changed but built anew for each scan. Returns how many points it holds.
std::size_t build_kd_tree(std::span<const Cell> points);

}  // namespace quadcut
