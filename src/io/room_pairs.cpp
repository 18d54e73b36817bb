// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_pairs.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace quadcut::io {
namespace {

auto key(const RoomPair& pair) { return std::tuple(pair.a, pair.b, pair.closeness); }

}  // namespace

std::vector<RoomPair> find_room_pairs(const Raster<std::uint16_t>& labels,
                                      std::int32_t max_gap_cells) {
    std::vector<RoomPair> pairs;
    // From a cell on the border of its room straight on to the next room.
    const auto look = [&](std::size_t from, std::size_t step, std::int32_t num_cells_ahead) {
        const std::uint16_t label = labels.values[from];
        const std::int32_t reach = std::min(num_cells_ahead, max_gap_cells + 1);
        std::size_t place = from;
        for (std::int32_t distance = 1; distance <= reach; ++distance) {
            place += step;
            const std::uint16_t met = labels.values[place];
            if (met == 0) continue;
            if (met == label) return;
            const RoomPair pair{std::min(label, met), std::max(label, met),
                                distance == 1 ? Closeness::touching : Closeness::across_wall};
            // Borders are long: the same pair mostly follows itself.
            if (pairs.empty() || pairs.back() != pair) pairs.push_back(pair);
            return;
        }
    };
    const auto width = static_cast<std::size_t>(labels.width);
    std::size_t place = 0;
    for (std::int32_t y = 0; y < labels.height; ++y) {
        for (std::int32_t x = 0; x < labels.width; ++x, ++place) {
            if (labels.values[place] == 0) continue;
            look(place, 1, labels.width - 1 - x);
            look(place, width, labels.height - 1 - y);
        }
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const RoomPair& a, const RoomPair& b) { return key(a) < key(b); });
    const auto same_rooms = [](const RoomPair& x, const RoomPair& y) {
        return x.a == y.a && x.b == y.b;
    };
    pairs.erase(std::unique(pairs.begin(), pairs.end(), same_rooms), pairs.end());
    return pairs;
}

}  // namespace quadcut::io
