// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/conductance.hpp"

#include <map>
#include <vector>

namespace quadcut {

Graph conductance_graph(const Segmentation& segmentation) {
    std::map<RoomId, std::uint32_t> place_of;
    std::vector<double> area_m2;
    for (const Room& room : segmentation.rooms) {
        place_of.emplace(room.id, static_cast<std::uint32_t>(area_m2.size()));
        area_m2.push_back(room.area_m2);
    }
    std::vector<WeightedEdge> edges;
    for (const Door& door : segmentation.doors) {
        edges.push_back({place_of.at(door.a), place_of.at(door.b), door.width_m});
    }
    return build_graph(edges, std::move(area_m2));
}

}  // namespace quadcut
