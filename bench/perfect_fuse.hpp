// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "quadcut/map/raster.hpp"

namespace quadcut {

/// What no fusing of these pieces can better by much: each piece, of any number but 0, becomes the
/// true room that most of it is in, the smaller number of two alike; 0 where that is no room. Its
/// score is the ceiling of whatever decides which pieces to join. O(cells log pieces).
/// @pre the same size; cells correspond by their place in it, whatever the origins.
inline Raster<std::uint32_t> fused_by_truth(const Raster<std::uint32_t>& pieces,
                                            const Raster<std::uint32_t>& truth) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> shared;
    for (std::size_t i = 0; i < pieces.values.size(); ++i) {
        if (pieces.values[i] != 0) ++shared[{pieces.values[i], truth.values[i]}];
    }
    std::map<std::uint32_t, std::pair<std::size_t, std::uint32_t>> most;
    for (const auto& [pair, count] : shared) {
        auto& [largest, room] = most[pair.first];
        if (count > largest) {
            largest = count;
            room = pair.second;
        }
    }
    Raster<std::uint32_t> rooms = pieces;
    for (std::uint32_t& label : rooms.values) {
        if (label != 0) label = most[label].second;
    }
    return rooms;
}

/// The rooms with all borders of the truth cut, too, and none taken away: what is left to gain
/// where cuts are missing. 0 where the truth has no room. O(cells log rooms).
/// @pre as fused_by_truth.
inline Raster<std::uint32_t> cut_by_truth(const Raster<std::uint32_t>& rooms,
                                          const Raster<std::uint32_t>& truth) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
    Raster<std::uint32_t> parts(rooms.box());
    for (std::size_t i = 0; i < rooms.values.size(); ++i) {
        if (rooms.values[i] == 0 || truth.values[i] == 0) continue;
        const auto next = static_cast<std::uint32_t>(numbers.size() + 1);
        parts.values[i] =
            numbers.try_emplace({rooms.values[i], truth.values[i]}, next).first->second;
    }
    return parts;
}

}  // namespace quadcut
