// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/map_server.hpp"
#include "io/stored_result.hpp"

namespace quadcut {

/// The map that a folder's result was cut in, read as it was then, whatever its YAML says now. It
/// is the file `given`, or else the one that was cut, where it was then or beside the result, or
/// else the folder's own map.yaml, which is there when a log was cut. A file that has changed since
/// then is one warning. Throws InputError when none is there, when the map has not as many cells as
/// the result, and as io::parse_map().
[[nodiscard]] io::MapFile map_of_result(const std::filesystem::path& folder,
                                        const io::StoredResult& result,
                                        const std::optional<std::string>& given);

/// Whether that map is part of the result, as the map of a log is: quadcut wrote it there.
[[nodiscard]] bool is_part_of_result(const std::filesystem::path& folder, const io::MapFile& map);

}  // namespace quadcut
