// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include <quadcut/map.hpp>

/// Two rooms of 4 m x 4 m and a doorway of 0.9 m in the wall between them; cells of 5 cm.
inline quadcut::GridMap two_rooms() {
    constexpr std::int32_t kWidth = 163;
    constexpr std::int32_t kHeight = 82;
    quadcut::GridMap map;
    map.resolution_m = 0.05;
    map.states = {{0, 0}, kWidth, kHeight, quadcut::CellState::occupied};
    for (std::int32_t y = 1; y + 1 < kHeight; ++y) {
        for (std::int32_t x = 1; x + 1 < kWidth; ++x) {
            const bool is_wall = x == kWidth / 2 && (y < 32 || y >= 50);
            if (!is_wall) map.states.at({x, y}) = quadcut::CellState::free;
        }
    }
    return map;
}
