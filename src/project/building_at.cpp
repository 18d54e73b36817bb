// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/building_at.hpp"

#include <system_error>
#include <utility>

#include "io/file.hpp"
#include "io/found_instead.hpp"
#include "io/previous_result.hpp"
#include "io/stored_result.hpp"
#include "project/project.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

GridMap frame_of(const io::MapKeys& keys) { return {keys.resolution_m, keys.map_from_image, {}}; }

std::shared_ptr<const Snapshot> labels_in(const std::filesystem::path& folder) {
    io::PreviousResult result = io::read_previous_result(folder);
    Segmentation rooms;
    rooms.labels = std::move(result.labels);
    rooms.rooms = std::move(result.legend.rooms);
    return std::make_shared<const Snapshot>(frame_of(result.legend.map_keys), std::move(rooms));
}

}  // namespace

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

std::shared_ptr<const Snapshot> building_at(const std::filesystem::path& path, Wanted wanted) {
    if (room_place_of(path) == RoomPlace::project) {
        return Project::open(path, Access::read).snapshot();
    }
    if (wanted == Wanted::rooms) return labels_in(path);
    io::StoredResult result = io::read_stored_result(path);
    return std::make_shared<const Snapshot>(frame_of(result.map_keys), std::move(result.rooms));
}

}  // namespace quadcut
