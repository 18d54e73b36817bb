// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/ids.hpp"
#include "quadcut/follow/follow_update.hpp"

namespace quadcut {

/// What people say of a room.
struct RoomSettings {
    /// Empty: the default name.
    std::string name;
    /// Not 0: made one by people; rooms of one group that touch are one room.
    std::uint32_t merge_group = 0;
    /// Its cells are its own whatever is seen there.
    bool is_locked = false;
    friend bool operator==(const RoomSettings&, const RoomSettings&) = default;
};

/// A cut that people drew: to the rooms on both sides it is a wall.
struct SplitLine {
    Cell from;
    Cell to;
    friend bool operator==(const SplitLine&, const SplitLine&) = default;
};

enum class EditKind : std::uint8_t { rename, merge, split, lock, unlock };

/// What people ask for; it holds from then on.
struct Edit {
    EditKind kind = EditKind::rename;
    /// Not read by a split.
    RoomId room{};
    /// merge: becomes part of `room`, which it touches; what is one stays one.
    RoomId other{};
    /// rename: kept as it is, and no other room's; an empty one is none.
    std::string name;
    /// split: cuts the room that most of the line between two points of the map frame lies in, from
    /// wall to wall, in two of which the larger keeps its id; the line stays a cut. A wall may be
    /// nearer than the points, or a metre farther. What cannot be cut is refused with the nearest
    /// line that can, within 3 m.
    Point from;
    Point to;
    // A locked room keeps its cells, and gets no others. What was seen there meanwhile counts once
    // it is unlocked.
};

/// What takes an edit back, or makes it again.
struct Reversal {
    enum class Border : std::uint8_t { none, part, join };

    RoomId room{};
    /// part: the room that begins. join: the one that ends, in `room`.
    RoomId other{};
    Border border = Border::none;
    /// Of rooms that it changes: how they are afterwards.
    std::map<std::uint32_t, RoomSettings> settings;
    /// part: what becomes `other`, by the tile's x and y; cell (x, y) is bit 8 y + x.
    std::map<std::pair<std::int32_t, std::int32_t>, std::uint64_t> cells;
    /// part: cuts that begin. join: cuts that end, as do all between the two.
    std::vector<SplitLine> lines;
};

/// What an edit did, and what takes it back.
struct Edited {
    FollowUpdate update;
    Reversal inverse;
};

}  // namespace quadcut
