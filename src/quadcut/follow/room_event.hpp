// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>

#include "quadcut/base/ids.hpp"

namespace quadcut {

/// What became of a room, from one update or result to the next.
enum class RoomChange : std::uint8_t { kept, born, grown, split, merged, retired };

struct RoomEvent {
    RoomChange change = RoomChange::kept;
    RoomId room{};
    /// split: the room it was a part of. merged: the room it is a part of now. Otherwise none.
    RoomId other{};
    /// The room's name; its last one, when it is merged or retired. Of a room that is followed the
    /// one that people gave it, or none.
    std::string name;
    std::string reason;
};

/// What became of a room of this area by itself, and why; not `grown`.
[[nodiscard]] RoomEvent event_of(RoomChange change, RoomId room, RoomId other, std::string name,
                                 double area_m2);

/// "12 m^2"
[[nodiscard]] std::string square_metres(double area_m2);

}  // namespace quadcut
