// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "io/file_batch.hpp"
#include "io/palette.hpp"
#include "io/report.hpp"
#include "io/room_pairs.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/segmentation.hpp"

namespace quadcut::io {

/// The files of a segmentation, first what people look at.
[[nodiscard]] std::vector<std::string> result_files();
/// The files of a map.
[[nodiscard]] std::vector<std::string> map_files();

/// Adds what a segmentation found to a batch:
/// rooms.png (16-bit ids, the map image's size, 0 = no room), rooms.yaml (the map's keys, and the
/// legend), rooms_color.png and rooms.svg (to look at), rooms.geojson, graph.json, report.json.
/// The time it takes is added to the report's stages as `write`.
/// No rooms: the same files, empty. Errors as FileBatch::add(); std::logic_error when the map is
/// empty, labels or doors name rooms that are not there, or ids are not different ones in
/// 1 .. kMaxRoomId.
void add_results(FileBatch& batch, const GridMap& map, const Segmentation& segmentation,
                 const RunInfo& info);
/// The same without report.json.
void add_rooms(FileBatch& batch, const GridMap& map, const Segmentation& segmentation,
               const RunInfo& info);
/// A batch of all of them and nothing else, into a folder that is made if need be.
void write_results(const std::filesystem::path& folder, const GridMap& map,
                   const Segmentation& segmentation, const RunInfo& info);

/// Adds map.pgm (0 occupied, 254 free, 205 unknown) and map.yaml, which map_server reads back as
/// the same map; `folder` is their place in the batch. Errors as add_results().
void add_map(FileBatch& batch, const GridMap& map, const std::string& folder = {});

/// Rooms that are drawn in clearly different colours: they touch, or lie across a wall.
[[nodiscard]] std::vector<RoomPair> find_near_rooms(const GridMap& map,
                                                    const Segmentation& segmentation);

/// The colour of each room in pictures and legends; those that had one before keep it.
[[nodiscard]] std::vector<Rgb> room_colors(const Segmentation& segmentation,
                                           const std::vector<RoomPair>& near_rooms,
                                           const std::map<RoomId, Rgb>& previous = {});

}  // namespace quadcut::io
