// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <vector>

#include "io/file_batch.hpp"
#include "quadcut/map/grid_map.hpp"

namespace quadcut::io {

/// The files of a map.
[[nodiscard]] std::vector<std::string> map_files();

/// Adds map.pgm (0 occupied, 254 free, 205 unknown) and map.yaml, which map_server reads back as
/// the same map; `folder` is their place in the batch. Errors as FileBatch::add();
/// std::logic_error when the map is empty.
void add_map(FileBatch& batch, const GridMap& map, const std::string& folder = {});

}  // namespace quadcut::io
