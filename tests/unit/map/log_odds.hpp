// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

#include "quadcut/map/occupancy_map.hpp"

namespace quadcut::test {

/// Adds to a cell's log-odds, within bounds.
inline void add_log_odds(OccupancyMap& map, Cell cell, int delta) {
    Tile tile = map.tile(tile_of(cell));
    std::int8_t& value = tile.values[place_in_tile(cell)];
    value = bounded_sum(value, delta);
    map.set_tile(tile_of(cell), tile);
}

}  // namespace quadcut::test
