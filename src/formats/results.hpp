// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <vector>

#include "io/file_batch.hpp"
#include "io/report.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::formats {

/// The files of a segmentation, first what people look at.
[[nodiscard]] std::vector<std::string> result_files();

/// Adds what a segmentation found to a batch:
/// rooms.png (16-bit ids, the map image's size, 0 = no room), rooms.yaml (the map's keys, and the
/// legend), rooms_color.png and rooms.svg (to look at), rooms.geojson, graph.json, report.json.
/// The time it takes is added to the report's stages as `write`.
/// No rooms: the same files, empty. Errors as FileBatch::add(); std::logic_error when the map is
/// empty, labels or doors name rooms that are not there, or ids are not different ones in
/// 1 .. kMaxRoomId.
void add_results(io::FileBatch& batch, const GridMap& map, const Segmentation& segmentation,
                 const io::RunInfo& info);
/// The same without report.json.
void add_rooms(io::FileBatch& batch, const GridMap& map, const Segmentation& segmentation,
               const io::RunInfo& info);
/// A batch of all of them and nothing else, into a folder that is made if need be.
void write_results(const std::filesystem::path& folder, const GridMap& map,
                   const Segmentation& segmentation, const io::RunInfo& info);

}  // namespace quadcut::formats
