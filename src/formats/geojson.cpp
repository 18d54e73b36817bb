// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "formats/format.hpp"
#include "io/format_version.hpp"
#include "io/json_writer.hpp"
#include "io/map_frame.hpp"
#include "io/number_text.hpp"
#include "io/outline.hpp"
#include "io/room_places.hpp"
#include "io/room_text.hpp"
#include "io/smooth_outline.hpp"
#include "io/zone_rooms.hpp"

namespace quadcut::formats {
namespace {

/// So that whoever reads a width and rounds it for people gets what is io::rounded here.
constexpr int kWidthDecimals = 9;

/// The connected parts of each region 1 .. count, in order of regions.
std::vector<std::vector<io::RegionOutline>> trace_regions(const Raster<std::uint16_t>& labels,
                                                          std::size_t count) {
    std::vector<std::vector<io::RegionOutline>> parts(count);
    for (io::RegionOutline& outline : io::trace_outlines(labels)) {
        parts.at(outline.value - 1).push_back(std::move(outline));
    }
    return parts;
}

/// Ids, in order of rooms.
std::vector<std::set<RoomId>> find_neighbours(const Segmentation& segmentation,
                                              std::span<const io::RoomPair> pairs) {
    const std::vector<Room>& rooms = segmentation.rooms;
    std::vector<std::set<RoomId>> neighbours(rooms.size());
    const auto join = [&](std::size_t a, std::size_t b) {
        neighbours.at(a).insert(rooms.at(b).id);
        neighbours.at(b).insert(rooms.at(a).id);
    };
    for (const io::RoomPair& pair : pairs) {
        if (pair.closeness == io::Closeness::touching) join(pair.a - 1U, pair.b - 1U);
    }
    const std::map<RoomId, std::size_t> places = io::room_places(rooms);
    for (const Door& door : segmentation.doors) join(places.at(door.a), places.at(door.b));
    return neighbours;
}

class FeatureWriter {
public:
    FeatureWriter(io::JsonWriter& json, const GridMap& map)
        : json_(json), frame_(map), decimals_(frame_.decimals()), resolution_m_(map.resolution_m) {}

    void room(const Room& room, const std::vector<io::RegionOutline>& parts,
              const std::set<RoomId>& neighbours, io::Rgb color, std::uint32_t zone) {
        json_.begin_object().key("type").text("Feature");
        json_.key("id").text("room-" + std::to_string(index(room.id)));
        json_.key("properties").begin_object();
        json_.key("type").text("room");
        json_.key("id").integer(index(room.id));
        json_.key("name").text(io::name_of(room));
        json_.key("kind").text(io::to_text(room.kind));
        json_.key("seen").text(io::to_text(room.seen));
        if (room.seen != Seen::whole)
            json_.key("open_border").number(room.open_border, io::kShareDecimals);
        json_.key("area_m2").number(room.area_m2);
        json_.key("perimeter_m").number(perimeter_m(parts));
        json_.key("label_point");
        point(room.label_point);
        json_.key("neighbours").begin_array();
        for (const RoomId neighbour : neighbours) json_.integer(index(neighbour));
        json_.end_array();
        if (zone != 0) json_.key("zone").integer(zone);
        json_.key("color").text(io::to_hex(color));
        json_.end_object();
        json_.key("geometry");
        geometry(parts);
        json_.end_object();
    }

    void zone(const io::ZoneRooms& zone, std::size_t number,
              const std::vector<io::RegionOutline>& parts) {
        json_.begin_object().key("type").text("Feature");
        json_.key("id").text("zone-" + std::to_string(number));
        json_.key("properties").begin_object();
        json_.key("type").text("zone");
        json_.key("id").integer(number);
        json_.key("area_m2").number(zone.area_m2);
        json_.key("rooms").begin_array();
        for (const RoomId room : zone.rooms) json_.integer(index(room));
        json_.end_array().end_object();
        json_.key("geometry");
        geometry(parts);
        json_.end_object();
    }

    void door(const Door& door, std::size_t id) {
        json_.begin_object().key("type").text("Feature");
        json_.key("id").text("door-" + std::to_string(id));
        json_.key("properties").begin_object();
        json_.key("type").text("door");
        json_.key("id").integer(id);
        json_.key("a").integer(index(door.a));
        json_.key("b").integer(index(door.b));
        json_.key("width_m").number(door.width_m);
        json_.key("room_a_width_m").number(door.room_a_width_m, kWidthDecimals);
        json_.key("room_b_width_m").number(door.room_b_width_m, kWidthDecimals);
        json_.key("confidence").number(door.confidence);
        json_.key("reason").text(io::reason_of(door));
        json_.end_object();
        json_.key("geometry").begin_object().key("type").text("LineString");
        json_.key("coordinates").begin_array();
        point(door.jamb_1);
        point(door.jamb_2);
        json_.end_array().end_object().end_object();
    }

    /// A region of another granularity, and the rooms that it shares floor with.
    void region(double granularity, std::size_t number, const std::set<std::size_t>& rooms,
                const std::vector<io::RegionOutline>& parts) {
        json_.begin_object().key("type").text("Feature");
        json_.key("id").text("region-" + io::rounded(granularity, 1) + "-" +
                             std::to_string(number));
        json_.key("properties").begin_object();
        json_.key("type").text("region");
        json_.key("granularity").number(granularity);
        json_.key("id").integer(number);
        json_.key("rooms").begin_array();
        for (const std::size_t room : rooms) json_.integer(room);
        json_.end_array().end_object();
        json_.key("geometry");
        geometry(parts);
        json_.end_object();
    }

private:
    void point(const Point& point) {
        json_.begin_array().number(point.x, decimals_).number(point.y, decimals_).end_array();
    }

