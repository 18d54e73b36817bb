// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/options.hpp"

namespace quadcut {

FollowOptions with_preset(FollowOptions options) {
    if (options.segment.preset == Preset::paper) options.integrate = latest_scan_wins();
    return options;
}

}  // namespace quadcut
