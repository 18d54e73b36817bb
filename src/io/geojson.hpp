// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>
#include <string>

#include "io/palette.hpp"
#include "io/room_pairs.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::io {

/// Rooms and doors as a GeoJSON FeatureCollection in metres of the map frame ("frame": "map" says
/// so), one feature a line. Rooms are exact: the outlines run along cell edges, so that they have
/// the area that is given and neighbours meet without gap or overlap; outer rings
/// counter-clockwise, holes clockwise. A room in several parts is a MultiPolygon. Doors are the
/// lines of the cuts. `neighbours` are the rooms that touch or share a door; `perimeter_m` is the
/// length of the outer outline with its stairs smoothed. The hierarchy's regions follow, and
/// `regions`, features that are JSON already. O(cells).
/// @pre labels are those of the rooms; colors[i] is that of rooms[i].
[[nodiscard]] std::string to_geojson(const GridMap& map, const Segmentation& segmentation,
                                     std::span<const RoomPair> pairs, std::span<const Rgb> colors,
                                     std::span<const std::string> regions = {});

}  // namespace quadcut::io
