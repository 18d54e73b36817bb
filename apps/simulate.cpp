// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <filesystem>
#include <iostream>
#include <vector>

#include "apps/command.hpp"
#include "apps/output_folder.hpp"
#include "apps/progress.hpp"
#include "apps/run_flags.hpp"
#include "apps/simulated_robot.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "io/file.hpp"
#include "io/json_writer.hpp"
#include "sim/write.hpp"

namespace quadcut {
namespace {

void run(const Arguments& arguments) {
    io::FileBatch output = begin_output(arguments, sim::simulation_files());
    const std::string folder = io::display_name(output_folder(arguments));
    SimulationChoice choice;
    set_fields(arguments, simulation_fields(choice));
    Progress progress(progress_style_of(arguments));
    const Simulation simulation = simulate(choice, progress);
    {
        const Uninterrupted uninterrupted;
        sim::add_simulation(output, simulation.building, simulation.options,
                            simulation.exploration);
        output.commit();
    }
    progress.wipe();
    const std::size_t num_rooms = simulation.building.rooms.size();
    const std::size_t num_doors = simulation.building.doors.size();
    const std::size_t num_scans = simulation.exploration.scans.size();
    const SummaryStyle style = summary_style_of(arguments);
    if (style == SummaryStyle::text) {
        std::cout << num_rooms << " rooms, " << num_doors << " doors; " << num_scans << " scans\n"
                  << files_line(folder, sim::simulation_files());
    }
    if (style == SummaryStyle::json) {
        io::JsonWriter json;
        json.begin_object(io::JsonLayout::lines);
        json.key("num_rooms").integer(num_rooms);
        json.key("num_doors").integer(num_doors);
        json.key("scans").integer(num_scans);
        sim::write_rooms_and_doors(json, simulation.building);
        json.key("output").text(folder);
        json.end_object();
        std::cout << json.finish();
    }
}

}  // namespace

Command simulate_command() {
    SimulationChoice defaults;
    const std::vector<OptionField> fields = simulation_fields(defaults);
    CommandForm form;
    form.name = "simulate";
    form.text = "Draws a building with its truth and the log of a robot that explores it.";
    form.flags = {output_flag(),
                  force_flag(),
                  flag_of(fields, "seed", "S"),
                  flag_of(fields, "rooms", "N"),
                  flag_of(fields, "furniture", "F"),
                  flag_of(fields, "clutter", "C"),
                  json_flag(),
                  quiet_flag()};
    form.examples = {"quadcut simulate -o building --seed 7",
                     "quadcut simulate -o flat --rooms 6 --furniture 1",
                     "quadcut simulate -o office --rooms 24 --clutter 1"};
    return {form, run};
}

}  // namespace quadcut
