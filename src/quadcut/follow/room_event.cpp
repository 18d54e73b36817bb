// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/room_event.hpp"

#include <cmath>
#include <utility>

namespace quadcut {
namespace {

std::string reason_of(RoomChange change, double area_m2) {
    switch (change) {
        case RoomChange::born:
            return square_metres(area_m2) + " seen for the first time";
        case RoomChange::split:
            return square_metres(area_m2) + " behind a door";
        case RoomChange::merged:
            return "nothing like a door is between them";
        case RoomChange::retired:
            return "its floor is no longer free";
        case RoomChange::kept:
        case RoomChange::grown:
            break;
    }
    return {};
}

}  // namespace

RoomEvent event_of(RoomChange change, RoomId room, RoomId other, std::string name, double area_m2) {
    return {change, room, other, std::move(name), reason_of(change, area_m2)};
}

std::string square_metres(double area_m2) {
    return std::to_string(static_cast<long>(std::lround(area_m2))) + " m^2";
}

}  // namespace quadcut
