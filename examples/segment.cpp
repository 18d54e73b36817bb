// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/segment.hpp>

#include "two_rooms.hpp"

int main() {
    const quadcut::Segmentation result = quadcut::segment(two_rooms());
    std::cout << result.rooms.size() << " rooms, " << result.doors.size() << " door\n";
}
// Prints: 2 rooms, 1 door
