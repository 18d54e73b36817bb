// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

namespace quadcut {

/// Parts of a building: sets of rooms, each room in one. Zones are connected through doors, but for
/// rooms that no doors join to others: those are zones of their own.
struct Zones {
    /// 0: none were asked for.
    std::uint32_t count = 0;
    /// By place in Segmentation::rooms: zone 1 .. count, numbered in the order of their first
    /// rooms.
    std::vector<std::uint32_t> zone_of_room;
    /// Smallest eigenvalues of the Laplacian of the graph of rooms, ascending; of a result that was
    /// read from files, too.
    std::vector<double> eigenvalues;
    /// gaps[k - 1]: how far above the k-th eigenvalue the next one is, as a share of that: 0..1,
    /// large where k zones are a good number.
    std::vector<double> gaps;
    friend bool operator==(const Zones&, const Zones&) = default;
};

}  // namespace quadcut
