// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_server.hpp"

#include <span>
#include <utility>

#include "io/file.hpp"
#include "io/file_kind.hpp"
#include "io/grey_evidence.hpp"
#include "io/image.hpp"
#include "io/inflate.hpp"
#include "io/input.hpp"
#include "io/map_place.hpp"
#include "io/number_text.hpp"
#include "io/transparent_ground.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr double kBareResolution = 0.05;
constexpr double kBareFreeThreshold = 0.19;

/// What stands at the end of each assumption on the greys.
constexpr const char* kOverruled =
    "; --trust-yaml, --free-thresh or --occupied-thresh overrule this";

/// Where a map comes from, before its image is looked at.
struct MapSource {
    MapFile file;
    std::string image_name;
    std::string image_bytes;
};

std::string read_image_of_yaml(const std::filesystem::path& image, const std::string& yaml_name) {
    try {
        return read_file(image);
    } catch (const InputError& error) {
        const bool is_missing = !std::filesystem::exists(image);
        throw InputError(yaml_name + ": image: " + error.what() +
                         (is_missing ? "; put the file beside the YAML, or mend the key" : ""));
    }
}

MapSource source_of_yaml(const InputFile& input, const MapReadOptions& options) {
    MapSource source;
    MapFile& file = source.file;
    file.has_yaml = true;
    file.keys =
        is_gzip(input.bytes)
            ? parse_map_yaml(unpack_gzip(input.bytes, input.name, kMaxYamlBytes), input.name)
            : parse_map_yaml(input.bytes, input.name);
    const FoundImage image =
        find_image(file.keys.image, input.folder / input.path.filename(), options.home_folder);
    file.image_path = image.path;
    source.image_name = display_name(image.path);
    source.image_bytes = read_image_of_yaml(image.path, input.name);
    file.content_hash = hash_bytes(source.image_bytes, hash_bytes(input.bytes));
    if (image.is_elsewhere) {
        file.warnings.push_back("image: nothing is at " + file.keys.image + ", so " +
                                display_name(image.path) + " beside the YAML is read");
    }
    return source;
}

MapSource source_of_image(InputFile input, const MapReadOptions& options) {
    MapSource source;
    MapFile& file = source.file;
    file.image_path = input.path;
    source.image_name = input.name;
    file.content_hash = hash_bytes(input.bytes);
    if (const std::optional<YamlBeside> yaml = find_yaml_beside(input.path)) {
        file.has_yaml = true;
        file.keys = yaml->keys;
        file.content_hash = hash_bytes(input.bytes, hash_bytes(yaml->bytes));
        file.warnings.push_back(
            "resolution, origin and thresholds are those of " + display_name(yaml->path) +
            ", which names the image" +
            (yaml->other ? ", as " + display_name(*yaml->other) + " does" : "") +
            " (give a YAML itself to choose another)");
    } else {
        file.keys = bare_image_keys();
        file.keys.image = input.path.filename().string();
        if (!options.resolution_m) {
            file.warnings.emplace_back("an image states no resolution, taken as 0.05 m a pixel");
        }
    }
    source.image_bytes = std::move(input.bytes);
    return source;
}

MapSource source_of(InputFile input, const MapReadOptions& options) {
    const bool is_yaml = find_file_nature(input.bytes, input.name).kind == FileKind::map_yaml;
    return is_yaml ? source_of_yaml(input, options) : source_of_image(std::move(input), options);
}

MapKeys with_options(MapKeys keys, const MapReadOptions& options, const std::string& name) {
    keys.resolution_m = options.resolution_m.value_or(keys.resolution_m);
    keys.free_thresh = options.free_thresh.value_or(keys.free_thresh);
    keys.occupied_thresh = options.occupied_thresh.value_or(keys.occupied_thresh);
    keys.negate = keys.negate || options.negate;
    if (keys.free_thresh > keys.occupied_thresh) {
        throw InputError(name + ": --free-thresh " + exact(keys.free_thresh) +
                         " is above --occupied-thresh " + exact(keys.occupied_thresh) +
                         ", expected at most that; give both");
    }
    return keys;
}

