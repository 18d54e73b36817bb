// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <map>
#include <span>

#include "quadcut/segment/result.hpp"

namespace quadcut::io {

/// Where each id stands among the rooms: ids that are kept from an earlier result have gaps.
[[nodiscard]] inline std::map<RoomId, std::size_t> room_places(std::span<const Room> rooms) {
    std::map<RoomId, std::size_t> places;
    for (std::size_t i = 0; i < rooms.size(); ++i) places.emplace(rooms[i].id, i);
    return places;
}

}  // namespace quadcut::io
