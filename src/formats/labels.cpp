// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "formats/format.hpp"
#include "io/image.hpp"
#include "io/json_writer.hpp"
#include "io/map_frame.hpp"
#include "io/map_writer.hpp"
#include "io/number_text.hpp"
#include "io/room_text.hpp"

namespace quadcut::formats {
namespace {

constexpr const char* kImage = "rooms.png";

std::string pair_of(const Point& point, int decimals) {
    return "[" + io::rounded(point.x, decimals) + ", " + io::rounded(point.y, decimals) + "]";
}

/// Of each cell, the id of its room, as an image of the map image's size, turned upright.
std::string encode_ids(const Segmentation& segmentation, const Executor& executor) {
    std::vector<std::uint16_t> id_of{0};
    for (const Room& room : segmentation.rooms) {
        id_of.push_back(static_cast<std::uint16_t>(index(room.id)));
    }
    const Raster<std::uint16_t>& labels = segmentation.labels;
    const auto fill_row = [&](std::int32_t y, std::span<std::uint16_t> samples) {
        const std::size_t begin =
            labels.offset({labels.origin.x, labels.origin.y + labels.height - 1 - y});
        for (std::size_t x = 0; x < samples.size(); ++x) {
            samples[x] = id_of[labels.values[begin + x]];
        }
    };
    return io::encode_png({labels.width, labels.height, 1, 65535}, fill_row, executor);
}

/// The keys of the map for the label image, and `labels`: what each value of it means. A room's
/// value is its id; `next_id` is higher than any id that was ever given. Positions in metres, map
/// frame.
std::string to_yaml(const Result& result) {
    const GridMap& map = result.map();
    const std::vector<Room>& rooms = result.rooms().rooms;
    io::MapKeys keys = result.info().map_keys;
    keys.image = kImage;
    std::size_t next_id = result.rooms().next_id;
    for (const Room& room : rooms) next_id = std::max(next_id, index(room.id) + 1);
    const int decimals = io::MapFrame(map).decimals();
    std::string yaml = io::to_map_yaml(map, keys);
    yaml += "frame: map\n";
    yaml += "next_id: " + std::to_string(next_id) + "\n";
    yaml += rooms.empty() ? "labels: []\n" : "labels:\n";
    for (std::size_t i = 0; i < rooms.size(); ++i) {
        const Room& room = rooms[i];
        const std::string number = std::to_string(index(room.id));
        yaml += "  - {value: ";
        yaml += number;
        yaml += ", id: ";
        yaml += number;
        yaml += ", name: ";
        yaml += io::json_text(io::name_of(room));
        yaml += ", kind: ";
        yaml += io::to_text(room.kind);
        yaml += ", seen: ";
        yaml += io::to_text(room.seen);
        if (room.seen != Seen::whole)
            yaml += ", open_border: " + io::rounded(room.open_border, io::kShareDecimals);
        yaml += ", area_m2: ";
        yaml += io::rounded(room.area_m2);
        yaml += ", centroid: ";
        yaml += pair_of(room.centroid, decimals);
        yaml += ", label_point: ";
        yaml += pair_of(room.label_point, decimals);
        yaml += ", color: \"";
        yaml += io::to_hex(result.colors()[i]);
        yaml += "\"}\n";
    }
    return yaml;
}

}  // namespace

Format labels_format() {
    return {"labels",
            "the room of each cell, and a legend to read or edit",
            Part::rooms,
            {kImage, "rooms.yaml"},
            [](const Result& result) {
                std::vector<std::string> all =
                    contents(encode_ids(result.rooms(), result.executor()));
                all.push_back(to_yaml(result));
                return all;
            }};
}

}  // namespace quadcut::formats
