// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_server.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include <pwd.h>
#include <unistd.h>

#include "io/file.hpp"
#include "io/file_kind.hpp"
#include "io/image.hpp"
#include "io/inflate.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr double kBareResolution = 0.05;
constexpr double kBareFreeThreshold = 0.19;
constexpr int kMaxByte = 255;

CellState state_of_percent(double percent) {
    // map_saver's own defaults for turning 0 .. 100 into three states.
    constexpr double kOccupied = 65.0;
    constexpr double kFree = 25.0;
    if (percent >= kOccupied) return CellState::occupied;
    return percent <= kFree ? CellState::free : CellState::unknown;
}

/// The state of a pixel whose brightness is `shade` of 0 .. 1.
CellState state_of_shade(double shade, const MapKeys& keys) {
    if (keys.mode == MapMode::raw) {
        const double value = std::round(shade * kMaxByte);
        return value > 100.0 ? CellState::unknown : state_of_percent(value);
    }
    const double occupancy = keys.negate ? shade : 1.0 - shade;
    if (occupancy >= keys.occupied_thresh) return CellState::occupied;
    if (occupancy <= keys.free_thresh) return CellState::free;
    if (keys.mode == MapMode::trinary) return CellState::unknown;
    return state_of_percent(std::round((occupancy - keys.free_thresh) /
                                       (keys.occupied_thresh - keys.free_thresh) * 100.0));
}

/// Turns pixels into states. The sum of a pixel's colours is its index into a table of states.
class PixelStates {
public:
    PixelStates(const ImageHeader& header, const MapKeys& keys)
        : num_channels_(static_cast<std::size_t>(header.channels)),
          num_colors_(header.channels < 3 ? 1 : 3),
          opaque_(static_cast<std::uint16_t>(header.max_value)),
          uses_alpha_(header.channels % 2 == 0 && keys.mode != MapMode::raw) {
        const std::size_t brightest = num_colors_ * static_cast<std::size_t>(header.max_value);
        for (std::size_t sum = 0; sum <= brightest; ++sum) {
            states_.push_back(
                state_of_shade(static_cast<double>(sum) / static_cast<double>(brightest), keys));
        }
        counts_.resize(states_.size());
    }

    void convert(std::span<const std::uint16_t> samples, CellState* cells) {
        for (std::size_t i = 0; i < samples.size(); i += num_channels_) {
            std::size_t sum = samples[i];
            if (num_colors_ == 3) sum += std::size_t{samples[i + 1]} + samples[i + 2];
            const bool is_seen = !uses_alpha_ || samples[i + num_channels_ - 1] == opaque_;
            *cells++ = is_seen ? states_[sum] : CellState::unknown;
            if (is_seen) ++counts_[sum];
        }
    }

    /// How many pixels of a grey in first .. last, on the scale of 0 .. 255, are free.
    [[nodiscard]] std::uint64_t count_free(double first, double last) const {
        const double scale =
            static_cast<double>(kMaxByte) / static_cast<double>(states_.size() - 1);
        std::uint64_t count = 0;
        for (std::size_t sum = 0; sum < states_.size(); ++sum) {
            const double grey = static_cast<double>(sum) * scale;
            const bool in_range = grey >= first - 0.5 && grey < last + 0.5;
            if (in_range && states_[sum] == CellState::free) count += counts_[sum];
        }
        return count;
    }

private:
    std::size_t num_channels_;
    std::size_t num_colors_;
    std::uint16_t opaque_;
    bool uses_alpha_;
    std::vector<CellState> states_;
    std::vector<std::uint64_t> counts_;
};

/// map_saver writes 205 for unknown, just outside its own thresholds. Other thresholds, and tools
/// that shift the grey a little, make the unknown world free without anybody noticing.
std::vector<std::string> warn_of_free_unknown(const PixelStates& pixels, std::size_t num_pixels,
                                              const MapKeys& keys) {
    if (keys.mode != MapMode::trinary || keys.negate) return {};
    constexpr double kUnknown = 205.0;
    constexpr double kNear = 2.0;
    constexpr double kLargeShare = 0.01;
    std::uint64_t count = pixels.count_free(kUnknown, kUnknown);
    std::string grey = "grey 205";
    if (count == 0) {
        count = pixels.count_free(kUnknown - kNear, kUnknown + kNear);
        grey = "a grey near 205";
        if (static_cast<double>(count) < kLargeShare * static_cast<double>(num_pixels)) return {};
    }
    if (count == 0) return {};
    std::array<char, 32> threshold{};
    std::to_chars(threshold.data(), threshold.data() + threshold.size() - 1, keys.free_thresh);
    return {std::to_string(count) + " pixels of " + grey +
            ", which map_saver writes for unknown, are read as free, because free_thresh is " +
            threshold.data()};
}

