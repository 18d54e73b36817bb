// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/map_yaml.hpp"
#include "io/palette.hpp"
#include "quadcut/follow/track.hpp"
#include "quadcut/map/grid_map.hpp"

namespace quadcut::io {

/// What a rooms.yaml says of the rooms.
struct RoomsLegend {
    MapKeys map_keys;
    /// Without area.
    std::vector<Room> rooms;
    /// Of each room, its value in the label image.
    std::vector<std::uint16_t> values;
    std::map<RoomId, Rgb> colors;
    std::uint32_t next_id = 1;
};

/// Reads a rooms.yaml as the format `labels` writes it and people edit it; without a `color` a room
/// has none, without `centroid` or `label_point` these are (0, 0), without `next_id` it is one more
/// than the highest id, and what else is there plays no part. Throws InputError as parse_map_yaml,
/// and with line and key when format_version is not one that is known, a value or an id is not in 1
/// .. kMaxRoomId or there twice, a kind or colour is none, a point is none, or next_id is not
/// higher than every id.
[[nodiscard]] RoomsLegend parse_rooms_yaml(std::string_view bytes, const std::string& name);

/// A result that write_results wrote.
struct PreviousResult {
    RoomsLegend legend;
    /// From cell (0, 0): 0 = no room, otherwise 1 + the room's place in legend.rooms, which have
    /// their area.
    Raster<std::uint16_t> labels;
};

/// Reads rooms.yaml and the label image it names (rooms.png) from a folder. Throws InputError that
/// names the file, and the place in it, when one is not there, cannot be read, or is not what
/// write_results writes; also when a pixel has a value that rooms.yaml does not list.
[[nodiscard]] PreviousResult read_previous_result(const std::filesystem::path& folder);

/// The image of a legend; `name` and `legend_name` stand in messages. Errors as above.
[[nodiscard]] PreviousResult parse_label_png(std::string_view bytes, const std::string& name,
                                             RoomsLegend legend, const std::string& legend_name);

/// The rooms on the cells of `map`: each has the room that is at its centre in the map frame,
/// whatever origin, direction and resolution the earlier map had. O(cells).
[[nodiscard]] EarlierRooms on_cells_of(const PreviousResult& previous, const GridMap& map);

/// The same; a result that does not fit the map there, but elsewhere (find_shift()), is moved,
/// which is the warning.
struct PlacedRooms {
    EarlierRooms rooms;
    std::vector<std::string> warnings;
};
[[nodiscard]] PlacedRooms place_on_map(PreviousResult previous, const GridMap& map);

}  // namespace quadcut::io
