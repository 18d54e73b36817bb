// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <filesystem>

namespace quadcut {

/// Where rooms are kept, in a folder of results or in a project.
enum class RoomPlace : std::uint8_t { folder, project };

/// Which of the two a path is that a user named as DIR|PROJECT. Throws InputError when nothing is
/// there, and when it is a file that is no project in a folder of results; who opens the place says
/// what else is wrong with it.
[[nodiscard]] RoomPlace room_place_of(const std::filesystem::path& path);

}  // namespace quadcut