std::filesystem::path home_of_user() {
    constexpr std::size_t kBufferBytes = std::size_t{1} << 14U;
    std::vector<char> buffer(kBufferBytes);
    passwd entry{};
    passwd* found = nullptr;
    if (::getpwuid_r(::getuid(), &entry, buffer.data(), buffer.size(), &found) != 0 ||
        found == nullptr || found->pw_dir == nullptr) {
        return {};
    }
    return found->pw_dir;
}

std::filesystem::path find_image(const std::string& image, const InputFile& yaml,
                                 const MapReadOptions& options) {
    if (image == "~" || image.starts_with("~/")) {
        const std::filesystem::path home =
            options.home_folder.empty() ? home_of_user() : options.home_folder;
        if (home.empty()) {
            throw InputError(yaml.name + ": image: " + image +
                             ": no home folder is known, expected a path without ~");
        }
        return image.size() <= 2 ? home : home / image.substr(2);
    }
    return yaml.folder / image;  // An absolute path stays as it is.
}

std::string read_image_of_yaml(const MapFile& file, const std::string& yaml_name) {
    try {
        return read_file(file.image_path);
    } catch (const InputError& error) {
        throw InputError(yaml_name + ": image: " + error.what());
    }
}

}  // namespace

MapKeys bare_image_keys() {
    MapKeys keys;
    keys.resolution_m = kBareResolution;
    keys.free_thresh = kBareFreeThreshold;
    return keys;
}

ParsedMap parse_map_image(std::string_view image_bytes, const std::string& name,
                          const MapKeys& keys) {
    ParsedMap parsed;
    parsed.map.resolution_m = keys.resolution_m;
    parsed.map.map_from_image = keys.map_from_image;
    Raster<CellState>& states = parsed.map.states;
    std::optional<PixelStates> pixels;
    const auto convert_row = [&](const ImageHeader& header, std::int32_t y,
                                 std::span<const std::uint16_t> samples) {
        if (y == 0) {
            states = Raster<CellState>({}, header.width, header.height);
            pixels.emplace(header, keys);
        }
        // Row 0 of an image is the top, row 0 of a raster the lowest.
        pixels->convert(samples, &states.at({0, header.height - 1 - y}));
    };
    parsed.warnings = parse_image(image_bytes, name, convert_row).warnings;
    for (std::string& warning : warn_of_free_unknown(*pixels, states.values.size(), keys)) {
        parsed.warnings.push_back(std::move(warning));
    }
    return parsed;
}

MapFile read_map(const std::filesystem::path& path, const MapReadOptions& options) {
    return parse_map(read_input(path), options);
}

MapFile parse_map(InputFile input, const MapReadOptions& options) {
    if (options.resolution_m) check_resolution(*options.resolution_m, "");
    const std::string& name = input.name;
    std::string bytes = std::move(input.bytes);
    MapFile file;
    file.content_hash = hash_bytes(bytes);
    file.has_yaml = find_file_nature(bytes, name).kind == FileKind::map_yaml;
    if (file.has_yaml && is_gzip(bytes)) bytes = unpack_gzip(bytes, name, kMaxYamlBytes);
    file.keys = file.has_yaml ? parse_map_yaml(bytes, name) : bare_image_keys();
    file.image_path = file.has_yaml ? find_image(file.keys.image, input, options) : input.path;
    if (file.has_yaml) {
        bytes = read_image_of_yaml(file, name);
        file.content_hash = hash_bytes(bytes, file.content_hash);
    } else {
        file.keys.image = input.path.filename().string();
        if (!options.resolution_m) {
            file.warnings.push_back(name +
                                    ": an image states no resolution, taken as 0.05 m a "
                                    "pixel");
        }
    }
    file.keys.resolution_m = options.resolution_m.value_or(file.keys.resolution_m);
    ParsedMap parsed =
        parse_map_image(bytes, file.has_yaml ? display_name(file.image_path) : name, file.keys);
    file.map = std::move(parsed.map);
    for (std::string& warning : parsed.warnings) {
        file.warnings.push_back(std::move(warning.insert(0, name + ": ")));
    }
    return file;
}

}  // namespace quadcut::io
