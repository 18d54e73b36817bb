// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "formats/result.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "io/room_colors.hpp"
#include "io/room_places.hpp"

namespace quadcut::formats {
namespace {

void check_map(const GridMap& map) {
    if (map.states.width <= 0 || map.states.height <= 0) {
        throw std::logic_error("a map without cells cannot be written");
    }
}

Raster<std::uint16_t> on_map(const GridMap& map, const Raster<std::uint16_t>& from) {
    Raster<std::uint16_t> to(map.states.origin, map.states.width, map.states.height);
    const Box box = to.box().intersected(from.box());
    if (box.is_empty()) return to;
    for (std::int32_t y = box.low.y; y <= box.high.y; ++y) {
        std::copy_n(&from.values[from.offset({box.low.x, y})], box.width(),
                    &to.values[to.offset({box.low.x, y})]);
    }
    return to;
}

/// The segmentation with labels for exactly the cells of the map.
Segmentation on_map(const GridMap& map, const Segmentation& segmentation) {
    Segmentation result;
    result.labels = on_map(map, segmentation.labels);
    result.rooms = segmentation.rooms;
    result.doors = segmentation.doors;
    result.next_id = segmentation.next_id;
    result.report = segmentation.report;
    result.zones = segmentation.zones;
    result.hierarchy.levels = segmentation.hierarchy.levels;
    if (!result.hierarchy.levels.empty()) {
        result.hierarchy.finest = on_map(map, segmentation.hierarchy.finest);
    }
    return result;
}

void check_rooms(const Segmentation& segmentation) {
    const std::vector<Room>& rooms = segmentation.rooms;
    const auto& labels = segmentation.labels.values;
    const auto most = std::max_element(labels.begin(), labels.end());
    const std::map<RoomId, std::size_t> places = io::room_places(rooms);
    bool valid = most == labels.end() || *most <= rooms.size();
    valid = valid && places.size() == rooms.size() && !places.contains(RoomId{});
    valid = valid && (rooms.empty() || index(places.rbegin()->first) <= kMaxRoomId);
    for (const Door& door : segmentation.doors) {
        valid = valid && places.contains(door.a) && places.contains(door.b);
    }
    if (!valid) throw std::logic_error("labels or doors name rooms that are not there");
}

}  // namespace

Result::Result(const GridMap& map, const Segmentation& rooms, const io::RunInfo& info,
               std::string_view updates)
    : map_(map), rooms_(rooms), info_(info), updates_(updates) {
    check_map(map);
    if (rooms.labels.origin != map.states.origin || rooms.labels.width != map.states.width ||
        rooms.labels.height != map.states.height) {
        cut_ = on_map(map, rooms);
    }
    check_rooms(this->rooms());
    near_rooms_ = io::find_near_rooms(map, this->rooms());
    colors_ = io::room_colors(this->rooms(), near_rooms_, info.previous_colors);
}

const draw::FloorPlan& Result::plan() const {
    std::call_once(is_laid_out_, [this] {
        plan_ = draw::lay_out_floor_plan(map_, rooms(), colors_, executor());
    });
    return plan_;
}

double Result::elapsed_ms() const {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double, std::milli>(now - start_).count();
}

}  // namespace quadcut::formats
