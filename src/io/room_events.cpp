// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_events.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace quadcut::io {
namespace {

constexpr std::array<const char*, 6> kNames{"kept", "born", "grown", "split", "merged", "retired"};

/// Between the room and the other one.
const char* preposition_of(RoomChange change) {
    return change == RoomChange::split ? "from" : "into";
}

std::size_t count(std::span<const RoomEvent> events, RoomChange change) {
    return static_cast<std::size_t>(
        std::count_if(events.begin(), events.end(),
                      [change](const RoomEvent& event) { return event.change == change; }));
}

}  // namespace

const char* name_of(RoomChange change) { return kNames.at(static_cast<std::size_t>(change)); }

void write_event(JsonWriter& json, const RoomEvent& event) {
    json.begin_object().key("event").text(name_of(event.change));
    json.key("room").integer(index(event.room));
    if (!event.name.empty()) json.key("name").text(event.name);
    if (event.other != RoomId{}) {
        json.key(preposition_of(event.change)).integer(index(event.other));
    }
    json.key("reason").text(event.reason).end_object();
}

void write_events(JsonWriter& json, std::span<const RoomEvent> events) {
    json.begin_object(JsonLayout::lines);
    json.key("kept").integer(count(events, RoomChange::kept));
    json.key("events").begin_array(JsonLayout::lines);
    for (const RoomEvent& event : events) {
        if (event.change != RoomChange::kept) write_event(json, event);
    }
    json.end_array().end_object();
}

std::string events_text(std::span<const RoomEvent> events) {
    constexpr std::size_t kMostNamed = 8;
    const std::size_t num_kept = count(events, RoomChange::kept);
    std::string text = std::to_string(num_kept) + (num_kept == 1 ? " room kept" : " rooms kept");
    for (const RoomChange change : {RoomChange::born, RoomChange::grown, RoomChange::split,
                                    RoomChange::merged, RoomChange::retired}) {
        const std::size_t num_rooms = count(events, change);
        if (num_rooms == 0) continue;
        text += ", " + std::to_string(num_rooms) + " " + name_of(change) + " (";
        std::size_t num_named = 0;
        for (const RoomEvent& event : events) {
            if (event.change != change) continue;
            if (num_named > 0) text += ", ";
            if (num_named++ == kMostNamed) {
                text += "...";
                break;
            }
            text += std::to_string(index(event.room));
            if (event.other == RoomId{}) continue;
            text += std::string(" ") + preposition_of(change) + " " +
                    std::to_string(index(event.other));
        }
        text += ")";
    }
    return text;
}

}  // namespace quadcut::io
