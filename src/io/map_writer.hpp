// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <vector>

#include "io/file_batch.hpp"
#include "io/map_yaml.hpp"
#include "quadcut/map/grid_map.hpp"

namespace quadcut::io {

/// The files of a map.
[[nodiscard]] std::vector<std::string> map_files();

/// The keys of a map_server YAML for an image of the map's cells. Resolution and origin are the
/// map's own, the rest is as given; numbers read back exactly.
[[nodiscard]] std::string to_map_yaml(const GridMap& map, const MapKeys& keys);

/// The bytes of map.pgm (0 occupied, 254 free, 205 unknown) and map.yaml, which map_server reads
/// back as the same map. Throws std::logic_error when the map is empty.
[[nodiscard]] std::vector<std::string> encode_map(const GridMap& map);

/// Adds them to a batch; `folder` is their place in it. Errors as FileBatch::add().
void add_map(FileBatch& batch, const GridMap& map, const std::string& folder = {});

}  // namespace quadcut::io
