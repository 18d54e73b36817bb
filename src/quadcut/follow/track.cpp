// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/track.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>

#include "quadcut/base/error.hpp"
#include "quadcut/rooms/describe.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kNone = SIZE_MAX;

/// An earlier room and a new one that have cells in common; both by place.
struct Meeting {
    std::size_t earlier = 0;
    std::size_t now = 0;
    std::size_t num_cells = 0;
};

/// The largest first; equal ones in the order of the rooms.
std::vector<Meeting> meetings(const Raster<std::uint16_t>& now,
                              const Raster<std::uint16_t>& earlier) {
    std::map<std::pair<std::uint16_t, std::uint16_t>, std::size_t> num_cells;
    std::pair<std::uint16_t, std::uint16_t> last;
    std::size_t* count = nullptr;
    for (std::size_t i = 0; i < now.values.size(); ++i) {
        if (now.values[i] == 0 || earlier.values[i] == 0) continue;
        const std::pair here(earlier.values[i], now.values[i]);
        // Neighbouring cells mostly have the same rooms.
        if (count == nullptr || here != last) count = &num_cells[last = here];
        ++*count;
    }
    std::vector<Meeting> result;
    for (const auto& [pair, cells] : num_cells) {
        result.push_back({pair.first - std::size_t{1}, pair.second - std::size_t{1}, cells});
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Meeting& a, const Meeting& b) { return a.num_cells > b.num_cells; });
    return result;
}

/// Places of rooms in the other result, or kNone.
struct Kin {
    std::size_t same = kNone;
    /// The room that has at least half of this one.
    std::size_t holder = kNone;
};

/// The kin of the earlier rooms, and of the new ones.
std::pair<std::vector<Kin>, std::vector<Kin>> pair_up(const std::vector<Room>& rooms,
                                                      const EarlierRooms& earlier,
                                                      const std::vector<Meeting>& largest_first) {
    std::vector<Kin> was(earlier.rooms.size());
    std::vector<Kin> is(rooms.size());
    for (const auto& [e, n, num_cells] : largest_first) {
        const double shared_m2 =
            static_cast<double>(num_cells) * earlier.resolution_m * earlier.resolution_m;
        const bool has_earlier = shared_m2 >= 0.5 * earlier.rooms[e].area_m2;
        const bool has_now = shared_m2 >= 0.5 * rooms[n].area_m2;
        if (has_earlier && was[e].holder == kNone) was[e].holder = n;
        if (has_now && is[n].holder == kNone) is[n].holder = e;
        if ((has_earlier || has_now) && was[e].same == kNone && is[n].same == kNone) {
            was[e].same = n;
            is[n].same = e;
        }
    }
    return {std::move(was), std::move(is)};
}

std::string kept_name(const Room& earlier, RoomKind kind) {
    const bool is_own = earlier.name != default_name(earlier.kind, earlier.id);
    return is_own ? earlier.name : default_name(kind, earlier.id);
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
    const auto [was, is] = pair_up(rooms, earlier, meetings(segmentation.labels, earlier.labels));
    std::vector<RoomEvent> events;
    segmentation.next_id = earlier.next_id;
    for (std::size_t n = 0; n < rooms.size(); ++n) {
        Room& room = rooms[n];
        RoomChange change = RoomChange::kept;
        RoomId other{};
        if (is[n].same != kNone) {
            room.id = earlier.rooms[is[n].same].id;
            room.name = kept_name(earlier.rooms[is[n].same], room.kind);
        } else {
            change = is[n].holder == kNone ? RoomChange::born : RoomChange::split;
            if (change == RoomChange::split) other = earlier.rooms[is[n].holder].id;
            room.id = take_id(segmentation.next_id);
            room.name = default_name(room.kind, room.id);
        }
        events.push_back({change, room.id, room.name, other});
    }
    for (Door& door : segmentation.doors) {
        for (RoomId* side : {&door.a, &door.b}) *side = rooms[index(*side) - 1].id;
    }
    for (std::size_t e = 0; e < earlier.rooms.size(); ++e) {
        if (was[e].same != kNone) continue;
        const bool is_merged = was[e].holder != kNone;
        events.push_back({is_merged ? RoomChange::merged : RoomChange::gone, earlier.rooms[e].id,
                          earlier.rooms[e].name, is_merged ? rooms[was[e].holder].id : RoomId{}});
    }
    sort_by_id(segmentation);
    return {std::move(segmentation), std::move(events)};
}

}  // namespace quadcut
