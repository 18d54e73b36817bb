// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "quadcut/map/grid_map.hpp"

namespace quadcut::test {

/// Rows from the top down, as one sees them: '#' occupied, '.' free, ' ' unknown. Short rows are
/// filled up with unknown. `scale` cells a character each way.
inline GridMap drawn_map(const std::vector<std::string>& rows, double resolution_m = 0.05,
                         std::int32_t scale = 1) {
    std::size_t width = 0;
    for (const std::string& row : rows) width = std::max(width, row.size());
    GridMap map;
    map.resolution_m = resolution_m;
    map.states = Raster<CellState>({0, 0}, static_cast<std::int32_t>(width) * scale,
                                   static_cast<std::int32_t>(rows.size()) * scale);
    for (std::size_t i = 0; i < map.states.values.size(); ++i) {
        const Cell cell = map.states.cell(i);
        const std::string& row = rows[rows.size() - 1 - static_cast<std::size_t>(cell.y / scale)];
        const auto x = static_cast<std::size_t>(cell.x / scale);
        const char state = x < row.size() ? row[x] : ' ';
        map.states.values[i] = state == '#'   ? CellState::occupied
                               : state == '.' ? CellState::free
                                              : CellState::unknown;
    }
    return map;
}

/// 1 where the drawing has `mark`.
inline Raster<std::uint8_t> drawn_mask(const std::vector<std::string>& rows, char mark = '.',
                                       std::int32_t scale = 1) {
    std::vector<std::string> marked = rows;
    for (std::string& row : marked) {
        for (char& c : row) c = c == mark ? '.' : '#';
    }
    const GridMap map = drawn_map(marked, 0.05, scale);
    Raster<std::uint8_t> mask(map.states.origin, map.states.width, map.states.height);
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        mask.values[i] = map.states.values[i] == CellState::free ? 1 : 0;
    }
    return mask;
}

/// Letters are labels: 'a' = 1, 'b' = 2, ...; anything else is 0.
inline Raster<std::uint32_t> drawn_labels(const std::vector<std::string>& rows) {
    Raster<std::uint32_t> labels({0, 0}, static_cast<std::int32_t>(rows.front().size()),
                                 static_cast<std::int32_t>(rows.size()));
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const Cell cell = labels.cell(i);
        const char c = rows[rows.size() - 1 - static_cast<std::size_t>(cell.y)]
                           [static_cast<std::size_t>(cell.x)];
        labels.values[i] = c >= 'a' && c <= 'z' ? static_cast<std::uint32_t>(c - 'a') + 1 : 0;
    }
    return labels;
}

/// The drawing that drawn_labels() reads; '.' for 0.
inline std::vector<std::string> as_drawing(const Raster<std::uint32_t>& labels) {
    std::vector<std::string> rows(static_cast<std::size_t>(labels.height),
                                  std::string(static_cast<std::size_t>(labels.width), '.'));
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        if (labels.values[i] == 0) continue;
        const Cell cell = labels.cell(i);
        rows[rows.size() - 1 - static_cast<std::size_t>(cell.y)][static_cast<std::size_t>(cell.x)] =
            static_cast<char>('a' + labels.values[i] - 1);
    }
    return rows;
}

/// Two rooms of 4 x 4 m side by side, joined by a door 0.9 m wide in a wall 0.2 m thick.
inline GridMap two_rooms() {
    GridMap map;
    map.states = Raster<CellState>({0, 0}, 168, 88, CellState::occupied);
    const auto clear = [&](std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) {
        for (std::int32_t y = y0; y < y1; ++y) {
            for (std::int32_t x = x0; x < x1; ++x) map.states.at({x, y}) = CellState::free;
        }
    };
    clear(2, 4, 82, 84);
    clear(86, 4, 166, 84);
    clear(82, 30, 86, 48);
    return map;
}

}  // namespace quadcut::test
