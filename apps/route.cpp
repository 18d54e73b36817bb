// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/map_of_result.hpp"
#include "apps/message.hpp"
#include "apps/numbers.hpp"
#include "apps/route_end.hpp"
#include "io/nearest_word.hpp"
#include "io/number_text.hpp"
#include "io/room_text.hpp"
#include "io/route_text.hpp"
#include "project/building_at.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

constexpr std::string_view kAsFlag = "--as";
constexpr std::string_view kWidthFlag = "--robot-width";
constexpr double kWidestM = 10.0;

/// How a way is written, and that there is none.
struct RouteForm {
    std::string_view name;
    std::string (*route)(const io::WrittenRoute&) = nullptr;
    std::string (*reason)(const io::WrittenReason&) = nullptr;
};
constexpr std::array<RouteForm, 3> kForms{{{"text", io::route_as_text, io::reason_as_text},
                                           {"geojson", io::route_as_geojson, io::reason_as_geojson},
                                           {"json", io::route_as_json, io::reason_as_json}}};

const RouteForm& form_of(const Arguments& arguments) {
    const std::string name = arguments.value(kAsFlag).value_or("text");
    std::vector<std::string_view> names;
    for (const RouteForm& form : kForms) {
        if (form.name == name) return form;
        names.push_back(form.name);
    }
    throw InputError(std::string(kAsFlag) + ": '" + name + "': expected " + io::either_of(names));
}

double width_of(const Arguments& arguments) {
    const std::optional<std::string> word = arguments.value(kWidthFlag);
    if (!word) return kRobotWidthM;
    const double width_m = number_of(*word, std::string(kWidthFlag));
    if (width_m > 0.0 && width_m <= kWidestM) return width_m;
    throw InputError(std::string(kWidthFlag) + ": '" + *word +
                     "': expected metres, more than 0 and at most " + io::rounded(kWidestM));
}

/// The building's map; that of a folder of results is the one that was cut.
GridMap map_of(const std::filesystem::path& where, const Snapshot& building) {
    if (room_place_of(where) == RoomPlace::project) return building.map();
    try {
        io::MapFile file = map_of_result(where, io::read_stored_result(where), std::nullopt);
        print_warnings(file.warnings);
        return std::move(file.map);
    } catch (const InputError& error) {
        print_warnings({std::string(error.what()) + "; the way heeds no furniture within rooms"});
        return building.map();
    }
}

std::string metres(double value) { return io::with_decimals(value, 2) + " m"; }

/// Why there is no way for the robot: there is none at all, or it is too wide for one.
std::string reason_of(const GridMap& map, const Segmentation& rooms, const RouteEnd& from,
                      const RouteEnd& to, double width_m) {
    constexpr int kHalvings = 6;
    std::optional<Route> way;
    double fits_m = 0.0;
    double most_m = width_m;
    for (int i = 0; i <= kHalvings + 1; ++i) {
        const bool is_last = i > kHalvings;
        const double try_m = i == 0 || is_last ? fits_m : (fits_m + most_m) / 2.0;
        RoutePlanner planner(map, rooms, try_m);
        const Cell begin = *planner.standing_place(from.point, kWidestM);
        const Cell end = *planner.standing_place(to.point, kWidestM);
        const bool is_way = planner.is_connected(begin, end);
        if (i == 0 && !is_way) return "no opening leads there";
        (is_way ? fits_m : most_m) = try_m;
        if (is_last) way = planner.find(begin, end);
    }
    std::string reason = "one of " + metres(fits_m) + " gets there";
    const std::vector<Door>& doors = rooms.doors;
    std::optional<std::size_t> narrowest;
    for (const RouteStep& step : way ? way->steps : std::vector<RouteStep>{}) {
        if (step.door && (!narrowest || doors[*step.door].width_m < doors[*narrowest].width_m)) {
            narrowest = step.door;
        }
    }
    if (!narrowest) return reason;
    const Door& door = doors[*narrowest];
    return reason + "; the narrowest door on its way is " + std::to_string(*narrowest + 1) +
           ", between rooms " + std::to_string(index(door.a)) + " and " +
           std::to_string(index(door.b)) + ", " + metres(door.width_m) + " wide";
}

int answer(const Arguments& arguments) {
    const std::filesystem::path where = arguments.operands[0];
    const RouteForm& form = form_of(arguments);
    const double width_m = width_of(arguments);
    const std::shared_ptr<const Snapshot> building = building_at(where, Wanted::rooms_and_doors);
    const RouteEnd from = route_end("FROM", arguments.operands[1], *building);
    const RouteEnd to = route_end("TO", arguments.operands[2], *building);
    const GridMap map = map_of(where, *building);
    RoutePlanner planner(map, building->rooms(), width_m);
    const std::optional<Route> route = planner.find(standing_place(from, *building, planner),
                                                    standing_place(to, *building, planner));
    if (!route) {
        const std::string reason = "no way for a robot " + metres(width_m) + " wide from " +
                                   from.word + " to " + to.word + ": " +
                                   reason_of(map, building->rooms(), from, to, width_m);
        std::cout << form.reason({reason, width_m});
        return 1;
    }
    std::cout << form.route({*route, building->rooms(), map, width_m});
    return 0;
}

}  // namespace

Command route_command() {
    CommandForm form;
    form.name = "route";
    form.text =
        "Finds the shortest way for a robot, over rooms and doors. FROM and TO are points (X,Y: "
        "metres, map frame) or rooms, by id or name. When there is none the exit code is 1.";
    form.operands = {"DIR|PROJECT", "FROM", "TO"};
    form.flags = {{std::string(kAsFlag), "", "FORM",
                   "text: the rooms and doors (default); json: with the points of the way; "
                   "geojson: it as a line"},
                  {std::string(kWidthFlag), "", "M",
                   "how wide the robot is, metres (default " + io::rounded(kRobotWidthM) + ")"}};
    form.examples = {"quadcut route build/demo 0.9,0.7 2",
                     "quadcut route build/demo/building.quadcut 2 4 --as geojson"};
    return {form, nullptr, answer};
}

}  // namespace quadcut
