// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_writer.hpp"

#include <cstdint>
#include <span>
#include <stdexcept>

#include "io/format_version.hpp"
#include "io/image.hpp"
#include "io/map_frame.hpp"
#include "io/number_text.hpp"

namespace quadcut::io {

std::vector<std::string> map_files() { return {"map.pgm", "map.yaml"}; }

std::string to_map_yaml(const GridMap& map, const MapKeys& keys) {
    const Pose origin = MapFrame(map).pose_of(map.states.origin);
    std::string yaml;
    yaml += "image: " + keys.image + "\n";
    yaml.append("mode: ").append(to_text(keys.mode)).append("\n");
    yaml += "resolution: " + exact(map.resolution_m) + "\n";
    yaml += "origin: [" + exact(origin.x) + ", " + exact(origin.y) + ", " + exact(origin.yaw_rad) +
            "]\n";
    yaml += std::string("negate: ") + (keys.negate ? "1" : "0") + "\n";
    yaml += "occupied_thresh: " + exact(keys.occupied_thresh) + "\n";
    yaml += "free_thresh: " + exact(keys.free_thresh) + "\n";
    yaml += "format_version: " + std::to_string(kFormatVersion) + "\n";
    return yaml;
}

std::vector<std::string> encode_map(const GridMap& map) {
    if (map.states.width <= 0 || map.states.height <= 0) {
        throw std::logic_error("a map without cells cannot be written");
    }
    constexpr std::uint16_t kOccupiedGrey = 0;
    constexpr std::uint16_t kFreeGrey = 254;
    constexpr std::uint16_t kUnknownGrey = 205;
    const Raster<CellState>& states = map.states;
    const ImageHeader header{states.width, states.height, 1, 255};
    const auto fill_row = [&](std::int32_t y, std::span<std::uint16_t> samples) {
        const Cell first{states.origin.x, states.origin.y + states.height - 1 - y};
        const std::size_t begin = states.offset(first);
        for (std::size_t x = 0; x < samples.size(); ++x) {
            const CellState state = states.values[begin + x];
            samples[x] = state == CellState::free       ? kFreeGrey
                         : state == CellState::occupied ? kOccupiedGrey
                                                        : kUnknownGrey;
        }
    };
    MapKeys keys;
    keys.image = map_files().front();
    // No list of strings: what is in one can only be copied.
    std::vector<std::string> bytes;
    bytes.push_back(encode_pgm(header, fill_row));
    bytes.push_back(to_map_yaml(map, keys));
    return bytes;
}

void add_map(FileBatch& batch, const GridMap& map, const std::string& folder) {
    const std::vector<std::string> files = map_files();
    const std::vector<std::string> bytes = encode_map(map);
    for (std::size_t i = 0; i < files.size(); ++i) batch.add(folder + files[i], bytes[i]);
}

}  // namespace quadcut::io
