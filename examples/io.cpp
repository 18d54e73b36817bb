// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/io.hpp>
#include <quadcut/segment.hpp>

int main(int, char** argv) {
    const quadcut::MapInFile file = quadcut::read_map(argv[1]);
    const quadcut::Segmentation result = quadcut::segment(file.map);
    for (const quadcut::Room& room : result.rooms) {
        std::cout << room.name << ": " << room.area_m2 << " m2\n";
    }
    for (const quadcut::Door& door : result.doors) {
        std::cout << "a door of " << door.width_m << " m\n";
    }
    quadcut::write_rooms(argv[2], file.map, result);
}
