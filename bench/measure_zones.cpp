// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "bench/campus.hpp"
#include "bench/result_file.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
int run(int argc, char** argv) {
    Json all = Json::array();
    for (std::size_t i = 0; i < 60; ++i) {
        sim::BuildingOptions options = campus_of_wings(i % 30);
        if (i >= 30) options.num_wings = 0;
        const sim::Building building = sim::generate_building(options);
        const Segmentation rooms = segment(building.map);
        const auto wings = wings_of_rooms(building, rooms);
        Json c;
        c["true_rooms"] = building.rooms.size();
        c["rooms"] = Json::array();
        for (std::size_t r = 0; r < rooms.rooms.size(); ++r) {
            const Room& room = rooms.rooms[r];
            c["rooms"].push_back({{"area", room.area_m2}, {"cx", room.centroid.x}, {"cy", room.centroid.y}, {"lx", room.label_point.x}, {"ly", room.label_point.y}, {"wing", wings[r]}, {"kind", (int)room.kind}});
        }
        c["doors"] = Json::array();
        for (const Door& door : rooms.doors) {
            c["doors"].push_back({{"a", index(door.a) - 1}, {"b", index(door.b) - 1}, {"w", door.width_m}, {"aw", door.room_a_width_m}, {"bw", door.room_b_width_m}, {"x", (door.jamb_1.x + door.jamb_2.x) / 2}, {"y", (door.jamb_1.y + door.jamb_2.y) / 2}, {"conf", door.confidence}});
        }
        all.push_back(c);
        std::fprintf(stderr, "%zu ", i);
    }
    std::ofstream(argv[argc - 1]) << all.dump();
    return 0;
}
}  // namespace quadcut
int main(int argc, char** argv) { return quadcut::run(argc, argv); }
