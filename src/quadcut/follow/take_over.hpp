// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/follow/follow_update.hpp"
#include "quadcut/follow/window.hpp"

namespace quadcut {

/// Gives the regions of a window their ids, and all that follows from it. O(window + rooms).
void take_over(FollowedMap& followed, const Window& window, const WindowCut& cut,
               FollowUpdate& update);

}  // namespace quadcut
