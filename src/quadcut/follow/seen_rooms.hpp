// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/follow/followed_map.hpp"
#include "quadcut/follow/room_event.hpp"
#include "quadcut/map/occupancy_map.hpp"

namespace quadcut {

/// Counts which rooms a scan saw together, by the rooms of the moment: floor that has none yet does
/// not count. O(tiles that it spoke of, cells of those on a border, pairs of rooms in sight).
void count_seen(FollowedMap& followed, const MapUpdate& scan);

/// What scans saw of rooms that are part of others now counts for those; what they saw of rooms
/// that ended otherwise is forgotten. A room that was split off begins anew.
void count_events(FollowedMap& followed, const std::vector<RoomEvent>& events);

}  // namespace quadcut
