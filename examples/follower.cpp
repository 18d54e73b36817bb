// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/follower.hpp>

#include "two_rooms.hpp"

int main() {
    // A SLAM system publishes its grid in patches, or scans come from a laser: follower.add_scan().
    quadcut::Follower follower;
    const quadcut::FollowUpdate update = follower.update_cells(two_rooms().states);
    std::cout << update.num_rooms << " rooms";
    for (const quadcut::RoomEvent& event : update.events) {
        std::cout << "; room " << quadcut::index(event.room) << ": " << event.reason;
    }
    std::cout << '\n';
}
// Prints: 2 rooms; room 1: 16 m^2 seen for the first time; room 2: 16 m^2 seen for the first time
