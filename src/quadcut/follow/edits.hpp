// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "quadcut/base/parallel.hpp"
#include "quadcut/follow/edit.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/follow/options.hpp"
#include "quadcut/map/raster.hpp"

// What people change in followed rooms. All throw InputError, with nothing changed, and say why.

namespace quadcut {

/// What an edit changes; a split takes an id.
[[nodiscard]] Reversal change_of(FollowedMap& followed, const Edit& edit);

/// The same for a split. @pre it is one.
[[nodiscard]] Reversal change_of_split(FollowedMap& followed, const Edit& edit);

/// Changes it. Returns what takes that back.
Reversal apply(FollowedMap& followed, const Reversal& change, const FollowOptions& options,
               const Executor& executor, FollowUpdate& update);

/// A room's number, when it is there.
[[nodiscard]] std::uint32_t existing(const FollowedMap& followed, RoomId room);

[[nodiscard]] std::string name_of(RoomId room);

/// 1 = the room's.
[[nodiscard]] Raster<std::uint8_t> mask_of(const FollowedMap& followed, std::uint32_t room);

}  // namespace quadcut
