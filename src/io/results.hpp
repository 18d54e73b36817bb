// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "io/palette.hpp"
#include "io/report.hpp"
#include "io/room_pairs.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/segmentation.hpp"

namespace quadcut::io {

/// Writes what a segmentation found into `folder`, which is made if need be:
/// rooms.png (16-bit ids, the map image's size, 0 = no room), rooms.yaml (the map's keys, and the
/// legend), rooms_color.png and rooms.svg (to look at), rooms.geojson, graph.json, report.json.
/// All are prepared under other names and then put in place together; what an interrupted run
/// leaves is whole. The time it takes is added to the report's stages as `write`.
/// No rooms: the same files, empty. Throws InputError that names the path when the folder or a file
/// in it cannot be written; std::logic_error when the map is empty, labels or doors name rooms that
/// are not there, or ids are not different ones in 1 .. kMaxRoomId.
void write_results(const std::filesystem::path& folder, const GridMap& map,
                   const Segmentation& segmentation, const RunInfo& info);

/// Writes map.pgm (0 occupied, 254 free, 205 unknown) and map.yaml, which map_server reads back as
/// the same map. Errors as write_results.
void write_map(const std::filesystem::path& folder, const GridMap& map);

/// Rooms that are drawn in clearly different colours: they touch, or lie across a wall.
[[nodiscard]] std::vector<RoomPair> find_near_rooms(const GridMap& map,
                                                    const Segmentation& segmentation);

/// The colour of each room in pictures and legends; those that had one before keep it.
[[nodiscard]] std::vector<Rgb> room_colors(const Segmentation& segmentation,
                                           const std::vector<RoomPair>& near_rooms,
                                           const std::map<RoomId, Rgb>& previous = {});

}  // namespace quadcut::io
