// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::io::test {

/// A map and its rooms.
struct DrawnFloor {
    GridMap map;
    Segmentation segmentation;
};

/// Rows from the top down: letters are free cells of room 1 ('a'), 2, ...; '.' is free without a
/// room, '#' occupied, ' ' unknown. `scale` cells a character each way. Rooms get their area,
/// centroid and a label point, but no name; there are no doors.
inline DrawnFloor drawn_floor(const std::vector<std::string>& rows, std::int32_t scale = 1,
                              double resolution_m = 0.05) {
    std::size_t columns = 0;
    for (const std::string& row : rows) columns = std::max(columns, row.size());
    const auto width = static_cast<std::int32_t>(columns) * scale;
    const auto height = static_cast<std::int32_t>(rows.size()) * scale;
    DrawnFloor floor;
    floor.map.resolution_m = resolution_m;
    floor.map.states = Raster<CellState>({0, 0}, width, height);
    Raster<std::uint16_t>& labels = floor.segmentation.labels;
    labels = Raster<std::uint16_t>({0, 0}, width, height);
    std::vector<Room>& rooms = floor.segmentation.rooms;
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const Cell cell = labels.cell(i);
        const std::string& row = rows[rows.size() - 1 - static_cast<std::size_t>(cell.y / scale)];
        const auto x = static_cast<std::size_t>(cell.x / scale);
        const char mark = x < row.size() ? row[x] : ' ';
        if (mark == '#') floor.map.states.values[i] = CellState::occupied;
        if (mark == '.') floor.map.states.values[i] = CellState::free;
        if (mark < 'a' || mark > 'z') continue;
        floor.map.states.values[i] = CellState::free;
        labels.values[i] = static_cast<std::uint16_t>(mark - 'a' + 1);
        while (rooms.size() < labels.values[i]) {
            rooms.push_back({RoomId{static_cast<std::uint32_t>(rooms.size() + 1)},
                             "",
                             RoomKind::room,
                             0.0,
                             {},
                             {}});
        }
        Room& room = rooms[labels.values[i] - 1U];
        room.area_m2 += 1.0;  // Cells until all are counted.
        room.centroid.x += cell.x + 0.5;
        room.centroid.y += cell.y + 0.5;
    }
    for (Room& room : rooms) {
        if (room.area_m2 == 0.0) continue;
        room.centroid.x *= resolution_m / room.area_m2;
        room.centroid.y *= resolution_m / room.area_m2;
        room.label_point = room.centroid;
        room.area_m2 *= resolution_m * resolution_m;
    }
    return floor;
}

/// Letters as numbers, 'a' = 1; all else is 0.
inline Raster<std::uint16_t> drawn_values(const std::vector<std::string>& rows) {
    const DrawnFloor floor = drawn_floor(rows);
    const Raster<std::uint16_t>& labels = floor.segmentation.labels;
    Raster<std::uint16_t> values(labels.origin, labels.width, labels.height);
    std::copy(labels.values.begin(), labels.values.end(), values.values.begin());
    return values;
}

}  // namespace quadcut::io::test
