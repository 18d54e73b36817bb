// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/segment/options.hpp"

namespace quadcut {

/// The watershed of the clearance alone: every obstacle counts, and regions are fused when the
/// narrowest place between them has three quarters of the smaller width, or is 3 m wide. What the
/// door model and the treatment of furniture are measured against. Regions smaller than a room join
/// a neighbour before the ratio is asked, as they do by default.
inline SegmentOptions watershed_baseline() {
    SegmentOptions options;
    options.rooms.pieces = PieceSource::basins;
    options.rooms.fuse = FuseRule::ratio;
    options.rooms.min_ratio = 0.75;
    options.rooms.door_width_m = 3.0;
    options.rooms.max_furniture_m2 = 0.0;
    return options;
}

}  // namespace quadcut
