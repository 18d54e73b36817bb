// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>
#include <limits>

#include <quadcut/error.hpp>
#include <quadcut/map.hpp>
#include <quadcut/scan.hpp>

int main() {
    quadcut::OccupancyMap map(0.05);
    quadcut::Scan scan;
    scan.world_from_sensor.x = std::numeric_limits<double>::infinity();
    scan.ranges_m = {1.0F};
    try {
        quadcut::integrate_scan(map, scan);
    } catch (const quadcut::InputError& error) {
        // The map is as it was: what fails changes nothing.
        std::cout << error.what() << '\n';
    }
}
// Prints: map: the point (inf, 0.000000) m lies more than 2^28 cells away
