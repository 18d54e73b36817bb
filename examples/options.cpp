// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/options.hpp>
#include <quadcut/segment.hpp>

#include "two_rooms.hpp"

int main() {
    quadcut::SegmentOptions options;
    options.rooms.granularity = 0.0;   // few large rooms
    options.rooms.door_width_m = 0.5;  // what is wider than this is no door
    const quadcut::Segmentation result = quadcut::segment(two_rooms(), options);
    std::cout << result.rooms.size() << " room\n";
    for (const quadcut::OptionField& field : quadcut::option_fields(options)) {
        if (field.unit == "m") std::cout << field.name << ": " << field.text << '\n';
    }
}
// Prints: 1 room
