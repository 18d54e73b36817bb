// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/parallel.hpp"
#include "quadcut/follow/window.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {

/// Cuts the window by the same steps as segment() cuts a map, and takes over what comes out within
/// `decided`, which is far enough from the edge that what lies beyond plays no part; outside, rooms
/// stay as they are. A new region that goes on there is the room that is there. Of rooms that
/// people made one, those that touch are one. O(cells of the window).
[[nodiscard]] WindowCut cut_window(const FollowedMap& followed, const Window& window,
                                   const SegmentOptions& options, const Executor& executor);

}  // namespace quadcut
