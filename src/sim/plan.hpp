// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/shape.hpp"

namespace quadcut::sim {

/// What a room is for: decides its name, its furniture and, for most, its shape.
enum class RoomUse : std::uint8_t {
    corridor,
    aisle,
    hall,
    office,
    open_office,
    meeting,
    laboratory,
    classroom,
    cubicle,
    washroom,
    toilet,
    storage,
    kitchen,
    lounge,
    bedroom,
    ward,
    bathroom,
};

/// A rectangle of floor between the faces of its walls.
struct FloorPart {
    Frame frame;
    Rect rect;
};

struct PlanRoom {
    RoomUse use = RoomUse::office;
    /// Floor, without overlap. Parts of one room touch along whole edges. All but corridors have
    /// one frame for all parts.
    std::vector<FloorPart> parts;
    /// More floor, where a corridor bends by an angle that is not right.
    std::vector<Polygon> wedges;
    /// How thick the walls around are drawn where no other floor is.
    double wall_m = 0.2;
};

/// A hole in the wall between two rooms. The opening is a rectangle of `frame`: x along the wall,
/// y through it, room `a` at its lower y. Its middle line divides the floor between the two.
struct PlanDoor {
    std::size_t a = 0;
    std::size_t b = 0;
    Frame frame;
    Rect opening;
    /// Without a leaf: a passage or the open side of a cubicle.
    bool is_open_passage = false;
};

/// A hollow inside the building that nobody can enter; some surveys draw it as free.
struct Shaft {
    Polygon outline;
    bool drawn_free = false;
};

/// A building in metres: floors and the openings between them. Everything else is wall.
struct Plan {
    std::vector<PlanRoom> rooms;
    std::vector<PlanDoor> doors;
    std::vector<Shaft> shafts;
    /// Pillars and pilasters; they stand on the floor of a room.
    std::vector<Polygon> pillars;

    /// Adds a room of one rectangle; returns its index.
    std::size_t add_room(RoomUse use, const Frame& frame, const Rect& rect, double wall_m) {
        rooms.push_back({use, {{frame, rect}}, {}, wall_m});
        return rooms.size() - 1;
    }
};

}  // namespace quadcut::sim
