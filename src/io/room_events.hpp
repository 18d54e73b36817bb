// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>

#include "io/json_writer.hpp"
#include "quadcut/follow/room_event.hpp"

namespace quadcut::io {

/// kept, born, grown, split, merged, retired
[[nodiscard]] const char* name_of(RoomChange change);

/// An object: `event`, `room`, its `name` if it has one, for a split `from` and for a merge `into`
/// which room, and the `reason`.
void write_event(JsonWriter& json, const RoomEvent& event);

/// An object: `kept`, the number of rooms that were kept, and `events`, one for each of the others.
void write_events(JsonWriter& json, std::span<const RoomEvent> events);

/// "18 rooms kept, 1 born (23), 1 split (24 from 7), 1 merged (9 into 4), 1 retired (12)". What did
/// not happen is not said, and of what happened often the first few are named.
[[nodiscard]] std::string events_text(std::span<const RoomEvent> events);

}  // namespace quadcut::io
