// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/map/raster.hpp"

namespace quadcut {

struct FusedRegions {
    /// 1 .. count, 0 = none.
    Raster<std::uint32_t> labels;
    std::uint32_t count = 0;
};

struct FuseOptions {
    /// Cuts with lower log-odds of being a door are fused.
    double min_log_odds = 0.0;
    /// Wider openings separate nothing, m.
    double max_width_m = 4.0;
    /// Regions smaller than this join a neighbour through their widest saddle, m^2.
    double min_area_m2 = 1.5;
};

/// The log-odds below which cuts are fused, for a granularity of 0 (few rooms) .. 1 (many); 0 for
/// the default of 0.5.
[[nodiscard]] double fuse_threshold(double granularity);

/// Joins pieces (labels 1 .. count) into rooms: the least door-like cut goes first, and what is
/// joined is measured anew, until every cut that is left looks like a door.
[[nodiscard]] FusedRegions fuse(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                                const Raster<float>& clearance_m, double resolution_m,
                                const FuseOptions& options = {});

}  // namespace quadcut
