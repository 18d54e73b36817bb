// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/parallel.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/rooms/options.hpp"

namespace quadcut {

/// Finds the doors anew that lie in a box, from what is there now; one that is less than half a
/// metre from where one was is the same. The rooms of the others are looked up. `window` is
/// looked at, around the box; empty: 10 m around it. O(cells of the window + doors).
void update_doors(FollowedMap& followed, const Box& box, const Box& window,
                  const RoomsOptions& options, const Executor& executor, Changes& changes);

}  // namespace quadcut
