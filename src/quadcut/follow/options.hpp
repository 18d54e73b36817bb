// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/map/integrate_options.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/zones/options.hpp"

namespace quadcut {

struct OptionField;

struct FollowOptions {
    SegmentOptions segment;
    ZoneOptions zones;
    /// Preset `paper` takes latest_scan_wins() of it.
    IntegrateOptions integrate;
    double resolution_m = 0.05;
    /// Rooms are cut again when so much free space has changed.
    double min_change_m2 = 2.0;
    /// Less is cut when it has waited long: the product of what has changed and the scans since the
    /// last cut.
    double max_wait_m2_scans = 100.0;
    /// The first cut waits for so much of it (the paper's Fig 9).
    double first_cut_m2 = 10.0;
    /// What has changed by less stays as it is, unless finish() is called.
    double min_patch_m2 = 0.05;
};

/// Adds those of segment(), of scans, and these, bound to the members of `options`, which must
/// outlive the list.
void add_fields(FollowOptions& options, std::vector<OptionField>& fields);

/// The options as a Follower takes them.
[[nodiscard]] FollowOptions with_preset(FollowOptions options);

}  // namespace quadcut
