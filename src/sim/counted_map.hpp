// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut::sim {

/// The map that many SLAM programs save: each cell's share of hits among the beams that came to
/// it; below 0.15 free, above 0.3 occupied, unknown in between. Beams are lines: where they lie
/// apart, they leave gaps. O(cells that beams cross). @pre there is a scan.
[[nodiscard]] GridMap counted_map(std::span<const Scan> scans, double resolution_m);

}  // namespace quadcut::sim
