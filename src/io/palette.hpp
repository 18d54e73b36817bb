// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/room_pairs.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::io {

/// A colour in sRGB.
struct Rgb {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// "#rrggbb".
[[nodiscard]] std::string to_hex(Rgb color);

/// `share` of `over` laid on `under`, 0..1, in sRGB.
[[nodiscard]] Rgb mixed(Rgb under, Rgb over, double share);

/// How different two colours look: the distance in OKLab (Ottosson 2020). 0.02 is just seen,
/// black to white is 1.
[[nodiscard]] double perceived_distance(Rgb a, Rgb b);

/// Rooms of a pair differ by at least this, as long as none has more than a dozen neighbours with
/// colours of their own.
inline constexpr double kClearDistance = 0.045;

/// A soft colour for each room: rooms[i] has label i + 1. Rooms of a pair get clearly different
/// colours, corridors pale neutral ones. A room whose colour is given in `kept` (empty, or one for
/// each room) has that one, unless it touches a room before it whose given colour is too like it.
/// Depends on nothing but the arguments. O(pairs log rooms).
[[nodiscard]] std::vector<Rgb> choose_room_colors(std::span<const RoomKind> kinds,
                                                  std::span<const RoomPair> pairs,
                                                  std::span<const std::optional<Rgb>> kept = {});

}  // namespace quadcut::io
