// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/map_yaml.hpp"
#include "io/palette.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::io {

/// What a folder of results holds now: people may have given rooms other names, kinds and colours
/// in its rooms.yaml since it was written.
struct StoredResult {
    /// Without hierarchy and report.
    Segmentation rooms;
    /// Of the map that was cut: how its image is read.
    MapKeys map_keys;
    std::map<RoomId, Rgb> colors;
    /// The file that was cut, as its user named it; empty when that is not known.
    std::string input;
    /// As report.json has it; empty when that is not known.
    std::string input_hash;
    /// By name, as io::set_option() takes them; empty when that is not known.
    std::map<std::string, std::string> options;
    /// The features of rooms.geojson that are regions of another granularity, as they stand there.
    std::vector<std::string> regions;
};

/// Reads rooms.yaml, rooms.png, rooms.geojson and, if it is there, report.json. Throws InputError
/// as read_previous_result() and parse_doors().
[[nodiscard]] StoredResult read_stored_result(const std::filesystem::path& folder);

/// The doors of a rooms.geojson as the format `geojson` writes it; `name` stands in messages.
/// Throws InputError that names the feature when the text is no JSON, when a door is not written as
/// there, or is one of a room that is not among `rooms`.
[[nodiscard]] std::vector<Door> parse_doors(std::string_view bytes, const std::string& name,
                                            std::span<const Room> rooms);

}  // namespace quadcut::io
