// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "project/snapshot.hpp"

namespace quadcut {

/// Where rooms are kept, in a folder of results or in a project.
enum class RoomPlace : std::uint8_t { folder, project };

/// Which of the two a path is that a user named as DIR|PROJECT. Throws InputError when nothing is
/// there, and when it is a file that is no project in a folder of results; who opens the place says
/// what else is wrong with it.
[[nodiscard]] RoomPlace room_place_of(const std::filesystem::path& path);

/// What is asked of the building at a path.
enum class Wanted : std::uint8_t { rooms, rooms_and_doors };

/// The building that is kept at a path, as it was saved last. A folder of results has no cells of
/// its map, only where they lie, and doors only if they are wanted. Throws InputError as above, as
/// Project::open(), and as io::read_stored_result(). O(file).
[[nodiscard]] std::shared_ptr<const Snapshot> building_at(const std::filesystem::path& path,
                                                          Wanted wanted);

}  // namespace quadcut
