// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/command_line.hpp"
#include "apps/numbers.hpp"
#include "apps/room_place.hpp"
#include "apps/run_flags.hpp"
#include "io/json_writer.hpp"
#include "io/nearest_word.hpp"
#include "io/number_text.hpp"
#include "io/previous_result.hpp"
#include "project/project.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/map/line_walk.hpp"
#include "quadcut/rooms/describe.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {
namespace {

/// The room that a point is in, or else the nearest one; 0 = there is none.
struct Place {
    RoomId room{};
    std::string name;
    bool is_inside = false;
    double distance_m = 0.0;
};

/// A labelled image, and where it lies.
struct Floor {
    Raster<std::uint16_t> labels;
    std::vector<Room> rooms;
    Pose map_from_image;
    double resolution_m = 0.0;
};

/// How far a point is from the interval at .. at + 1.
double distance_to_cell(double point, std::int32_t at) {
    return std::max({0.0, at - point, point - (at + 1.0)});
}

/// O(cells) outside of rooms.
Place place_on(const Floor& floor, const Point& point) {
    const Point in_map = transform(inverse(floor.map_from_image), point);
    const Point at{in_map.x / floor.resolution_m, in_map.y / floor.resolution_m};
    const Raster<std::uint16_t>& labels = floor.labels;
    const auto place = [&](std::uint16_t label, bool is_inside, double distance_m) {
        const Room& room = floor.rooms[label - std::size_t{1}];
        return Place{room.id, room.name, is_inside, distance_m};
    };
    const bool is_on_map =
        at.x >= 0.0 && at.y >= 0.0 && at.x < labels.width && at.y < labels.height;
    if (is_on_map && labels.at(cell_of(at)) != 0) return place(labels.at(cell_of(at)), true, 0.0);
    double least = std::numeric_limits<double>::infinity();
    std::uint16_t label = 0;
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        if (labels.values[i] == 0) continue;
        const Cell cell = labels.cell(i);
        const double far =
            std::hypot(distance_to_cell(at.x, cell.x), distance_to_cell(at.y, cell.y));
        if (far >= least) continue;
        least = far;
        label = labels.values[i];
    }
    return label == 0 ? Place{} : place(label, false, least * floor.resolution_m);
}

Place locate_in_result(const std::filesystem::path& folder, const Point& point) {
    io::PreviousResult result = io::read_previous_result(folder);
    const io::MapKeys& map = result.legend.map_keys;
    return place_on({std::move(result.labels), std::move(result.legend.rooms), map.map_from_image,
                     map.resolution_m},
                    point);
}

Place locate_in_project(const std::filesystem::path& path, const Point& point) {
    const store::Project project(path, store::Access::read);
    const Follower follower = project.follower();
    const RoomId id = follower.room_at(point);
    if (id != RoomId{}) {
        const std::string& name = follower.state().rooms.at(static_cast<std::uint32_t>(id)).name;
        if (!name.empty()) return {id, name, true, 0.0};
    }
    if (follower.num_rooms() == 0) return {};
    // A default name tells the kind, which goes by all rooms around.
    Segmentation rooms = follower.rooms();
    const GridMap map = follower.map().to_grid();
    return place_on(
        {std::move(rooms.labels), std::move(rooms.rooms), map.map_from_image, map.resolution_m},
        point);
}

void print_as_json(const Place& place) {
    io::JsonWriter json;
    json.begin_object();
    json.key("room").integer(place.is_inside ? index(place.room) : 0);
    json.key("name").text(place.is_inside ? place.name : "");
    if (!place.is_inside && place.room != RoomId{}) {
        json.key("nearest").begin_object();
        json.key("room").integer(index(place.room));
        json.key("name").text(place.name);
        json.key("distance_m").number(place.distance_m).end_object();
    }
    json.end_object();
    std::cout << json.finish();
}

void print_as_text(const Place& place) {
    if (place.room == RoomId{}) {
        std::cout << "no room: there is none on the map\n";
    } else if (!place.is_inside) {
        std::cout << "no room; the nearest is " << index(place.room) << ' ' << place.name << ", "
                  << io::with_decimals(place.distance_m, 2) << " m away\n";
    } else {
        std::cout << index(place.room) << ' ' << place.name << '\n';
    }
}

int answer(const Arguments& arguments) {
    const std::filesystem::path where = arguments.operands[0];
    if (std::filesystem::exists(arguments.operands[2]) && !std::filesystem::exists(where)) {
        const std::vector<std::string> meant{"locate", arguments.operands[2], arguments.operands[0],
                                             arguments.operands[1]};
        throw InputError("the folder or project comes first: " +
                         io::did_you_mean({command_line(meant)}));
    }
    const Point point = point_of(arguments.operands[1], arguments.operands[2]);
    const Place place = room_place_of(where) == RoomPlace::folder ? locate_in_result(where, point)
                                                                  : locate_in_project(where, point);
    if (summary_style_of(arguments) == SummaryStyle::json) {
        print_as_json(place);
    } else {
        print_as_text(place);
    }
    return place.is_inside ? 0 : 1;
}

}  // namespace

Command locate_command() {
    CommandForm form;
    form.name = "locate";
    form.text =
        "Says which room a point is in: metres, map frame. Outside of all rooms it says which is "
        "the nearest and how far, and the exit code is 1.";
    form.operands = {"DIR|PROJECT", "X", "Y"};
    form.flags = {json_flag()};
    form.flags[0].text = "as JSON; room 0: the point is in none, and nearest may follow";
    form.examples = {"quadcut locate build/demo 0.9 0.7",
                     "quadcut locate build/demo/building.quadcut 0.9 0.7 --json"};
    return {form, nullptr, answer};
}

}  // namespace quadcut
