// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_writer.hpp"

#include <cstdint>
#include <span>
#include <stdexcept>

#include "io/image.hpp"
#include "io/rooms_yaml.hpp"

namespace quadcut::io {

std::vector<std::string> map_files() { return {"map.pgm", "map.yaml"}; }

void add_map(FileBatch& batch, const GridMap& map, const std::string& folder) {
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
    keys.image = "map.pgm";
    batch.add(folder + keys.image, encode_pgm(header, fill_row));
    batch.add(folder + "map.yaml", to_map_yaml(map, keys));
}

}  // namespace quadcut::io
