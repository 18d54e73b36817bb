// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/snapshot.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include "io/room_name.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/follow/followed_result.hpp"
#include "quadcut/map/line_walk.hpp"
#include "quadcut/rooms/describe.hpp"

namespace quadcut {
namespace {

/// In cells, from the corner of the lowest.
Point on_cells(const GridMap& map, const Point& point) {
    const Point in_map = transform(inverse(map.map_from_image), point);
    return {in_map.x / map.resolution_m, in_map.y / map.resolution_m};
}

/// 0 outside.
std::uint16_t label_at(const Raster<std::uint16_t>& labels, const Point& at) {
    const bool is_on_map =
        at.x >= 0.0 && at.y >= 0.0 && at.x < labels.width && at.y < labels.height;
    return is_on_map ? labels.at(cell_of(at)) : std::uint16_t{0};
}

/// How far a point is from the interval at .. at + 1.
double distance_to_cell(double point, std::int32_t at) {
    return std::max({0.0, at - point, point - (at + 1.0)});
}

/// O(cells) outside of rooms.
Place place_on(const Segmentation& rooms, const GridMap& map, const Point& point) {
    const Point at = on_cells(map, point);
    const Raster<std::uint16_t>& labels = rooms.labels;
    std::uint16_t label = label_at(labels, at);
    const bool is_inside = label != 0;
    double least = is_inside ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < labels.values.size() && !is_inside; ++i) {
        if (labels.values[i] == 0) continue;
        const Cell cell = labels.cell(i);
        const double far =
            std::hypot(distance_to_cell(at.x, cell.x), distance_to_cell(at.y, cell.y));
        if (far >= least) continue;
        least = far;
        label = labels.values[i];
    }
    if (label == 0) return {};
    const Room& room = rooms.rooms[label - std::size_t{1}];
    return {room.id, room.name, is_inside, least * map.resolution_m};
}

/// 0: it is no number.
RoomId as_id(const std::string& word) {
    std::uint32_t id = 0;
    const char* const end = word.data() + word.size();
    const auto [read, error] = std::from_chars(word.data(), end, id);
    return error == std::errc() && read == end ? RoomId{id} : RoomId{};
}

RoomId id_of(const Segmentation& rooms, const std::string& name) {
    const auto found = std::find_if(rooms.rooms.begin(), rooms.rooms.end(),
                                    [&](const Room& room) { return room.name == name; });
    return found == rooms.rooms.end() ? RoomId{} : found->id;
}

}  // namespace

struct Snapshot::Impl {
    std::optional<FollowedMap> followed;
    FollowOptions options;
    Executor executor;
    Story story;
    std::once_flag has_map;
    GridMap map;
    std::once_flag has_rooms;
    Segmentation rooms;
};

Snapshot::Snapshot(GridMap map, Segmentation rooms) : impl_(std::make_unique<Impl>()) {
    impl_->map = std::move(map);
    impl_->rooms = std::move(rooms);
}

Snapshot::Snapshot(FollowedMap followed, const FollowOptions& options, const Executor& executor,
                   Story story)
    : impl_(std::make_unique<Impl>()) {
    impl_->followed = std::move(followed);
    impl_->options = options;
    impl_->executor = executor;
    impl_->story = std::move(story);
}

Snapshot::~Snapshot() = default;

const FollowedMap* Snapshot::followed() const {
    return impl_->followed ? &*impl_->followed : nullptr;
}

std::uint64_t Snapshot::revision() const { return followed() ? followed()->revision : 0; }

std::size_t Snapshot::num_rooms() const {
    return followed() ? followed()->rooms.size() : impl_->rooms.rooms.size();
}

const GridMap& Snapshot::map() const {
    if (followed()) {
        std::call_once(impl_->has_map, [&] { impl_->map = followed()->map.to_grid(); });
    }
    return impl_->map;
}

const Segmentation& Snapshot::rooms() const {
    if (followed()) {
        std::call_once(impl_->has_rooms, [&] {
            impl_->rooms = result_of(*followed(), impl_->options.segment.rooms, impl_->executor,
                                     impl_->options.zones);
        });
    }
    return impl_->rooms;
}

std::string Snapshot::updates() const {
    return impl_->story.updates ? impl_->story.updates() : std::string();
}

std::vector<Point> Snapshot::way() const {
    return impl_->story.way ? impl_->story.way() : std::vector<Point>();
}

RoomId Snapshot::room_at(const Point& point) const {
    if (followed()) return quadcut::room_at(*followed(), point);
    const std::uint16_t label = label_at(rooms().labels, on_cells(map(), point));
    return label == 0 ? RoomId{} : rooms().rooms[label - std::size_t{1}].id;
}

Place Snapshot::place_of(const Point& point) const {
    const RoomId id = followed() ? room_at(point) : RoomId{};
    if (id != RoomId{}) {
        // A default name tells the kind, which goes by all rooms around.
        const std::string& name = followed()->rooms.at(static_cast<std::uint32_t>(id)).name;
        if (!name.empty()) return {id, name, true, 0.0};
    }
    return num_rooms() == 0 ? Place{} : place_on(rooms(), map(), point);
}

bool Snapshot::has_room(RoomId id) const {
    if (followed()) return followed()->rooms.contains(static_cast<std::uint32_t>(id));
    return std::any_of(rooms().rooms.begin(), rooms().rooms.end(),
                       [&](const Room& room) { return room.id == id; });
}

RoomId Snapshot::given_to(const std::string& name) const {
    if (!followed()) return id_of(rooms(), name);
    for (const auto& [number, room] : followed()->rooms) {
        if (room.name == name) return RoomId{number};
    }
    return RoomId{};
}

RoomId Snapshot::find_room(const std::string& word) const {
    const RoomId id = as_id(word);
    const bool is_there = has_room(id);
    const std::string name = io::trimmed_room_name(word);
    const RoomId named = given_to(name);
    if (is_there && named != RoomId{} && named != id) {
        throw InputError("'" + name + "' is the id of one room and the name of room " +
                         std::to_string(index(named)) + ": expected '" +
                         std::to_string(index(named)) +
                         "' for that one; another name for it makes the other's id free");
    }
    if (is_there) return id;
    if (named != RoomId{}) return named;
    if (room_with_default_name(name) != RoomId{}) {
        const RoomId by_default = id_of(rooms(), name);
        if (by_default != RoomId{}) return by_default;
    }
    throw InputError("there is no room '" + name + "': expected the id or the name of one of the " +
                     std::to_string(num_rooms()) + " rooms; 'quadcut rooms' lists them");
}

}  // namespace quadcut
