// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "quadcut/segment/result.hpp"

namespace quadcut::io {

/// "room", "corridor", "hall" or "unknown".
[[nodiscard]] std::string_view to_text(RoomKind kind);
/// The kind that has this text; nothing for any other.
[[nodiscard]] std::optional<RoomKind> room_kind(std::string_view text);

/// "whole", "partly" or "glimpse".
[[nodiscard]] std::string_view to_text(Seen seen);
/// What was seen that has this text; nothing for any other.
[[nodiscard]] std::optional<Seen> seen_of(std::string_view text);

/// The room's name, or "Room 7" if it has none.
[[nodiscard]] std::string name_of(const Room& room);

/// Of the share of a border that is open.
inline constexpr int kShareDecimals = 2;

/// "12.3 m²", whole square metres from 100 on.
[[nodiscard]] std::string area_text(double area_m2);

/// Why the map is cut there: "0.82 m between rooms 3.4 m and 2.0 m wide".
[[nodiscard]] std::string reason_of(const Door& door);

}  // namespace quadcut::io
