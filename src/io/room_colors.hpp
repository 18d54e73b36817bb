// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <map>
#include <vector>

#include "io/palette.hpp"
#include "io/room_pairs.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::io {

/// Rooms that are drawn in clearly different colours: they touch, or lie across a wall.
[[nodiscard]] std::vector<RoomPair> find_near_rooms(const GridMap& map,
                                                    const Segmentation& segmentation);

/// The colour of each room in pictures and legends; those that had one before keep it.
[[nodiscard]] std::vector<Rgb> room_colors(const Segmentation& segmentation,
                                           const std::vector<RoomPair>& near_rooms,
                                           const std::map<RoomId, Rgb>& previous = {});

}  // namespace quadcut::io
