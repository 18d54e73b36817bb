// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/parallel.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/rooms/options.hpp"
#include "quadcut/segment/result.hpp"
#include "quadcut/zones/options.hpp"

namespace quadcut {

/// The rooms on the cells of map.to_grid(), with doors, and zones if they are asked for. O(map).
[[nodiscard]] Segmentation result_of(const FollowedMap& followed, const RoomsOptions& options,
                                     const Executor& executor, const ZoneOptions& zones = {});

}  // namespace quadcut
