// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/room_choice.hpp"

#include <charconv>
#include <cstdint>
#include <system_error>

#include "io/room_name.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/rooms/describe.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {
namespace {

/// 0: it is no number.
RoomId as_id(const std::string& word) {
    std::uint32_t id = 0;
    const char* const end = word.data() + word.size();
    const auto [read, error] = std::from_chars(word.data(), end, id);
    return error == std::errc() && read == end ? RoomId{id} : RoomId{};
}

RoomId with_given_name(const std::string& name, const Follower& follower) {
    for (const auto& [number, room] : follower.state().rooms) {
        if (room.name == name) return RoomId{number};
    }
    return RoomId{};
}

/// The kind in a default name goes by all rooms around.
RoomId with_default_name(const std::string& name, const Follower& follower) {
    if (room_with_default_name(name) == RoomId{}) return {};
    for (const Room& room : follower.rooms().rooms) {
        if (room.name == name) return room.id;
    }
    return {};
}

}  // namespace

RoomId room_of(const std::string& word, const Follower& follower) {
    const RoomId id = as_id(word);
    const bool is_there = follower.state().rooms.count(static_cast<std::uint32_t>(id)) != 0;
    const std::string name = io::trimmed_room_name(word);
    const RoomId named = with_given_name(name, follower);
    if (is_there && named != RoomId{} && named != id) {
        throw InputError("'" + name + "' is the id of one room and the name of room " +
                         std::to_string(index(named)) + ": expected '" +
                         std::to_string(index(named)) +
                         "' for that one; another name for it makes the other's id free");
    }
    if (is_there) return id;
    if (named != RoomId{}) return named;
    const RoomId by_default = with_default_name(name, follower);
    if (by_default != RoomId{}) return by_default;
    throw InputError("there is no room '" + name + "': expected the id or the name of one of the " +
                     std::to_string(follower.num_rooms()) + " rooms; 'quadcut rooms' lists them");
}

}  // namespace quadcut
