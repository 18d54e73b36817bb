// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/scan.hpp"
#include "quadcut/segment/result.hpp"

// Files in and out, for programs that are not quadcut. All throw InputError, which names the file
// and the place, when a file cannot be read or written.
namespace quadcut {

struct MapInFile {
    GridMap map;
    /// What was assumed of the file, a line each.
    std::vector<std::string> warnings;
};

/// Reads a map_server YAML with its image, or an image alone (PNG, PGM, TIFF, BMP, JPEG, GIF; also
/// .gz), which is taken as 0.05 m a pixel. docs/formats.md says how.
[[nodiscard]] MapInFile read_map(const std::filesystem::path& path);

/// Hands on the scans of a CARMEN log one by one, in their order, but for those too far from the
/// others for one map of cells of 5 cm; returns what a user should know of the log, a line each.
/// What `visit` throws comes out here.
std::vector<std::string> read_scans(const std::filesystem::path& path,
                                    const std::function<void(const Scan&)>& visit);

/// Writes map.pgm and map.yaml into a folder, which is made if need be: both, or none. Files of
/// these names that quadcut has not written are refused. The map has cells.
void write_map(const std::filesystem::path& folder, const GridMap& map);

/// The same of the files of rooms that `quadcut segment` writes: labels, legend, pictures, GeoJSON,
/// graph, report.
void write_rooms(const std::filesystem::path& folder, const GridMap& map,
                 const Segmentation& segmentation);

}  // namespace quadcut
