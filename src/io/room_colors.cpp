// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_colors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace quadcut::io {

std::vector<RoomPair> find_near_rooms(const GridMap& map, const Segmentation& segmentation) {
    constexpr double kWallMetres = 0.8;
    constexpr double kMostCells = 200.0;
    const double cells = std::min(std::ceil(kWallMetres / map.resolution_m), kMostCells);
    return find_room_pairs(segmentation.labels, static_cast<std::int32_t>(cells));
}

std::vector<Rgb> room_colors(const Segmentation& segmentation,
                             const std::vector<RoomPair>& near_rooms,
                             const std::map<RoomId, Rgb>& previous) {
    std::vector<RoomKind> kinds;
    std::vector<std::optional<Rgb>> kept;
    for (const Room& room : segmentation.rooms) {
        kinds.push_back(room.kind);
        const auto found = previous.find(room.id);
        kept.push_back(found == previous.end() ? std::nullopt : std::optional(found->second));
    }
    return choose_room_colors(kinds, near_rooms, kept);
}

}  // namespace quadcut::io
