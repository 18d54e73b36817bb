// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/route_end.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "apps/message.hpp"
#include "io/nearest_word.hpp"
#include "io/number_text.hpp"
#include "io/room_name.hpp"
#include "io/room_text.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

constexpr double kMostMovedM = 0.5;
/// No map reaches so far.
constexpr double kFarthestM = 1e9;

std::optional<double> as_number(std::string_view word) {
    while (word.starts_with(' ')) word.remove_prefix(1);
    double value = 0.0;
    const auto [read, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number =
        error == std::errc() && read == word.data() + word.size() && std::abs(value) <= kFarthestM;
    return is_number ? std::optional(value) : std::nullopt;
}

std::optional<Point> as_point(const std::string& word) {
    const std::size_t comma = word.find(',');
    if (comma == std::string::npos) return std::nullopt;
    const std::optional<double> x = as_number(std::string_view(word).substr(0, comma));
    const std::optional<double> y = as_number(std::string_view(word).substr(comma + 1));
    if (!x || !y) return std::nullopt;
    return Point{*x, *y};
}

std::string ids_text(const std::vector<const Room*>& rooms) {
    std::vector<std::string> ids;
    for (const Room* room : rooms) ids.push_back(std::to_string(index(room->id)));
    return io::either_of({ids.begin(), ids.end()});
}

const Room& find_room(const std::string& what, const std::string& word, const Snapshot& building) {
    const std::vector<Room>& rooms = building.rooms().rooms;
    const std::string name = io::trimmed_room_name(word);
    if (name.empty()) {
        throw InputError(what + ": nothing: expected a point as X,Y, or the id or name of a room");
    }
    std::vector<const Room*> named;
    std::vector<std::string> names;
    bool is_id = false;
    for (const Room& room : rooms) {
        names.push_back(io::name_of(room));
        if (names.back() == name) named.push_back(&room);
        is_id = is_id || std::to_string(index(room.id)) == name;
    }
    if (named.size() > 1) {
        throw InputError(what + ": " + std::to_string(named.size()) + " rooms have the name '" +
                         name + "': expected the id of one, " + ids_text(named));
    }
    if (named.empty() && !is_id) {
        throw InputError(what + ": there is no room '" + name + "'" +
                         io::suggestion(name, {names.begin(), names.end()},
                                        ": expected a point as X,Y, or the id or name of a room; "
                                        "'quadcut rooms' lists them"));
    }
    const RoomId id = building.find_room(name);
    return *std::find_if(rooms.begin(), rooms.end(),
                         [id](const Room& room) { return room.id == id; });
}

std::string metres(double value) { return io::with_decimals(value, 2) + " m"; }

[[noreturn]] void say_why_not(const RouteEnd& end, const Snapshot& building, double width_m) {
    const Place place = building.place_of(end.point);
    const std::string room =
        place.room == RoomId{} ? "" : std::to_string(index(place.room)) + " " + place.name;
    if (place.is_inside) {
        throw InputError(end.what + ": " + end.word + ": a robot " + metres(width_m) +
                         " wide does not fit there (room " + room +
                         "): expected a place farther from the walls, or a narrower robot "
                         "(--robot-width)");
    }
    throw InputError(end.what + ": " + end.word + " is in no room, but in a wall or outside" +
                     (room.empty() ? ""
                                   : "; the nearest room is " + room + ", " +
                                         metres(place.distance_m) + " away"));
}

}  // namespace

RouteEnd route_end(const std::string& what, const std::string& word, const Snapshot& building) {
    if (const std::optional<Point> point = as_point(word)) return {what, word, *point, RoomId{}};
    const Room& room = find_room(what, word, building);
    return {what, word, room.label_point, room.id};
}

Cell standing_place(const RouteEnd& end, const Snapshot& building, const RoutePlanner& planner) {
    const std::optional<Cell> cell = planner.standing_place(end.point, kMostMovedM);
    if (!cell) say_why_not(end, building, 2.0 * static_cast<double>(planner.floor().radius_m));
    const Point at = planner.middle_of(*cell);
    const double moved_m = distance(at, end.point);
    if (end.room == RoomId{} && moved_m > planner.floor().resolution_m) {
        print_warnings({end.what + ": " + end.word + ": too near to a wall: " + metres(moved_m) +
                        " beside it, at " + io::rounded(at.x) + "," + io::rounded(at.y) +
                        ", the robot has space"});
    }
    return *cell;
}

}  // namespace quadcut
