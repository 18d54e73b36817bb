// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/device.hpp"
#include "apps/input_kind.hpp"
#include "apps/message.hpp"
#include "apps/output_folder.hpp"
#include "apps/pace.hpp"
#include "apps/progress.hpp"
#include "apps/run_flags.hpp"
#include "apps/run_output.hpp"
#include "apps/second_look.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "formats/registry.hpp"
#include "io/file.hpp"
#include "io/scan_source.hpp"
#include "project/project.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/zones/independence.hpp"

namespace quadcut {
namespace {

/// How the log is played.
struct PlayChoice {
    std::size_t every = 0;
    double speed = 0.0;
};

void add_fields(PlayChoice& choice, std::vector<OptionField>& fields) {
    fields.push_back({"every", "scans", 0, 1e9, "writes the results so often; 0: at the end", "",
                      &choice.every, Decides::run});
    fields.push_back({"speed", "", 0.0, 1e6,
                      "times as fast as the robot was, no wait above 5 s; 0: as fast as it can", "",
                      &choice.speed, Decides::run});
}

void write(io::FileBatch& output, const Snapshot& building, const Segmentation& rooms,
           const io::RunInfo& info) {
    const Uninterrupted uninterrupted;
    add_followed(output, building, rooms, info);
    output.commit();
}

Project begin_project(const Arguments& arguments, const FollowOptions& options,
                      const RunOptions& run, const io::SourceFacts& facts) {
    ScanPosition source;
    source.source = io::display_name(arguments.operands[0]);
    source.source_hash = facts.scans_hash;
    const std::optional<std::string> path = arguments.value("--project");
    return path ? Project::open_or_create(*path, options, source, run)
                : Project::in_memory(options, source, run);
}

std::vector<std::string> all_warnings(const io::SourceFacts& facts, const ScanPosition& position) {
    std::vector<std::string> warnings = facts.warnings;
    for (std::string& warning : warnings_of(position)) warnings.push_back(std::move(warning));
    return warnings;
}

void warn_of_the_ineffective(const SegmentOptions& options) {
    if (options.preset != Preset::rooms || options.paper.num_submaps == 0) return;
    print_warnings(
        {"submaps plays no part while following in the preset rooms: 'quadcut segment "
         "--submaps' cuts the whole map into so many"});
}

void run(const Arguments& arguments) {
    const auto start = std::chrono::steady_clock::now();
    io::FileBatch output = begin_output(arguments, followed_files());
    FollowOptions options;
    RunOptions run_options;
    PlayChoice play;
    set_fields(arguments, option_fields(options, run_options, play));
    const RunDevice device(arguments, run_options.num_threads);
    run_options.accelerator = device.accelerator();
    Progress progress(progress_style_of(arguments));
    StageClock clock([&progress](std::string_view stage) { progress.begin(stage); });
    clock.begin("read");
    const std::unique_ptr<io::ScanSource> source = io::open_scan_source(
        open_log(arguments.operands[0]), {poses_of(arguments), options.resolution_m, {}});
    const io::SourceFacts& facts = source->facts();

    clock.begin("follow");
    io::RunInfo info = run_info_of(options, run_options);
    info.input = arguments.operands[0];
    info.input_hash = facts.content_hash;
    warn_of_the_ineffective(options.segment);
    Project project = begin_project(arguments, options, run_options, facts);
    Pace pace(play.speed, machine_clock());
    io::skip_to(*source, project.position()->num_done);
    while (const std::optional<Scan> scan = source->next()) {
        pace.wait_for(scan->time_s, [&project] { return project.refine(); });
        project.add_next(*scan, source->place());
        const std::size_t num_done = source->num_done();
        progress.update(num_done, facts.num_scans,
                        {"scans", [&] { return num_rooms_text(project.state().num_rooms); }});
        if (play.every != 0 && num_done % play.every == 0 && project.state().num_rooms > 0) {
            const std::shared_ptr<const Snapshot> building = project.snapshot();
            write(output, *building, building->rooms(), info);
        }
    }
    project.finish();
    const std::shared_ptr<const Snapshot> building = project.snapshot();
    if (building->map().states.values.empty()) {
        throw InputError(facts.name +
                         ": no reading says anything: expected ranges above 0 that hit something");
    }
    clock.begin("doors");
    Segmentation rooms =
        followed_rooms(*building, options.segment, all_warnings(facts, *project.position()));
    if (rooms.zones.count != 0) {
        clock.begin("zones");
        const GridMap& map = building->map();
        info.independence = independence_of(
            look_again(*source, map, rooms, options.integrate, run_options), map, rooms);
    }
    rooms.report.stages_ms = clock.finish();
    progress.begin("write");
    write(output, *building, rooms, info);
    progress.wipe();
    print_warnings(rooms.report.warnings);
    if (const auto warning = pace.warning()) print_warnings({*warning});
    device.print_notes(options.segment);
    print_summary({rooms, {}, start, io::display_name(output_folder(arguments)), followed_files()},
                  summary_style_of(arguments));
}

}  // namespace

Command follow_command() {
    FollowOptions defaults;
    RunOptions run_options;
    PlayChoice play;
    const std::vector<OptionField> fields = option_fields(defaults, run_options, play);
    CommandForm form;
    form.name = "follow";
    form.text = "Follows a robot through a laser log (CARMEN): map, rooms and doors, scan by scan.";
    form.operands = {"LOG"};
    form.flags = {
        output_flag(),
        force_flag(),
        flag_of(fields, "resolution", "M"),
        flag_of(fields, "every", "N"),
        flag_of(fields, "speed", "X"),
        poses_flag(),
        {"--project", "", "FILE", "keeps all in a project file; goes on from there when it exists"},
        flag_of(fields, "door_width", "M"),
        flag_of(fields, "granularity", "G"),
        flag_of(fields, "zones", "K"),
        flag_of(fields, "threads", "N"),
        device_flag(),
        set_flag(),
        json_flag(),
        quiet_flag()};
    form.settings = names_of(fields);
    form.examples = {
        "quadcut follow build/demo/simulation/robot.log -o followed",
        "quadcut follow build/demo/simulation/robot.log -o followed --project home.quadcut"};
    return {form, run};
}

}  // namespace quadcut
