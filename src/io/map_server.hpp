// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/input.hpp"
#include "io/map_yaml.hpp"
#include "io/pixel_states.hpp"
#include "quadcut/map/grid_map.hpp"

namespace quadcut::io {

/// Whether greys that contradict their keys are believed (grey_evidence.hpp,
/// transparent_ground.hpp).
enum class GreyTrust : std::uint8_t { evidence, keys };

/// What people say themselves replaces what a YAML says and what is known of bare images.
struct MapReadOptions {
    /// Metres a pixel.
    std::optional<double> resolution_m = {};
    /// Either one means that the greys are not asked about thresholds.
    std::optional<double> free_thresh = {};
    std::optional<double> occupied_thresh = {};
    /// Black is free, white occupied.
    bool negate = false;
    GreyTrust trust = GreyTrust::evidence;
    /// What `~` in a YAML's image path stands for; when empty, the user's entry in the system's
    /// user database.
    std::filesystem::path home_folder = {};
};

/// A map with where it came from.
struct MapFile {
    GridMap map;
    /// With which the image was read: those of a YAML where nothing else replaced them.
    MapKeys keys;
    std::filesystem::path image_path;
    bool has_yaml = false;
    GreyTally greys;
    /// Each assumption and how to overrule it, a line each.
    std::vector<std::string> warnings;
    std::uint64_t content_hash = 0;  ///< of the YAML's bytes, then the image's
};

/// Reads a map_server YAML with its image, or a bare image (see parse_image), which is taken as
/// trinary, at 0.05 m a pixel when options do not say, with its lower left corner at (0, 0), unless
/// a YAML beside it names it (map_place.hpp).
///
/// States are map_server's. With v = the mean of the colours / the largest value, and
/// occ = negate ? v : 1 - v: trinary: occupied from occupied_thresh up, free up to free_thresh, in
/// between unknown. scale: the values in between are scaled to 0 .. 100; raw: the grey byte is the
/// value, and 101 .. 255 are unknown; such a value is occupied from 65, free up to 25 (where
/// map_saver, writing it as trinary, puts them), else unknown. In trinary and scale a pixel that is
/// not opaque is unknown.
///
/// Evidence goes before metadata: with GreyTrust::evidence, the thresholds and negate of mode
/// trinary are replaced where the image's greys contradict them, and a transparent ground is floor
/// inside of walls. The image is decoded once more for each of the two.
/// Throws InputError that names the file and the place when anything cannot be read, or when
/// free_thresh comes to be above occupied_thresh.
[[nodiscard]] MapFile read_map(const std::filesystem::path& path,
                               const MapReadOptions& options = {});

/// The same of a file that was read already.
[[nodiscard]] MapFile parse_map(InputFile input, const MapReadOptions& options = {});

/// The map of an earlier run, whose keys it was read with are known: they replace those of a YAML,
/// and the greys are asked only whether a transparent ground is floor. There are no warnings, which
/// that run has given.
[[nodiscard]] MapFile parse_map_as_before(InputFile input, const MapKeys& keys);

/// A map, the greys it was made of, and what should be said of it, without the name of the file.
struct ParsedMap {
    GridMap map;
    GreyTally greys;
    std::vector<std::string> warnings;
};

/// The image as a map under the given keys, to the letter; `name` stands in messages.
[[nodiscard]] ParsedMap parse_map_image(std::string_view image_bytes, const std::string& name,
                                        const MapKeys& keys, Ground ground = Ground::unknown);

/// The keys that a bare image is read with. free_thresh is 0.19, not map_server's 0.196, so that
/// 206, which other tools make of the unknown grey 205 when they convert an image, is unknown too.
[[nodiscard]] MapKeys bare_image_keys();

}  // namespace quadcut::io
