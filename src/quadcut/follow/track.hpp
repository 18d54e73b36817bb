// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <vector>

#include "quadcut/follow/room_event.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

/// The rooms of an earlier result, on the cells of a new one.
struct EarlierRooms {
    /// As Segmentation::labels: 0 = no room, otherwise 1 + the room's place in `rooms`.
    Raster<std::uint16_t> labels;
    double resolution_m = 0.05;
    /// Of each counts: id, name, kind, and area_m2, also of what lies beyond the new cells.
    std::vector<Room> rooms;
    /// Higher than every id that was ever given.
    std::uint32_t next_id = 1;
};

/// A segmentation whose rooms are recognised, in the order of their ids, and what became of whom:
/// an event for each room that there is, and one for each earlier room that is no more.
struct Tracked {
    Segmentation segmentation;
    std::vector<RoomEvent> events;
};

/// Gives rooms the ids and names that they had in an earlier result.
///
/// Who is the same says match_rooms() (kept).
/// Of the others, a new room at least half of which was in one earlier room is split from it, or
/// else it is born; an earlier room at least half of which is in one new room is merged into it, or
/// else it is retired. Split and merged name rooms that are there: had those no partner, they would
/// be the same room.
///
/// Kinds are those of the new rooms. A name is kept as it is, unless it is the one that a room of
/// that kind and id has by itself, which follows the kind. Ids are never given twice; new ones are
/// given in the order of the new rooms, from earlier.next_id on.
/// Throws InputError when an id would exceed kMaxRoomId. O(cells + n log n) for n pairs that meet.
/// @pre rooms are numbered 1 .. n, as segment() leaves them; both labels cover the same rectangle;
/// earlier ids differ and are less than next_id.
[[nodiscard]] Tracked track(Segmentation segmentation, const EarlierRooms& earlier);

}  // namespace quadcut
