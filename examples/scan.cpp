// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/map.hpp>
#include <quadcut/scan.hpp>

int main() {
    quadcut::Scan scan;
    scan.world_from_sensor = {1.0, 1.0, 0.0};  // x, y in metres, yaw in radians
    scan.first_angle_rad = -0.5;
    scan.angle_step_rad = 0.01;
    scan.max_range_m = 30.0;
    scan.ranges_m.assign(101, 2.0F);  // 101 beams, each of which hits something after two metres

    quadcut::OccupancyMap map(0.05);
    quadcut::integrate_scan(map, scan);
    const bool is_free = map.state(map.cell_at({2.0, 1.0})) == quadcut::CellState::free;
    const bool is_hit = map.state(map.cell_at({3.01, 1.0})) == quadcut::CellState::occupied;
    std::cout << (is_free ? "free" : "?") << " on the way, " << (is_hit ? "occupied" : "?")
              << " at its end\n";
}
// Prints: free on the way, occupied at its end
