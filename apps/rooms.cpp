// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>
#include <memory>

#include "apps/command.hpp"
#include "apps/run_flags.hpp"
#include "apps/summary.hpp"
#include "io/json_writer.hpp"
#include "io/room_list.hpp"
#include "project/building_at.hpp"

namespace quadcut {
namespace {

constexpr std::string_view kAllFlag = "--all";

void run(const Arguments& arguments) {
    const std::shared_ptr<const Snapshot> building =
        building_at(arguments.operands[0], Wanted::rooms_and_doors);
    const Segmentation& rooms = building->rooms();
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
