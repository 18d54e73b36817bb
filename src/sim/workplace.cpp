// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/workplace.hpp"

#include <string>

#include "sim/plan.hpp"

namespace quadcut::sim {

Building paper_workplace(double resolution_m) {
    constexpr double kWall = 0.2;
    const Frame frame;
    Plan plan;
    const std::size_t middle =
        plan.add_room(RoomUse::meeting, frame, {5.6, 0.0, 10.4, 10.0}, kWall);
    const auto add = [&](const Rect& rect, double door_low, double door_high) {
        const std::size_t room = plan.add_room(RoomUse::meeting, frame, rect, kWall);
        const bool at_left = rect.x0 < 5.0;
        const double wall = at_left ? rect.x1 : rect.x0 - kWall;
        plan.doors.push_back({at_left ? room : middle,
                              at_left ? middle : room,
                              frame.swapped(),
                              {door_low, wall, door_high, wall + kWall},
                              false});
    };
    add({0.0, 0.0, 5.4, 4.9}, 1.6, 2.6);
    add({0.0, 5.1, 5.4, 10.0}, 7.6, 8.6);
    add({10.6, 0.0, 16.0, 4.9}, 2.4, 3.4);
    add({10.6, 5.1, 16.0, 10.0}, 6.2, 7.2);

    BuildingOptions options;
    options.resolution_m = resolution_m;
    options.furniture = 0.0;
    options.open_leaves = 0.0;
    Building building = draw_building(plan, options);
    for (std::size_t i = 0; i < building.rooms.size(); ++i) {
        building.rooms[i].name = "Room " + std::to_string(i + 1);
    }
    return building;
}

}  // namespace quadcut::sim
