// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/edits.hpp"

#include <stdexcept>
#include <utility>

#include "quadcut/base/error.hpp"
#include "quadcut/rooms/describe.hpp"

namespace quadcut {
namespace {

/// How a room is now, as the beginning of a change.
Reversal as_is(const FollowedMap& followed, RoomId room) {
    Reversal now;
    now.room = room;
    now.settings[static_cast<std::uint32_t>(room)] = followed.rooms.at(existing(followed, room));
    return now;
}

Reversal rename(const FollowedMap& followed, RoomId room, const std::string& name) {
    Reversal change = as_is(followed, room);
    change.settings.begin()->second.name = name;
    RoomId owner = room_with_default_name(name);
    for (const auto& [id, other] : followed.rooms) {
        if (!name.empty() && other.name == name) owner = RoomId{id};
    }
    if (owner != RoomId{} && owner != room) {
        throw InputError("'" + name + "' is the name of " + name_of(owner) +
                         ": expected one that no other room has");
    }
    return change;
}

Reversal merge(const FollowedMap& followed, RoomId room, RoomId other) {
    Reversal change = as_is(followed, room);
    change.other = other;
    change.border = Reversal::Border::join;
    if (room == other) throw InputError("a room cannot be merged with itself");
    std::uint32_t& group = change.settings.begin()->second.merge_group;
    if (group == 0) group = static_cast<std::uint32_t>(room);
    const std::uint32_t other_group = followed.rooms.at(existing(followed, other)).merge_group;
    for (const auto& [id, one] : followed.rooms) {
        if (other_group == 0 || one.merge_group != other_group || RoomId{id} == other) continue;
        change.settings[id] = one;
        change.settings[id].merge_group = group;
    }
    return change;
}

Reversal lock_or_unlock(const FollowedMap& followed, const Edit& edit) {
    const bool is_locked = edit.kind == EditKind::lock;
    Reversal change = as_is(followed, edit.room);
    if (std::exchange(change.settings.begin()->second.is_locked, is_locked) == is_locked) {
        throw InputError(name_of(edit.room) +
                         (is_locked ? " is locked already" : " is not locked"));
    }
    return change;
}

}  // namespace

Reversal change_of(FollowedMap& followed, const Edit& edit) {
    switch (edit.kind) {
        case EditKind::rename:
            return rename(followed, edit.room, edit.name);
        case EditKind::merge:
            return merge(followed, edit.room, edit.other);
        case EditKind::split:
            return change_of_split(followed, edit);
        case EditKind::lock:
        case EditKind::unlock:
            return lock_or_unlock(followed, edit);
    }
    throw std::logic_error("an edit of no kind");
}

std::uint32_t existing(const FollowedMap& followed, RoomId room) {
    const auto number = static_cast<std::uint32_t>(room);
    if (followed.rooms.count(number) == 0) {
        throw InputError("there is no " + name_of(room) + ": expected one of the " +
                         std::to_string(followed.rooms.size()) + " rooms that there are");
    }
    return number;
}

std::string name_of(RoomId room) { return "room " + std::to_string(index(room)); }

Raster<std::uint8_t> mask_of(const FollowedMap& followed, std::uint32_t room) {
    Raster<std::uint8_t> mask(followed.rooms.at(room).box);
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
        mask.values[i] = followed.cells.room(mask.cell(i)) == room ? 1 : 0;
    }
    return mask;
}

}  // namespace quadcut
