// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/parallel.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/rooms/options.hpp"

namespace quadcut {

/// Finds the doors anew that lie in a box, from what is there now; one that is less than half a
/// metre from where one was is the same. The rooms of the others are looked up. `clearance_m` is
/// that of the cells around the box; empty: unknown. O(cells within 10 m of the box + doors).
void update_doors(FollowedMap& followed, const Box& box, Raster<float> clearance_m,
                  const RoomsOptions& options, const Executor& executor, Changes& changes);

}  // namespace quadcut
