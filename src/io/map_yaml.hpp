// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/yaml.hpp"
#include "quadcut/base/geometry.hpp"

namespace quadcut::io {

/// How map_server turns a grey value into a state.
enum class MapMode { trinary, scale, raw };

/// The keys of a map_server YAML.
struct MapKeys {
    std::string image;  ///< as written: relative to the YAML, absolute, or under ~
    MapMode mode = MapMode::trinary;
    double resolution_m = 0.05;
    Pose map_from_image;  ///< `origin`: the lower left corner of the image
    bool negate = false;
    double occupied_thresh = 0.65;
    double free_thresh = 0.196;
    /// A grey of 0 .. 255 that is unknown in mode trinary, whatever the thresholds say. No key of a
    /// YAML: only the image can tell.
    std::optional<int> unknown_grey;
};

/// The name of a mode as it stands in a YAML.
[[nodiscard]] std::string_view to_text(MapMode mode);

/// Parses the first document of a map_server YAML. image, resolution, origin, negate,
/// occupied_thresh and free_thresh must be there; mode may; other keys are ignored, all as
/// map_server has it. Throws InputError with the line when the text is no YAML, a key is missing
/// or twice there, or a value cannot be: a resolution outside 0.001 .. 10 metres, thresholds
/// outside 0 .. 1 or crossed, an origin that is not three finite numbers.
[[nodiscard]] MapKeys parse_map_yaml(std::string_view bytes, const std::string& name);

/// The same from a YAML that has been read; `name` stands in messages.
[[nodiscard]] MapKeys map_keys_of(const YamlNode& root, const std::string& name);

/// Throws InputError that begins with `place` unless the resolution is in 0.001 .. 10 metres.
void check_resolution(double resolution_m, const std::string& place);

}  // namespace quadcut::io
