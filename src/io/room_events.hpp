// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>

#include "io/json_writer.hpp"
#include "quadcut/follow/track.hpp"

namespace quadcut::io {

/// An object: `kept`, the number of rooms that were kept, and `events`, one for each of the others:
/// `event` (new, split, merged, gone), `room` and `name`, and for a split `from`, for a merge
/// `into` which room.
void write_events(JsonWriter& json, std::span<const RoomEvent> events);

/// "18 rooms kept, 1 new (23), 1 split off (24 from 7), 1 merged (9 into 4), 1 gone (12)". What did
/// not happen is not said, and of what happened often the first few are named.
[[nodiscard]] std::string events_text(std::span<const RoomEvent> events);

}  // namespace quadcut::io
