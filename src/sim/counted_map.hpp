// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut::sim {

struct CountedMapOptions {
    /// What fewer beams came to is unknown.
    std::uint32_t least_visits = 1;
    /// Shares of hits, 0..1.
    double free_below = 0.15;
    double occupied_above = 0.3;
};

/// The map that many SLAM programs save: by each cell's share of hits among the beams that came to
/// it, unknown in between. Beams are lines: where they lie apart, they leave gaps. O(cells that
/// beams cross). @pre there is a scan.
[[nodiscard]] GridMap counted_map(std::span<const Scan> scans, double resolution_m,
                                  const CountedMapOptions& options = {});

}  // namespace quadcut::sim
