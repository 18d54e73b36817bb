// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "quadcut/map/zone.hpp"

namespace quadcut {

struct OptionField;

/// ZoneOptions::count: no zones are asked for.
inline constexpr std::size_t kNoZones = std::numeric_limits<std::size_t>::max();

struct ZoneOptions {
    /// 0: as many as the largest eigengap tells.
    std::size_t count = kNoZones;
    ZoneWeights weights = ZoneWeights::conductance;
};

/// Adds the options of this stage, bound to the members of `options`, which must outlive the list.
void add_fields(ZoneOptions& options, std::vector<OptionField>& fields);

}  // namespace quadcut
