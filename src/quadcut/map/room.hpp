// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/ids.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// What a room is by its shape and its doors.
enum class RoomKind : std::uint8_t { unknown, room, corridor, hall };

/// How much of a room was seen: all of it, but for a little; a part, so that much of its border is
/// open to the unknown; or it was glimpsed from elsewhere, as rays through a window or a door left
/// ajar, and is no room.
enum class Seen : std::uint8_t { whole, partly, glimpse };

/// A place people would name. Positions are in the map frame, metres.
struct Room {
    RoomId id{};
    std::string name;
    RoomKind kind = RoomKind::unknown;
    double area_m2 = 0.0;
    Point centroid;
    /// A free point inside the room, as far from its border as can be: where a label fits and a
    /// robot can stand.
    Point label_point;
    Seen seen = Seen::whole;
    /// 0..1: of its border with the unknown and with obstacles, that with the unknown.
    double open_border = 0.0;
};

/// The cut between two rooms: a straight line across the opening, from jamb to jamb.
struct Door {
    RoomId a{};
    RoomId b{};
    Point jamb_1;
    Point jamb_2;
    double width_m = 0.0;
    /// How wide the two rooms are near it: twice the largest clearance within 5 m, in a and in b.
    double room_a_width_m = 0.0;
    double room_b_width_m = 0.0;
    /// 0..1: how clearly the free space narrows here.
    double confidence = 0.0;
    friend bool operator==(const Door&, const Door&) = default;
};

/// The map cut at another granularity.
struct HierarchyLevel {
    double granularity = 0.0;
    /// Which of its regions, 1 .. num_regions, each region of the finest level is part of.
    std::vector<std::uint16_t> region_of_finest;
    std::uint32_t num_regions = 0;
};

/// The map cut at several granularities at once, nested: every region of a coarser level, and every
/// room, is a union of regions of the finest one.
struct Hierarchy {
    /// Regions 1 .. n of the finest level; 0 = none. Empty when no hierarchy was asked for.
    Raster<std::uint16_t> finest;
    /// Coarsest first; levels that are like the one before are left out.
    std::vector<HierarchyLevel> levels;
};

/// The highest id that a room can have; also the most rooms that a map can have.
inline constexpr std::uint32_t kMaxRoomId = 65535;

}  // namespace quadcut
