// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include "apps/command.hpp"
#include "apps/numbers.hpp"
#include "apps/run_flags.hpp"
#include "io/json_writer.hpp"
#include "io/previous_result.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/segment/describe.hpp"
#include "quadcut/segment/segmentation.hpp"
#include "store/project.hpp"

namespace quadcut {
namespace {

struct Place {
    RoomId room{};
    std::string name;
};

Place locate_in_result(const std::filesystem::path& folder, const Point& point) {
    const io::PreviousResult result = io::read_previous_result(folder);
    const io::MapKeys& map = result.legend.map_keys;
    const Point in_map = transform(inverse(map.map_from_image), point);
    const double x = std::floor(in_map.x / map.resolution_m);
    const double y = std::floor(in_map.y / map.resolution_m);
    const bool is_inside =
        x >= 0.0 && y >= 0.0 && x < result.labels.width && y < result.labels.height;
    if (!is_inside) return {};
    const std::uint16_t label =
        result.labels.at({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)});
    if (label == 0) return {};
    const Room& room = result.legend.rooms[label - 1];
    return {room.id, room.name};
}

Place locate_in_project(const std::filesystem::path& path, const Point& point) {
    const store::Project project(path, store::Access::read);
    const Follower follower = project.follower();
    const RoomId id = follower.room_at(point);
    if (id == RoomId{}) return {};
    const std::string& name = follower.followed().at(static_cast<std::uint32_t>(id)).name;
    if (!name.empty()) return {id, name};
    // A default name tells the kind, which goes by all rooms around.
    for (const Room& room : follower.rooms().rooms) {
        if (room.id == id) return {id, room.name};
    }
    return {id, default_name(RoomKind::unknown, id)};
}

void run(const Arguments& arguments) {
    const std::filesystem::path where = arguments.operands[0];
    const Point point = point_of(arguments.operands[1], arguments.operands[2]);
    const Place place = std::filesystem::is_directory(where) ? locate_in_result(where, point)
                                                             : locate_in_project(where, point);
    if (summary_style_of(arguments) == SummaryStyle::json) {
        io::JsonWriter json;
        json.begin_object();
        json.key("room").integer(index(place.room));
        json.key("name").text(place.name).end_object();
        std::cout << json.finish();
    } else if (place.room == RoomId{}) {
        std::cout << "no room\n";
    } else {
        std::cout << index(place.room) << ' ' << place.name << '\n';
    }
}

}  // namespace

Command locate_command() {
    CommandForm form;
    form.name = "locate";
    form.text = "Says which room a point is in: metres, map frame.";
    form.operands = {"DIR|PROJECT", "X", "Y"};
    form.flags = {json_flag()};
    form.flags[0].text = "as JSON; room 0: the point is in none";
    form.examples = {"quadcut locate build/demo 0.9 0.7",
                     "quadcut locate build/demo 0.9 0.7 --json"};
    return {form, run};
}

}  // namespace quadcut
