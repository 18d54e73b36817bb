// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace quadcut {

struct OptionField;

/// What joins two rooms in the graph of which zones are made.
enum class ZoneWeights : std::uint8_t {
    /// The conductance of the doors between them.
    conductance,
    /// Scans that see both; where there are none, as above.
    covisibility,
};

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
