// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/layout.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/room.hpp"

namespace quadcut {

/// The name of a room that nobody has named: "corridor 3", or "glimpse 9". Rooms of unknown kind
/// are rooms.
[[nodiscard]] std::string default_name(const Room& room);

/// The room whose default name this is or would be, whatever its kind; 0 = none.
[[nodiscard]] RoomId room_with_default_name(std::string_view name);

/// Area, centroid, label point, kind and name of each region 1 .. count, whose doors are given.
/// Names are the default ones. O(cells); `memory` as of clearance_m().
[[nodiscard]] std::vector<Room> describe_rooms(const Raster<std::uint32_t>& labels,
                                               std::uint32_t count, const GridMap& map,
                                               const Layout& layout, const std::vector<Door>& doors,
                                               const Executor& executor = {},
                                               Raster<float> memory = {});

}  // namespace quadcut
