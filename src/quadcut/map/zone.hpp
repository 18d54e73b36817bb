// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

namespace quadcut {

/// What joins two rooms in the graph of which zones are made.
enum class ZoneWeights : std::uint8_t {
    /// The conductance of the doors between them.
    conductance,
    /// Scans that see both; where there are none, as above.
    covisibility,
};

/// Parts of a building: sets of rooms, each room in one, connected through doors as far as there
/// are any.
struct Zones {
    /// 0: none were asked for.
    std::uint32_t count = 0;
    ZoneWeights weights = ZoneWeights::conductance;
    /// By place in Segmentation::rooms: zone 1 .. count, numbered in the order of their first
    /// rooms.
    std::vector<std::uint32_t> zone_of_room;
    /// The smallest eigenvalues of the Laplacian of the graph of rooms, ascending.
    std::vector<double> eigenvalues;
    /// gaps[k - 1]: how far above the k-th eigenvalue the next one lies, 1 as in an even chain of
    /// zones: large where k zones are a good number; 0 below the least number that can be had.
    std::vector<double> gaps;
    friend bool operator==(const Zones&, const Zones&) = default;
};

}  // namespace quadcut
