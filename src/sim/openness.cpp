// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/openness.hpp"

#include <algorithm>
#include <cmath>

namespace quadcut::sim {
namespace {

constexpr double kWall = 0.12;
constexpr double kLeastHallM2 = 60.0;
constexpr double kLongestWall = 30.0;

bool is_floor(const PlanRoom& room, const Point& p) {
    return std::any_of(room.parts.begin(), room.parts.end(), [&](const FloorPart& part) {
        return part.rect.contains(part.frame.local(p));
    });
}

// Whether both rooms reach the wall at a place along it.
bool divides(const Plan& plan, const PlanDoor& door, double x) {
    constexpr double kNear = 0.05;
    return is_floor(plan.rooms[door.a], door.frame.map({x, door.opening.y0 - kNear})) &&
           is_floor(plan.rooms[door.b], door.frame.map({x, door.opening.y1 + kNear}));
}

// The opening of a door, as wide as wished, as far as the wall between the two rooms goes on.
Rect widened(const Plan& plan, const PlanDoor& door, double width) {
    constexpr double kStep = 0.1;
    constexpr double kJamb = 0.12;
    Rect opening = door.opening;
    bool grows = true;
    while (grows && opening.width() < width) {
        grows = false;
        if (divides(plan, door, opening.x0 - kStep - kJamb)) {
            opening.x0 -= kStep;
            grows = true;
        }
        if (divides(plan, door, opening.x1 + kStep + kJamb)) {
            opening.x1 += kStep;
            grows = true;
        }
    }
    return opening;
}

}  // namespace

Rect Lobby::space() const {
    constexpr double kMargin = 0.25;
    Rect space = grow(rect, kMargin);
    if (radius_m > 0.0) {
        const Point middle = rect.center();
        const double reach = radius_m + kMargin;
        space = {middle.x - reach, 0.0, middle.x + reach, middle.y + reach};
    }
    space.y0 = 0.3;
    return space;
}

Lobby draw_lobby(double corridor_m, Random& random) {
    const double half = 0.5 * corridor_m;
    Lobby lobby;
    lobby.corridor_m = corridor_m;
    const double depth = random.uniform(4.0, 10.0);
    const double left = half + random.uniform(0.0, 5.0);
    const double right = half + random.uniform(1.0, 5.0);
    const double radius = std::max(corridor_m, random.uniform(2.5, 5.5));
    lobby.rect = {-left, kWall, right, depth};
    if (random.uniform() >= 0.3) return lobby;
    // The corridor's end is a chord of the circle.
    const double middle = std::sqrt(radius * radius - half * half);
    const double side = radius / std::sqrt(2.0);
    lobby.radius_m = radius;
    lobby.rect = {-side, middle - side, side, middle + side};
    return lobby;
}

void add_lobby(Plan& plan, const Lobby& lobby, const Frame& end, std::size_t corridor) {
    const bool is_hall = lobby.rect.area() > kLeastHallM2;
    const std::size_t room =
        plan.add_room(is_hall ? RoomUse::hall : RoomUse::lounge, end, lobby.rect, 0.2);
    const bool is_round = lobby.radius_m > 0.0;
    const double half = 0.5 * lobby.corridor_m;
    plan.doors.push_back({corridor, room, end, {-half, 0.0, half, is_round ? 0.0 : kWall}, true});
    if (!is_round) return;
    Polygon circle;
    constexpr int kCorners = 36;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2.0 * M_PI * i / kCorners;
        const double y = lobby.rect.center().y + lobby.radius_m * std::sin(angle);
        circle.push_back(end.map({lobby.radius_m * std::cos(angle), std::max(0.0, y)}));
    }
    plan.rooms[room].wedges.push_back(circle);
}

void widen_doors(Plan& plan, double share, Random random) {
    for (PlanDoor& door : plan.doors) {
        const double choice = random.uniform();
        // Some halls are open along most of a side.
        const double width =
            random.uniform() < 0.8 ? random.uniform(1.3, 4.5) : random.uniform(4.5, 10.0);
        const auto is_way = [&](std::size_t room) {
            return plan.rooms[room].use == RoomUse::corridor;
        };
        const RoomUse use = plan.rooms[door.b].use;
        const bool is_private = use == RoomUse::toilet || use == RoomUse::washroom ||
                                use == RoomUse::bathroom || use == RoomUse::cubicle;
        // Without a door between them, two corridors are one.
        const bool is_fire_door = is_way(door.a) && is_way(door.b);
        const double likely = is_way(door.a) ? share : 0.3 * share;
        if (choice >= likely || is_private || is_fire_door || door.is_open_passage) continue;
        // With less of a wall than that, nobody would speak of two rooms.
        constexpr double kMostOfWall = 0.8;
        const double wall = widened(plan, door, kLongestWall).width();
        door.opening = widened(plan, door, std::min(width, kMostOfWall * wall));
        door.is_open_passage = true;
    }
}

}  // namespace quadcut::sim