/// Reads the image of a map whose keys are known; what the greys say against them is added to its
/// warnings.
MapFile with_states(MapSource source, const MapReadOptions& options) {
    MapFile file = std::move(source.file);
    Ground ground = Ground::unknown;
    const auto parse = [&] {
        return parse_map_image(source.image_bytes, source.image_name, file.keys, ground);
    };
    ParsedMap parsed = parse();
    const bool asks = options.trust == GreyTrust::evidence;
    if (asks && is_drawn_on_transparent(parsed.greys, file.keys)) {
        ground = Ground::floor;
        parsed = parse();
    }
    if (asks && !options.free_thresh && !options.occupied_thresh) {
        const auto source_of_negate = options.negate ? NegateSource::person : NegateSource::file;
        if (auto reading = find_grey_reading(parsed.greys, file.keys, source_of_negate)) {
            file.keys = std::move(reading->keys);
            file.warnings.push_back(reading->reason + kOverruled);
            parsed = parse();
        }
    }
    for (std::string& warning : parsed.warnings) file.warnings.push_back(std::move(warning));
    file.greys = parsed.greys;
    file.map = std::move(parsed.map);
    if (ground == Ground::floor) {
        WalledFloor floor = take_outside_away(std::move(file.map));
        file.map = std::move(floor.map);
        file.warnings.push_back(
            std::string("walls are drawn on a transparent ground, which is taken as floor ") +
            (floor.is_enclosed ? "inside of them" : "everywhere, since they enclose nothing") +
            "; --trust-yaml makes it unknown");
    }
    return file;
}

}  // namespace

MapKeys bare_image_keys() {
    MapKeys keys;
    keys.resolution_m = kBareResolution;
    keys.free_thresh = kBareFreeThreshold;
    return keys;
}

ParsedMap parse_map_image(std::string_view image_bytes, const std::string& name,
                          const MapKeys& keys, Ground ground) {
    ParsedMap parsed;
    parsed.map.resolution_m = keys.resolution_m;
    parsed.map.map_from_image = keys.map_from_image;
    Raster<CellState>& states = parsed.map.states;
    std::optional<PixelStates> pixels;
    const auto convert_row = [&](const ImageHeader& header, std::int32_t y,
                                 std::span<const std::uint16_t> samples) {
        if (y == 0) {
            states = Raster<CellState>({}, header.width, header.height);
            pixels.emplace(header, keys, ground);
        }
        // Row 0 of an image is the top, row 0 of a raster the lowest.
        pixels->convert(samples, &states.at({0, header.height - 1 - y}));
    };
    parsed.warnings = parse_image(image_bytes, name, convert_row).warnings;
    parsed.greys = pixels->tally();
    return parsed;
}

MapFile read_map(const std::filesystem::path& path, const MapReadOptions& options) {
    return parse_map(read_input(path), options);
}

MapFile parse_map(InputFile input, const MapReadOptions& options) {
    if (options.resolution_m) check_resolution(*options.resolution_m, "");
    const std::string name = input.name;
    MapSource source = source_of(std::move(input), options);
    source.file.keys = with_options(std::move(source.file.keys), options, name);
    MapFile file = with_states(std::move(source), options);
    for (std::string& warning : file.warnings) warning.insert(0, name + ": ");
    return file;
}

MapFile parse_map_as_before(InputFile input, const MapKeys& keys) {
    MapReadOptions options;
    options.resolution_m = keys.resolution_m;
    options.free_thresh = keys.free_thresh;
    options.occupied_thresh = keys.occupied_thresh;
    MapSource source = source_of(std::move(input), options);
    source.file.keys = keys;
    MapFile file = with_states(std::move(source), options);
    file.warnings.clear();
    return file;
}

}  // namespace quadcut::io
