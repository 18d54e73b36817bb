// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>

#include "quadcut/rooms/region_graph.hpp"

namespace quadcut {

inline constexpr std::size_t kNumDoorCues = 111;

/// What the door model looks at, 39 cues. Ratios of lengths and of areas
/// to the opening are logarithms.
[[nodiscard]] std::array<float, kNumDoorCues> door_cues(const BorderMeasure& border);

/// How clearly a narrowing is a door: the logarithm of the odds (fuse_threshold() says from where
/// on a cut is kept). A sum of small decision trees, learnt from cuts that people made or left out
/// (docs/decisions/0008-door-model.md); more wall beside an opening, or more room behind it, never
/// makes a door less likely.
[[nodiscard]] double door_log_odds(const BorderMeasure& border);

}  // namespace quadcut
