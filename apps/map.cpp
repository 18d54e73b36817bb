// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>

#include "apps/command.hpp"
#include "apps/input_kind.hpp"
#include "apps/message.hpp"
#include "apps/output_folder.hpp"
#include "apps/progress.hpp"
#include "apps/run_flags.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "formats/registry.hpp"
#include "io/file.hpp"
#include "io/json_writer.hpp"
#include "io/map_writer.hpp"
#include "io/number_text.hpp"
#include "io/scan_source.hpp"
#include "io/scanned_map.hpp"
#include "quadcut/base/stage_clock.hpp"

namespace quadcut {
namespace {

double area_m2(const GridMap& map, CellState state) {
    const auto& cells = map.states.values;
    const auto count = std::count(cells.begin(), cells.end(), state);
    return static_cast<double>(count) * map.resolution_m * map.resolution_m;
}

struct MapSummary {
    double free_m2 = 0.0;
    double occupied_m2 = 0.0;
    double elapsed_ms = 0.0;
    std::string folder;
};

void print_text(const io::ScannedMap& log, const MapSummary& summary) {
    const GridMap& map = log.map;
    std::cout << log.trajectory.size() << " scans, " << map.states.width << " x "
              << map.states.height << " cells of " << io::rounded(map.resolution_m) << " m, "
              << io::rounded(summary.free_m2, 1) << " m² free, " << log.num_leaves << " leaves; "
              << io::rounded(summary.elapsed_ms, 0) << " ms\n"
              << files_line(summary.folder, io::map_files());
}

void print_json(const io::ScannedMap& log, const MapSummary& summary) {
    io::JsonWriter json;
    json.begin_object(io::JsonLayout::lines);
    json.key("scans").integer(log.trajectory.size());
    json.key("width").integer(static_cast<std::uint64_t>(log.map.states.width));
    json.key("height").integer(static_cast<std::uint64_t>(log.map.states.height));
    json.key("resolution").number(log.map.resolution_m);
    json.key("free_m2").number(summary.free_m2);
    json.key("occupied_m2").number(summary.occupied_m2);
    json.key("num_leaves").integer(log.num_leaves);
    json.key("elapsed_ms").number(summary.elapsed_ms);
    json.key("output").text(summary.folder);
    json.end_object();
    std::cout << json.finish();
}

void run(const Arguments& arguments) {
    io::FileBatch output = begin_output(arguments, io::map_files());
    IntegrateOptions integrate;
    set_fields(arguments, option_fields(integrate));
    const double resolution_m = resolution_of(arguments).value_or(kLogResolution);
    Progress progress(progress_style_of(arguments));
    StageClock clock([&progress](std::string_view stage) { progress.begin(stage); });

    clock.begin("read");
    const auto source = io::open_scan_source(open_log(arguments.operands[0]),
                                             {poses_of(arguments), resolution_m, {}});
    clock.begin("map");
    const io::ScannedMap log =
        io::map_scans(*source, resolution_m, integrate, [&](std::size_t num_done) {
            progress.update(num_done, source->facts().num_scans, {"scans", {}});
        });
    clock.begin("write");
    {
        const Uninterrupted uninterrupted;
        io::add_map(output, log.map);
        output.commit();
    }
    MapSummary summary{area_m2(log.map, CellState::free), area_m2(log.map, CellState::occupied),
                       0.0, io::display_name(output_folder(arguments))};
    for (const auto& [stage, ms] : clock.finish()) summary.elapsed_ms += ms;

    progress.wipe();
    print_warnings(source->facts().warnings);
    const SummaryStyle style = summary_style_of(arguments);
    if (style == SummaryStyle::text) print_text(log, summary);
    if (style == SummaryStyle::json) print_json(log, summary);
}

}  // namespace

Command map_command() {
    CommandForm form;
    form.name = "map";
    form.text =
        "Makes a map of a laser log (CARMEN, plain or .gz; '-' is standard input): map.pgm and "
        "map.yaml.";
    form.operands = {"LOG"};
    form.flags = {output_flag(), force_flag(), resolution_flag(), poses_flag(),
                  set_flag(),    json_flag(),  quiet_flag()};
    IntegrateOptions defaults;
    form.settings = names_of(option_fields(defaults));
    form.examples = {"quadcut map build/demo/simulation/robot.log -o map",
                     "quadcut map build/demo/simulation/robot.log -o true_map --poses "
                     "build/demo/simulation/true_poses.tum"};
    return {form, run};
}

}  // namespace quadcut
