// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/map.hpp>

int main() {
    // A map that grows: cells of 5 cm, at any address.
    quadcut::OccupancyMap map(0.05);
    for (std::int32_t x = -3; x < 7; ++x) map.set_state({x, 4}, quadcut::CellState::free);
    map.set_state(map.cell_at({0.36, 0.21}), quadcut::CellState::occupied);  // metres
    map.commit();

    // A finished map: what segment() cuts.
    const quadcut::GridMap grid = map.to_grid();
    std::cout << grid.states.width << " x " << grid.states.height
              << " cells, lower left at x = " << grid.map_from_image.x << " m\n";
}
// Prints: 11 x 1 cells, lower left at x = -0.15 m