    void geometry(const std::vector<io::RegionOutline>& parts) {
        if (parts.empty()) {
            json_.null();
            return;
        }
        const bool several = parts.size() > 1;
        json_.begin_object().key("type").text(several ? "MultiPolygon" : "Polygon");
        json_.key("coordinates");
        if (several) json_.begin_array();
        for (const io::RegionOutline& part : parts) {
            json_.begin_array();
            for (const io::OutlineRing& line : part.rings) ring(io::corners_of(line));
            json_.end_array();
        }
        if (several) json_.end_array();
        json_.end_object();
    }

    void ring(const std::vector<Cell>& corners) {
        json_.begin_array();
        for (const Cell corner : corners) point(frame_.corner(corner));
        point(frame_.corner(corners.front()));
        json_.end_array();
    }

    [[nodiscard]] double perimeter_m(const std::vector<io::RegionOutline>& parts) const {
        double cells = 0.0;
        for (const io::RegionOutline& part : parts) {
            cells += io::length_cells(io::smooth_ring(part.rings.front()));
        }
        return cells * resolution_m_;
    }

    io::JsonWriter& json_;
    io::MapFrame frame_;
    int decimals_;
    double resolution_m_;
};

/// The rooms, by id, that share floor with each region of the finest level, from 1 on.
std::vector<std::set<std::size_t>> rooms_of_finest(const Segmentation& segmentation) {
    std::vector<std::set<std::size_t>> rooms;
    const Raster<std::uint16_t>& finest = segmentation.hierarchy.finest;
    for (std::size_t i = 0; i < finest.values.size(); ++i) {
        const std::size_t label = segmentation.labels.values[i];
        if (finest.values[i] == 0 || label == 0) continue;
        if (finest.values[i] >= rooms.size()) rooms.resize(finest.values[i] + std::size_t{1});
        rooms[finest.values[i]].insert(index(segmentation.rooms[label - 1].id));
    }
    return rooms;
}

void write_zones(const Segmentation& segmentation, FeatureWriter& features) {
    const std::vector<io::ZoneRooms> zones = io::rooms_by_zone(segmentation);
    if (zones.empty()) return;
    Raster<std::uint16_t> labels = segmentation.labels;
    for (std::uint16_t& label : labels.values) {
        if (label == 0) continue;
        const std::uint32_t zone = segmentation.zones.zone_of_room[label - std::size_t{1}];
        label = static_cast<std::uint16_t>(zone);
    }
    const auto parts = trace_regions(labels, zones.size());
    for (std::size_t i = 0; i < zones.size(); ++i) features.zone(zones[i], i + 1, parts[i]);
}

void write_hierarchy(const Segmentation& segmentation, FeatureWriter& features) {
    const std::vector<std::set<std::size_t>> finest_rooms = rooms_of_finest(segmentation);
    for (const HierarchyLevel& level : segmentation.hierarchy.levels) {
        Raster<std::uint16_t> labels = segmentation.hierarchy.finest;
        for (std::uint16_t& label : labels.values) {
            if (label != 0) label = level.region_of_finest[label - std::size_t{1}];
        }
        std::vector<std::set<std::size_t>> rooms(level.num_regions);
        for (std::size_t i = 1; i < finest_rooms.size(); ++i) {
            rooms[level.region_of_finest[i - 1] - std::size_t{1}].insert(finest_rooms[i].begin(),
                                                                         finest_rooms[i].end());
        }
        const auto parts = trace_regions(labels, level.num_regions);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            features.region(level.granularity, i + 1, rooms[i], parts[i]);
        }
    }
}

/// Rooms and doors as a FeatureCollection in metres of the map frame ("frame": "map" says so), one
/// feature a line. Rooms are exact: the outlines run along cell edges, so that they have the area
/// that is given and neighbours meet without gap or overlap; outer rings counter-clockwise, holes
/// clockwise. A room in several parts is a MultiPolygon. Doors are the lines of the cuts;
/// zones, made of rooms, and the hierarchy's regions follow. `neighbours` are the rooms that touch
/// or share a door; `perimeter_m` is the length of the outer outline with its stairs smoothed.
/// O(cells).
std::string to_geojson(const Result& result) {
    const Segmentation& segmentation = result.rooms();
    const std::vector<std::vector<io::RegionOutline>> parts =
        trace_regions(segmentation.labels, segmentation.rooms.size());
    const std::vector<std::set<RoomId>> neighbours =
        find_neighbours(segmentation, result.near_rooms());
    io::JsonWriter json;
    json.begin_object(io::JsonLayout::lines).key("type").text("FeatureCollection");
    json.key("format_version").integer(io::kFormatVersion);
    json.key("frame").text("map");
    json.key("features").begin_array(io::JsonLayout::lines);
    FeatureWriter features(json, result.map());
    for (std::size_t i = 0; i < segmentation.rooms.size(); ++i) {
        const std::uint32_t zone =
            segmentation.zones.count == 0 ? 0 : segmentation.zones.zone_of_room[i];
        features.room(segmentation.rooms[i], parts[i], neighbours[i], result.colors()[i], zone);
    }
    for (std::size_t i = 0; i < segmentation.doors.size(); ++i) {
        features.door(segmentation.doors[i], i + 1);
    }
    write_zones(segmentation, features);
    write_hierarchy(segmentation, features);
    for (const std::string& region : result.info().regions) json.verbatim(region);
    return json.end_array().end_object().finish();
}

}  // namespace

Format geojson_format() {
    return {"geojson",
            "outlines of rooms and lines of doors",
            Part::rooms,
            {"rooms.geojson"},
            [](const Result& result) { return contents(to_geojson(result)); }};
}

}  // namespace quadcut::formats
