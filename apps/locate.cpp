// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "apps/command.hpp"
#include "apps/command_line.hpp"
#include "apps/numbers.hpp"
#include "apps/run_flags.hpp"
#include "io/json_writer.hpp"
#include "io/nearest_word.hpp"
#include "io/number_text.hpp"
#include "project/building_at.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

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
    const Place place = building_at(where, Wanted::rooms)->place_of(point);
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
