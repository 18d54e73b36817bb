// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

/// Rooms as they are drawn, the first line on top: each letter from a on is a room, all else is no
/// floor; a character is a square of `scale` cells of 0.1 m. Without doors.
struct DrawnRooms {
    GridMap frame;
    Segmentation rooms;

    explicit DrawnRooms(const std::vector<std::string>& lines, std::int32_t scale = 5) {
        const auto height = static_cast<std::int32_t>(lines.size()) * scale;
        const auto width = static_cast<std::int32_t>(lines[0].size()) * scale;
        frame = {0.1, {}, {}};
        rooms.labels = Raster<std::uint16_t>({0, 0}, width, height);
        for_each_cell(rooms.labels.box(), [&](Cell cell) {
            const auto line = static_cast<std::size_t>((height - 1 - cell.y) / scale);
            const char drawn = lines[line][static_cast<std::size_t>(cell.x / scale)];
            if (drawn < 'a' || drawn > 'z') return;
            const auto label = static_cast<std::uint16_t>(drawn - 'a' + 1);
            rooms.labels.at(cell) = label;
            while (rooms.rooms.size() < label) {
                Room room;
                room.id = RoomId{static_cast<std::uint32_t>(rooms.rooms.size() + 1)};
                rooms.rooms.push_back(room);
            }
        });
    }
};

}  // namespace quadcut
