// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/map/raster.hpp"

namespace quadcut::io {

enum class Closeness : std::uint8_t { touching, across_wall };

/// Two rooms (labels, a < b) that lie next to each other.
struct RoomPair {
    std::uint16_t a = 0;
    std::uint16_t b = 0;
    Closeness closeness = Closeness::touching;
    friend bool operator==(const RoomPair&, const RoomPair&) = default;
};

/// The rooms that share a cell edge, and those with at most `max_gap_cells` unlabelled cells
/// between them along a row or a column. Ascending, each pair once, as touching if it does
/// anywhere. O(cells + outline cells * max_gap_cells).
[[nodiscard]] std::vector<RoomPair> find_room_pairs(const Raster<std::uint16_t>& labels,
                                                    std::int32_t max_gap_cells);

}  // namespace quadcut::io
