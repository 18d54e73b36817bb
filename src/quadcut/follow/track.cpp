// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/track.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>

#include "quadcut/base/error.hpp"
#include "quadcut/follow/match_rooms.hpp"
#include "quadcut/rooms/describe.hpp"

namespace quadcut {
namespace {

/// What rooms share, m^2; in the order of the earlier rooms.
std::vector<Meeting> meetings(const Raster<std::uint16_t>& now, const EarlierRooms& earlier) {
    std::map<std::pair<std::uint16_t, std::uint16_t>, std::size_t> num_cells;
    std::pair<std::uint16_t, std::uint16_t> last;
    std::size_t* count = nullptr;
    for (std::size_t i = 0; i < now.values.size(); ++i) {
        const std::pair here(earlier.labels.values[i], now.values[i]);
        if (here.first == 0 || here.second == 0) continue;
        // Neighbouring cells mostly have the same rooms.
        if (count == nullptr || here != last) count = &num_cells[last = here];
        ++*count;
    }
    std::vector<Meeting> result;
    for (const auto& [pair, cells] : num_cells) {
        result.push_back(
            {pair.first - std::size_t{1}, pair.second - std::size_t{1},
             static_cast<double>(cells) * earlier.resolution_m * earlier.resolution_m});
    }
    return result;
}

std::vector<double> areas_m2(const std::vector<Room>& rooms) {
    std::vector<double> areas;
    for (const Room& room : rooms) areas.push_back(room.area_m2);
    return areas;
}

/// `now` has the earlier id.
std::string kept_name(const Room& earlier, const Room& now) {
    const bool is_own = earlier.name != default_name(earlier);
    return is_own ? earlier.name : default_name(now);
}

RoomId take_id(std::uint32_t& next_id) {
    if (next_id > kMaxRoomId) {
        throw InputError("no id is left for a new room: expected less than " +
                         std::to_string(kMaxRoomId) + " rooms since ids were first given");
    }
    return RoomId{next_id++};
}

/// Puts the rooms, and the labels with them, into the order of their ids.
void sort_by_id(Segmentation& segmentation) {
    std::vector<Room>& rooms = segmentation.rooms;
    std::map<RoomId, std::size_t> places;
    for (std::size_t i = 0; i < rooms.size(); ++i) places[rooms[i].id] = i;
    std::vector<Room> sorted;
    std::vector<std::uint16_t> new_label(rooms.size() + 1, 0);
    for (const auto& [id, place] : places) {
        sorted.push_back(std::move(rooms[place]));
        new_label[place + 1] = static_cast<std::uint16_t>(sorted.size());
    }
    rooms = std::move(sorted);
    for (std::uint16_t& label : segmentation.labels.values) label = new_label[label];
}

}  // namespace

Tracked track(Segmentation segmentation, const EarlierRooms& earlier) {
    if (segmentation.labels.box() != earlier.labels.box()) {
        throw std::logic_error("track: the labels do not cover the same rectangle");
    }
    std::vector<Room>& rooms = segmentation.rooms;
    const auto [was, is] = match_rooms(areas_m2(earlier.rooms), areas_m2(rooms),
                                       meetings(segmentation.labels, earlier));
    std::vector<RoomEvent> events;
    segmentation.next_id = earlier.next_id;
    for (std::size_t n = 0; n < rooms.size(); ++n) {
        Room& room = rooms[n];
        RoomChange change = RoomChange::kept;
        RoomId other{};
        if (is[n].same != kNoKin) {
            room.id = earlier.rooms[is[n].same].id;
            room.name = kept_name(earlier.rooms[is[n].same], room);
        } else {
            change = is[n].holder == kNoKin ? RoomChange::born : RoomChange::split;
            if (change == RoomChange::split) other = earlier.rooms[is[n].holder].id;
            room.id = take_id(segmentation.next_id);
            room.name = default_name(room);
        }
        events.push_back(event_of(change, room.id, other, room.name, room.area_m2));
    }
    for (Door& door : segmentation.doors) {
        for (RoomId* side : {&door.a, &door.b}) *side = rooms[index(*side) - 1].id;
    }
    for (std::size_t e = 0; e < earlier.rooms.size(); ++e) {
        if (was[e].same != kNoKin) continue;
        const Room& room = earlier.rooms[e];
        const bool is_merged = was[e].holder != kNoKin;
        events.push_back(event_of(is_merged ? RoomChange::merged : RoomChange::retired, room.id,
                                  is_merged ? rooms[was[e].holder].id : RoomId{}, room.name,
                                  room.area_m2));
    }
    sort_by_id(segmentation);
    return {std::move(segmentation), std::move(events)};
}

}  // namespace quadcut
