// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>

#include "quadcut/rooms/door_cues.hpp"
#include "quadcut/rooms/region_graph.hpp"

namespace quadcut {

/// What the door model looks at, as kDoorCues lists it.
[[nodiscard]] std::array<float, kNumDoorCues> door_cues(const BorderMeasure& border);

/// How clearly a narrowing is a door: the logarithm of the odds (fuse_threshold() says from where
/// on a cut is kept). A sum of small decision trees, learnt from cuts that people made or left out
/// (docs/decisions/0008-door-model.md); more wall beside an opening, or more room behind it, never
/// makes a door less likely.
[[nodiscard]] double door_log_odds(const BorderMeasure& border);

/// What each cue adds to the log-odds: in each tree, each question moves them from the mean of the
/// leaves that are left before it to the mean of those that are left after it (Saabas, 2014). All
/// of them, and the mean of each tree, are the log-odds together.
[[nodiscard]] std::array<double, kNumDoorCues> door_contributions(const BorderMeasure& border);

}  // namespace quadcut
