// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/follow/followed_map.hpp"

namespace quadcut {

/// Throws InputError when what is known contradicts itself, and says where. O(map).
void check(const FollowedMap& followed);

/// Throws InputError when a cut by hand lies outside of the map. Its ends lie in walls, which need
/// not be seen.
void require_in_map(const FollowedMap& followed, const std::vector<SplitLine>& lines);

/// Throws InputError when cells, together with all that was written, would span too many.
void require_room_for(const FollowedMap& followed, Box cells);

/// Adds a tile to what is known, without OccupancyMap::commit(). Throws InputError when it lies
/// outside of `written`, or has log-odds that cannot be.
void add_tile(FollowedMap& followed, Cell tile, const Tile& log_odds, const RoomTile& rooms);

}  // namespace quadcut
