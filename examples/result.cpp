// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/result.hpp>
#include <quadcut/segment.hpp>

#include "two_rooms.hpp"

int main() {
    const quadcut::Segmentation result = quadcut::segment(two_rooms());
    for (const quadcut::Room& room : result.rooms) {
        std::cout << room.name << ": " << room.area_m2 << " m2; ";
    }
    for (const quadcut::Door& door : result.doors) {
        std::cout << "a door of " << door.width_m << " m; ";
    }
    // Which room is the cell (20, 40) in? 0 is none, else the room's place among the rooms, from 1.
    const std::uint16_t label = result.labels.at({20, 40});
    std::cout << "(20, 40) is in " << result.rooms[label - 1U].name << '\n';
}
// Prints: room 1: 16 m2; room 2: 16.045 m2; a door of 0.95 m; (20, 40) is in room 1
