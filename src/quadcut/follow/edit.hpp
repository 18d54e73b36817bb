// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "quadcut/base/ids.hpp"
#include "quadcut/follow/follower_state.hpp"

namespace quadcut {

/// A change of followed rooms by people, or what takes one back.
struct Edit {
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

}  // namespace quadcut
