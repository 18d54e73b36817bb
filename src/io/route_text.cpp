// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/route_text.hpp"

#include <cstddef>
#include <cstdint>
#include <map>

#include "io/format_version.hpp"
#include "io/json_writer.hpp"
#include "io/map_frame.hpp"
#include "io/number_text.hpp"
#include "io/room_places.hpp"
#include "io/room_text.hpp"

namespace quadcut::io {
namespace {

class RouteWriter {
public:
    explicit RouteWriter(const WrittenRoute& written)
        : written_(written),
          places_(room_places(written.rooms.rooms)),
          decimals_(MapFrame(written.frame).decimals()) {}

    [[nodiscard]] std::string text() const {
        const Route& route = written_.route;
        const std::size_t num_rooms = route.steps.size() + 1;
        std::string text = with_decimals(route.length_m, 1) + " m through " +
                           std::to_string(num_rooms) + (num_rooms == 1 ? " room\n" : " rooms\n");
        std::uint32_t zone = zone_of(route.first_room);
        text += zone_text(zone) + room_text(route.first_room) + "\n";
        for (const RouteStep& step : route.steps) {
            const std::uint32_t next = zone_of(step.to);
            if (next != zone) text += zone_text(next);
            zone = next;
            text += room_text(step.to) + ", after " + with_decimals(step.after_m, 1) + " m" +
                    door_text(step) + "\n";
        }
        return text;
    }

    [[nodiscard]] std::string json() {
        json_.begin_object(JsonLayout::lines);
        json_.key("format_version").integer(kFormatVersion);
        json_.key("frame").text("map");
        members();
        json_.key("points");
        points();
        return json_.end_object().finish();
    }

    [[nodiscard]] std::string geojson() {
        json_.begin_object(JsonLayout::lines).key("type").text("FeatureCollection");
        json_.key("format_version").integer(kFormatVersion);
        json_.key("frame").text("map");
        json_.key("features").begin_array(JsonLayout::lines);
        json_.begin_object().key("type").text("Feature").key("id").text("route");
        json_.key("properties").begin_object().key("type").text("route");
        members();
        json_.end_object().key("geometry").begin_object().key("type").text("LineString");
        json_.key("coordinates");
        points();
        json_.end_object().end_object();
        return json_.end_array().end_object().finish();
    }

private:
    [[nodiscard]] const Room& room(RoomId id) const { return written_.rooms.rooms[places_.at(id)]; }
    /// 0: there are no zones.
    [[nodiscard]] std::uint32_t zone_of(RoomId id) const {
        const Zones& zones = written_.rooms.zones;
        return zones.count == 0 ? 0 : zones.zone_of_room[places_.at(id)];
    }
    [[nodiscard]] static std::string zone_text(std::uint32_t zone) {
        return zone == 0 ? "" : "zone " + std::to_string(zone) + "\n";
    }
    [[nodiscard]] std::string room_text(RoomId id) const {
        return std::to_string(index(id)) + " " + name_of(room(id));
    }
    [[nodiscard]] std::string door_text(const RouteStep& step) const {
        if (!step.door) return "";
        return " by door " + std::to_string(*step.door + 1) + ", " +
               with_decimals(written_.rooms.doors[*step.door].width_m, 2) + " m wide";
    }

    void members() {
        json_.key("robot_width_m").number(written_.robot_width_m);
        json_.key("length_m").number(written_.route.length_m);
        json_.key("rooms").begin_array();
        member(written_.route.first_room);
        for (const RouteStep& step : written_.route.steps) member(step.to);
        json_.end_array();
        json_.key("doors").begin_array();
        for (const RouteStep& step : written_.route.steps) member(step);
        json_.end_array();
    }
    void member(RoomId id) {
        json_.begin_object().key("id").integer(index(id));
        json_.key("name").text(name_of(room(id)));
        if (zone_of(id) != 0) json_.key("zone").integer(zone_of(id));
        json_.end_object();
    }
    /// What has no door keeps its place with null.
    void member(const RouteStep& step) {
        json_.begin_object().key("id");
        if (step.door) {
            json_.integer(*step.door + 1);
        } else {
            json_.null();
        }
        json_.key("from").integer(index(step.from));
        json_.key("to").integer(index(step.to));
        json_.key("after_m").number(step.after_m);
        json_.key("x").number(step.at.x, decimals_);
        json_.key("y").number(step.at.y, decimals_).end_object();
    }

    void points() {
        json_.begin_array();
        for (const Point& at : written_.route.points) {
            json_.begin_array().number(at.x, decimals_).number(at.y, decimals_).end_array();
        }
        json_.end_array();
    }

    const WrittenRoute& written_;
    std::map<RoomId, std::size_t> places_;
    int decimals_;
    JsonWriter json_;
};

}  // namespace

std::string route_as_text(const WrittenRoute& written) { return RouteWriter(written).text(); }
std::string route_as_json(const WrittenRoute& written) { return RouteWriter(written).json(); }
std::string route_as_geojson(const WrittenRoute& written) { return RouteWriter(written).geojson(); }

std::string reason_as_text(const WrittenReason& written) { return written.reason + "\n"; }

std::string reason_as_json(const WrittenReason& written) {
    JsonWriter json;
    json.begin_object(JsonLayout::lines);
    json.key("format_version").integer(kFormatVersion);
    json.key("frame").text("map");
    json.key("robot_width_m").number(written.robot_width_m);
    json.key("length_m").null();
    json.key("reason").text(written.reason);
    return json.end_object().finish();
}

std::string reason_as_geojson(const WrittenReason& written) {
    JsonWriter json;
    json.begin_object(JsonLayout::lines).key("type").text("FeatureCollection");
    json.key("format_version").integer(kFormatVersion);
    json.key("frame").text("map");
    json.key("reason").text(written.reason);
    return json.key("features").begin_array().end_array().end_object().finish();
}

}  // namespace quadcut::io
