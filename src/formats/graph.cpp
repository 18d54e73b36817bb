// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "formats/format.hpp"
#include "io/format_version.hpp"
#include "io/json_writer.hpp"
#include "io/room_text.hpp"
#include "io/zone_rooms.hpp"

namespace quadcut::formats {
namespace {

void write_zones(io::JsonWriter& json, const Segmentation& segmentation) {
    json.key("zones").begin_array(io::JsonLayout::lines);
    std::size_t number = 0;
    for (const io::ZoneRooms& zone : io::rooms_by_zone(segmentation)) {
        json.begin_object().key("id").integer(++number).key("area_m2").number(zone.area_m2);
        json.key("rooms").begin_array();
        for (const RoomId room : zone.rooms) json.integer(index(room));
        json.end_array().end_object();
    }
    json.end_array().key("zone_eigenvalues").begin_array();
    for (const double value : segmentation.zones.eigenvalues) json.exact_number(value);
    json.end_array();
}

/// The node-link form: nodes have an id and lie at their room's label point, edges have source and
/// target, two rooms may have several. Metres, map frame.
std::string to_json(const Segmentation& segmentation) {
    io::JsonWriter json;
    json.begin_object(io::JsonLayout::lines);
    json.key("format_version").integer(io::kFormatVersion);
    json.key("frame").text("map");
    json.key("directed").boolean(false);
    json.key("multigraph").boolean(true);
    json.key("nodes").begin_array(io::JsonLayout::lines);
    const Zones& zones = segmentation.zones;
    for (std::size_t i = 0; i < segmentation.rooms.size(); ++i) {
        const Room& room = segmentation.rooms[i];
        json.begin_object();
        json.key("id").integer(index(room.id));
        json.key("name").text(io::name_of(room));
        json.key("kind").text(io::to_text(room.kind));
        json.key("seen").text(io::to_text(room.seen));
        if (room.seen != Seen::whole)
            json.key("open_border").number(room.open_border, io::kShareDecimals);
        json.key("area_m2").number(room.area_m2);
        json.key("x").number(room.label_point.x);
        json.key("y").number(room.label_point.y);
        if (zones.count != 0) json.key("zone").integer(zones.zone_of_room[i]);
        json.end_object();
    }
    json.end_array().key("edges").begin_array(io::JsonLayout::lines);
    for (std::size_t i = 0; i < segmentation.doors.size(); ++i) {
        const Door& door = segmentation.doors[i];
        json.begin_object();
        json.key("id").integer(i + 1);
        json.key("source").integer(index(door.a));
        json.key("target").integer(index(door.b));
        json.key("x").number((door.jamb_1.x + door.jamb_2.x) / 2.0);
        json.key("y").number((door.jamb_1.y + door.jamb_2.y) / 2.0);
        json.key("width_m").number(door.width_m);
        json.key("confidence").number(door.confidence);
        json.key("reason").text(io::reason_of(door));
        json.end_object();
    }
    json.end_array();
    if (zones.count != 0) write_zones(json, segmentation);
    return json.end_object().finish();
}

}  // namespace

Format graph_format() {
    return {"graph",
            "rooms as nodes, doors as edges, as graph libraries read them",
            Part::rooms,
            {"graph.json"},
            [](const Result& result) { return contents(to_json(result.rooms())); }};
}

}  // namespace quadcut::formats
