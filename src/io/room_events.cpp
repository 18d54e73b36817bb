// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_events.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace quadcut::io {
namespace {

/// How a change is called.
struct Wording {
    RoomChange change;
    const char* key;
    const char* text;
    /// Between the room and the other one.
    const char* other;
};

constexpr std::array<Wording, 4> kWordings{{{RoomChange::born, "new", "new", ""},
                                            {RoomChange::split, "split", "split off", "from"},
                                            {RoomChange::merged, "merged", "merged", "into"},
                                            {RoomChange::gone, "gone", "gone", ""}}};

std::size_t count(std::span<const RoomEvent> events, RoomChange change) {
    return static_cast<std::size_t>(
        std::count_if(events.begin(), events.end(),
                      [change](const RoomEvent& event) { return event.change == change; }));
}

}  // namespace

void write_events(JsonWriter& json, std::span<const RoomEvent> events) {
    json.begin_object(JsonLayout::lines);
    json.key("kept").integer(count(events, RoomChange::kept));
    json.key("events").begin_array(JsonLayout::lines);
    for (const RoomEvent& event : events) {
        const auto* const wording =
            std::find_if(kWordings.begin(), kWordings.end(),
                         [&](const Wording& one) { return one.change == event.change; });
        if (wording == kWordings.end()) continue;
        json.begin_object().key("event").text(wording->key);
        json.key("room").integer(index(event.room)).key("name").text(event.name);
        if (event.other != RoomId{}) json.key(wording->other).integer(index(event.other));
        json.end_object();
    }
    json.end_array().end_object();
}

std::string events_text(std::span<const RoomEvent> events) {
    constexpr std::size_t kMostNamed = 8;
    const std::size_t num_kept = count(events, RoomChange::kept);
    std::string text = std::to_string(num_kept) + (num_kept == 1 ? " room kept" : " rooms kept");
    for (const Wording& wording : kWordings) {
        const std::size_t num_rooms = count(events, wording.change);
        if (num_rooms == 0) continue;
        text += ", " + std::to_string(num_rooms) + " " + wording.text + " (";
        std::size_t num_named = 0;
        for (const RoomEvent& event : events) {
            if (event.change != wording.change) continue;
            if (num_named > 0) text += ", ";
            if (num_named++ == kMostNamed) {
                text += "...";
                break;
            }
            text += std::to_string(index(event.room));
            if (event.other == RoomId{}) continue;
            text += std::string(" ") + wording.other + " " + std::to_string(index(event.other));
        }
        text += ")";
    }
    return text;
}

}  // namespace quadcut::io
