// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/stored_result.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "io/file.hpp"
#include "io/previous_result.hpp"
#include "io/room_places.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

using nlohmann::json;

json parse(std::string_view bytes, const std::string& name) {
    json parsed = json::parse(bytes, nullptr, false);
    if (parsed.is_discarded() || !parsed.is_object()) {
        throw InputError(name + ": is no JSON: expected a file of an earlier result, as it was");
    }
    return parsed;
}

/// Empty when there is no text.
std::string text_at(const json& object, const char* key) {
    const json value = object.value(key, json());
    return value.is_string() ? value.get<std::string>() : "";
}

/// Each feature has a line of its own.
std::vector<std::string> region_lines(std::string_view geojson) {
    std::vector<std::string> regions;
    while (!geojson.empty()) {
        const std::size_t length = std::min(geojson.find('\n'), geojson.size());
        std::string_view line = geojson.substr(0, length);
        geojson.remove_prefix(std::min(length + 1, geojson.size()));
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        if (line.ends_with(',')) line.remove_suffix(1);
        if (!line.starts_with(R"({"type": "Feature", "id": "region-)")) continue;
        if (json::accept(line)) regions.emplace_back(line);
    }
    return regions;
}

/// Of all rooms, by their features; none unless each has one, as they are numbered.
Zones parse_zones(const json& file, const json& report, std::span<const Room> rooms) {
    std::map<RoomId, std::uint32_t> zone_of_room;
    for (const json& feature : file.value("features", json::array())) {
        const json properties = feature.is_object() ? feature.value("properties", json()) : json();
        if (!properties.is_object() || properties.value("type", json()) != "room") continue;
        const json id = properties.value("id", json());
        const json zone = properties.value("zone", json());
        if (!id.is_number_unsigned() || !zone.is_number_unsigned()) return {};
        zone_of_room[RoomId{id.get<std::uint32_t>()}] = zone.get<std::uint32_t>();
    }
    Zones zones;
    for (const Room& room : rooms) {
        const auto found = zone_of_room.find(room.id);
        if (found == zone_of_room.end() || found->second == 0 || found->second > zones.count + 1) {
            return {};
        }
        zones.count = std::max(zones.count, found->second);
        zones.zone_of_room.push_back(found->second);
    }
    const json told = report.is_object() ? report.value("zones", json()) : json();
    const json values = told.is_object() ? told.value("eigenvalues", json()) : json();
    for (const json& value : values) {
        if (value.is_number()) zones.eigenvalues.push_back(value.get<double>());
    }
    return zones;
}

/// What stands at a key of a feature, if it has the type.
class Feature {
public:
    Feature(const json& value, std::string place) : value_(value), place_(std::move(place)) {}

    [[nodiscard]] bool is_door() const {
        const auto properties = value_.find("properties");
        return properties != value_.end() && properties->is_object() &&
               properties->value("type", json()) == "door";
    }
    [[nodiscard]] double number(const char* key) const {
        return finite(value_.at("properties").value(key, json()), key);
    }
    [[nodiscard]] RoomId room(const char* key, const std::map<RoomId, std::size_t>& places) const {
        const double id = number(key);
        const bool is_id = id >= 1.0 && id <= kMaxRoomId && id == std::floor(id);
        if (is_id && places.contains(RoomId{static_cast<std::uint32_t>(id)})) {
            return RoomId{static_cast<std::uint32_t>(id)};
        }
        fail(key, "the id of a room of rooms.yaml");
    }
    /// One of the two ends of its line.
    [[nodiscard]] Point end(std::size_t place) const {
        const json geometry = value_.value("geometry", json());
        const json ends = geometry.is_object() ? geometry.value("coordinates", json()) : json();
        const bool is_line = ends.is_array() && ends.size() == 2;
        if (!is_line || !ends[place].is_array() || ends[place].size() < 2) {
            fail("geometry", "a line of two points");
        }
        return {finite(ends[place][0], "geometry"), finite(ends[place][1], "geometry")};
    }

private:
    [[nodiscard]] double finite(const json& value, const char* key) const {
        if (!value.is_number() || !std::isfinite(value.get<double>())) fail(key, "a number");
        return value.get<double>();
    }
    [[noreturn]] void fail(const std::string& key, const std::string& expected) const {
        throw InputError(place_ + ": " + key + ": expected " + expected +
                         "; `quadcut segment` writes the file anew");
    }

    const json& value_;
    std::string place_;
};

}  // namespace

std::vector<Door> parse_doors(std::string_view bytes, const std::string& name,
                              std::span<const Room> rooms) {
    const std::map<RoomId, std::size_t> places = room_places(rooms);
    const json file = parse(bytes, name);
    const json features = file.value("features", json());
    std::vector<Door> doors;
    for (std::size_t i = 0; i < features.size() && features.is_array(); ++i) {
        const Feature feature(features[i], name + ": feature " + std::to_string(i + 1));
        if (!features[i].is_object() || !feature.is_door()) continue;
        doors.push_back({feature.room("a", places), feature.room("b", places), feature.end(0),
                         feature.end(1), feature.number("width_m"),
                         feature.number("room_a_width_m"), feature.number("room_b_width_m"),
                         feature.number("confidence")});
    }
    return doors;
}

StoredResult read_stored_result(const std::filesystem::path& folder) {
    PreviousResult previous = read_previous_result(folder);
    StoredResult result;
    result.rooms.labels = std::move(previous.labels);
    result.rooms.rooms = std::move(previous.legend.rooms);
    result.rooms.next_id = previous.legend.next_id;
    result.map_keys = std::move(previous.legend.map_keys);
    result.colors = std::move(previous.legend.colors);
    const std::filesystem::path geojson = folder / "rooms.geojson";
    const std::string features = read_file(geojson);
    result.rooms.doors = parse_doors(features, display_name(geojson), result.rooms.rooms);
    result.regions = region_lines(features);
    const std::filesystem::path report = folder / "report.json";
    std::error_code error;
    json told;
    if (std::filesystem::exists(report, error)) {
        told = parse(read_file(report), display_name(report));
        result.input = text_at(told, "input");
        result.input_hash = text_at(told, "input_hash");
        const json options = told.is_object() ? told.value("options", json()) : json();
        for (const auto& [name, value] : options.items()) {
            result.options[name] = value.is_string() ? value.get<std::string>() : value.dump();
        }
    }
    if (features.find(R"("type": "zone")") != std::string::npos) {
        result.rooms.zones =
            parse_zones(parse(features, display_name(geojson)), told, result.rooms.rooms);
    }
    return result;
}

}  // namespace quadcut::io
