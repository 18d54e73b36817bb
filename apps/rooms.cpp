// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <filesystem>
#include <iostream>

#include "apps/command.hpp"
#include "apps/room_place.hpp"
#include "apps/run_flags.hpp"
#include "apps/summary.hpp"
#include "io/json_writer.hpp"
#include "io/room_list.hpp"
#include "io/stored_result.hpp"
#include "project/project.hpp"

namespace quadcut {
namespace {

constexpr std::string_view kAllFlag = "--all";

Segmentation rooms_of(const std::filesystem::path& where) {
    if (room_place_of(where) == RoomPlace::folder) return io::read_stored_result(where).rooms;
    return store::Project(where, store::Access::read).follower().rooms();
}

void run(const Arguments& arguments) {
    const Segmentation rooms = rooms_of(arguments.operands[0]);
    if (summary_style_of(arguments) == SummaryStyle::json) {
        io::JsonWriter json;
        json.begin_object(io::JsonLayout::lines);
        io::write_rooms_and_doors(json, rooms);
        json.end_object();
        std::cout << json.finish();
        return;
    }
    const bool is_short = is_for_people() && !arguments.has(kAllFlag);
    std::cout << (rooms.rooms.empty()
                      ? "no rooms\n"
                      : io::room_table(rooms, is_short ? kTerminalTable : io::TableLimits{}));
}

}  // namespace

Command rooms_command() {
    CommandForm form;
    form.name = "rooms";
    form.text = "Prints the rooms of a folder of results or of a project, the largest first.";
    form.operands = {"DIR|PROJECT"};
    form.flags = {{std::string(kAllFlag), "", "",
                   "all rooms also on a terminal, where otherwise the largest " +
                       std::to_string(kTerminalTable.rows) + " are shown"},
                  json_flag()};
    form.flags[1].text = "rooms and doors as JSON";
    form.examples = {"quadcut rooms build/demo",
                     "quadcut rooms build/demo/building.quadcut --json"};
    return {form, run};
}

}  // namespace quadcut
