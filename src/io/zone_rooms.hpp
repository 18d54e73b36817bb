// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/segment/result.hpp"

namespace quadcut::io {

struct ZoneRooms {
    /// Ascending.
    std::vector<RoomId> rooms;
    double area_m2 = 0.0;
};

/// Zones 1, 2, ... and what is in them; empty when there are none.
[[nodiscard]] inline std::vector<ZoneRooms> rooms_by_zone(const Segmentation& segmentation) {
    std::vector<ZoneRooms> zones(segmentation.zones.count);
    for (std::size_t i = 0; i < segmentation.zones.zone_of_room.size(); ++i) {
        ZoneRooms& zone = zones.at(segmentation.zones.zone_of_room[i] - 1U);
        zone.rooms.push_back(segmentation.rooms[i].id);
        zone.area_m2 += segmentation.rooms[i].area_m2;
    }
    return zones;
}

}  // namespace quadcut::io
