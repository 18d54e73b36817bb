// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/summary.hpp"

#include <iostream>

#include "io/json_writer.hpp"
#include "io/number_text.hpp"
#include "io/room_events.hpp"

namespace quadcut {
namespace {

double area_m2(const Segmentation& rooms) {
    double sum = 0.0;
    for (const Room& room : rooms.rooms) sum += room.area_m2;
    return sum;
}

std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void print_text(const Segmentation& rooms, const std::optional<std::vector<RoomEvent>>& events,
                double elapsed_ms, const std::string& folder,
                const std::vector<std::string>& files) {
    std::cout << counted(rooms.rooms.size(), "room") << ", " << counted(rooms.doors.size(), "door")
              << ", " << io::rounded(area_m2(rooms), 1) << " m²; " << io::rounded(elapsed_ms, 0)
              << " ms\n";
    if (events) std::cout << io::events_text(*events) << "\n";
    std::cout << folder << ":";
    for (const std::string& file : files) std::cout << " " << file;
    std::cout << "\n";
}

void print_json(const Segmentation& rooms, const std::optional<std::vector<RoomEvent>>& events,
                double elapsed_ms, const std::string& folder,
                const std::vector<std::string>& files) {
    io::JsonWriter json;
    json.begin_object(io::JsonLayout::lines);
    json.key("rooms").integer(rooms.rooms.size());
    json.key("doors").integer(rooms.doors.size());
    json.key("area_m2").number(area_m2(rooms));
    if (events) {
        json.key("previous");
        io::write_events(json, *events);
    }
    json.key("elapsed_ms").number(elapsed_ms);
    json.key("output").text(folder);
    json.key("files").begin_array();
    for (const std::string& file : files) json.text(file);
    json.end_array();
    json.end_object();
    std::cout << json.finish();
}

}  // namespace

void print_summary(const Segmentation& rooms, const std::optional<std::vector<RoomEvent>>& events,
                   double elapsed_ms, const std::string& folder,
                   const std::vector<std::string>& files, SummaryStyle style) {
    if (style == SummaryStyle::text) print_text(rooms, events, elapsed_ms, folder, files);
    if (style == SummaryStyle::json) print_json(rooms, events, elapsed_ms, folder, files);
}

}  // namespace quadcut
