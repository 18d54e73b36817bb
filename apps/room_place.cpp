// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/room_place.hpp"

#include <system_error>

#include "io/file.hpp"
#include "io/found_instead.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {

RoomPlace room_place_of(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return RoomPlace::folder;
    const bool is_there = std::filesystem::exists(path, error);
    const bool is_beside_results =
        io::has_result(path.has_parent_path() ? path.parent_path() : ".");
    if (!is_there || (is_beside_results && !io::is_project(path))) {
        throw InputError(io::display_name(path) +
                         ": expected a folder of results or a project, found " +
                         (is_there ? io::found_instead_of_result(path) : "nothing"));
    }
    return RoomPlace::project;
}

}  // namespace quadcut
