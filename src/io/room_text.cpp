// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "io/number_text.hpp"

namespace quadcut::io {

namespace {

/// By RoomKind.
constexpr std::array<std::string_view, 4> kKinds{"unknown", "room", "corridor", "hall"};
/// By Seen.
constexpr std::array<std::string_view, 3> kSeen{"whole", "partly", "glimpse"};

}  // namespace

std::string_view to_text(RoomKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

std::optional<RoomKind> room_kind(std::string_view text) {
    const auto found = std::find(kKinds.begin(), kKinds.end(), text);
    if (found == kKinds.end()) return std::nullopt;
    return static_cast<RoomKind>(found - kKinds.begin());
}

std::string_view to_text(Seen seen) { return kSeen[static_cast<std::size_t>(seen)]; }

std::optional<Seen> seen_of(std::string_view text) {
    const auto found = std::find(kSeen.begin(), kSeen.end(), text);
    if (found == kSeen.end()) return std::nullopt;
    return static_cast<Seen>(found - kSeen.begin());
}

std::string name_of(const Room& room) {
    return room.name.empty() ? "Room " + std::to_string(index(room.id)) : room.name;
}

std::string area_text(double area_m2) {
    constexpr double kLarge = 100.0;
    return rounded(area_m2, area_m2 < kLarge ? 1 : 0) + " m\u00B2";
}

std::string reason_of(const Door& door) {
    return with_decimals(door.width_m, 2) + " m between rooms " +
           with_decimals(door.room_a_width_m, 1) + " m and " +
           with_decimals(door.room_b_width_m, 1) + " m wide";
}

}  // namespace quadcut::io
