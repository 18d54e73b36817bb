// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/rooms_yaml.hpp"

#include <algorithm>
#include <vector>

#include "io/format_version.hpp"
#include "io/json_writer.hpp"
#include "io/map_frame.hpp"
#include "io/number_text.hpp"
#include "io/room_text.hpp"

namespace quadcut::io {
namespace {

std::string pair_of(const Point& point, int decimals) {
    return "[" + rounded(point.x, decimals) + ", " + rounded(point.y, decimals) + "]";
}

}  // namespace

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

std::string to_rooms_yaml(const GridMap& map, const MapKeys& keys, const Segmentation& segmentation,
                          std::span<const Rgb> colors) {
    const std::vector<Room>& rooms = segmentation.rooms;
    std::size_t next_id = segmentation.next_id;
    for (const Room& room : rooms) next_id = std::max(next_id, index(room.id) + 1);
    const int decimals = MapFrame(map).decimals();
    std::string yaml = to_map_yaml(map, keys);
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
        yaml += json_text(name_of(room));
        yaml += ", kind: ";
        yaml += to_text(room.kind);
        yaml += ", area_m2: ";
        yaml += rounded(room.area_m2);
        yaml += ", centroid: ";
        yaml += pair_of(room.centroid, decimals);
        yaml += ", label_point: ";
        yaml += pair_of(room.label_point, decimals);
        yaml += ", color: \"";
        yaml += to_hex(colors[i]);
        yaml += "\"}\n";
    }
    return yaml;
}

}  // namespace quadcut::io
