// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/device.hpp"
#include "apps/follow_session.hpp"
#include "apps/input_kind.hpp"
#include "apps/log_map.hpp"
#include "apps/message.hpp"
#include "apps/output_folder.hpp"
#include "apps/pace.hpp"
#include "apps/progress.hpp"
#include "apps/run_flags.hpp"
#include "apps/run_output.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "formats/results.hpp"
#include "io/file.hpp"
#include "io/map_server.hpp"
#include "io/no_rooms_in_map.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {
namespace {

/// How the log is played.
struct PlayChoice {
    std::size_t every = 0;
    double speed = 0.0;
};

std::vector<OptionField> play_fields(PlayChoice& choice) {
    std::vector<OptionField> fields;
    fields.push_back({"every", "scans", 0, 1e9, "writes the results so often; 0: at the end", "",
                      &choice.every});
    fields.push_back({"speed", "", 0.0, 1e6,
                      "times as fast as the robot was, no wait above 5 s; 0: as fast as it can", "",
                      &choice.speed});
    return fields;
}

void write(io::FileBatch& output, const FollowSession& session, const Segmentation& rooms,
           const io::RunInfo& info) {
    const Uninterrupted uninterrupted;
    add_followed(output, session.follower().map().to_grid(), rooms, session.updates(), info);
    output.commit();
}

FollowSession begin_session(const Arguments& arguments, const FollowOptions& options,
                            const PosedLog& log) {
    const std::optional<std::string> project = arguments.value("--project");
    if (!project) return {options, log.scans, log.lines};
    store::LogPosition position;
    position.log = io::display_name(arguments.operands[0]);
    position.log_hash = hash_of(log.scans, log.content_hash);
    return {options, log.scans, log.lines,
            open_project(*project, options, position, log.scans.size())};
}

void run(const Arguments& arguments) {
    const auto start = std::chrono::steady_clock::now();
    io::FileBatch output = begin_output(arguments, followed_files());
    FollowOptions options;
    options.resolution_m = resolution_of(arguments).value_or(kLogResolution);
    PlayChoice play;
    std::vector<OptionField> fields = option_fields(options.segment);
    const std::vector<OptionField> more = play_fields(play);
    fields.insert(fields.end(), more.begin(), more.end());
    set_fields(arguments, fields);
    const RunDevice device(arguments, options.segment);
    options.segment.accelerator = device.accelerator();
    Progress progress(progress_style_of(arguments));
    StageClock clock([&progress](std::string_view stage) { progress.begin(stage); });
    clock.begin("read");
    const PosedLog log =
        parse_posed_log(read_log(arguments.operands[0]), poses_of(arguments), options.resolution_m);

    clock.begin("follow");
    io::RunInfo info = run_info_of(options.segment);
    info.input = arguments.operands[0];
    info.input_hash = log.content_hash;
    FollowSession session = begin_session(arguments, options, log);
    const Follower& follower = session.follower();
    Pace pace(play.speed, machine_clock());
    while (!session.is_done()) {
        pace.wait_for(session.next().time_s, [&session] { return session.refine(); });
        session.add_next();
        progress.update(session.num_done(), log.scans.size(),
                        {"scans", [&session] { return session.story(); }});
        if (play.every != 0 && session.num_done() % play.every == 0 && follower.num_rooms() > 0) {
            write(output, session, follower.rooms(), info);
        }
    }
    session.finish();
    if (!follower.map().is_placed()) {
        throw InputError(log.name +
                         ": no reading says anything: expected ranges above 0 that hit something");
    }
    clock.begin("doors");
    std::vector<std::string> warnings = log.warnings;
    for (std::string& warning : session.warnings()) warnings.push_back(std::move(warning));
    Segmentation rooms = followed_rooms(follower, options.segment, std::move(warnings));
    rooms.report.stages_ms = clock.finish();
    progress.begin("write");
    write(output, session, rooms, info);
    progress.wipe();
    print_warnings(rooms.report.warnings);
    if (const auto warning = pace.warning()) print_warnings({*warning});
    device.print_notes(options.segment);
    print_summary({rooms, {}, start, io::display_name(output_folder(arguments)), followed_files()},
                  summary_style_of(arguments));
}

}  // namespace

Command follow_command() {
    SegmentOptions defaults;
    PlayChoice play;
    const std::vector<OptionField> fields = option_fields(defaults);
    const std::vector<OptionField> more = play_fields(play);
    CommandForm form;
    form.name = "follow";
    form.text = "Follows a robot through a laser log (CARMEN): map, rooms and doors, scan by scan.";
    form.operands = {"LOG"};
    form.flags = {
        output_flag(),
        force_flag(),
        resolution_flag(),
        flag_of(more, "every", "N"),
        flag_of(more, "speed", "X"),
        poses_flag(),
        {"--project", "", "FILE", "keeps all in a project file; goes on from there when it exists"},
        flag_of(fields, "door_width", "M"),
        flag_of(fields, "granularity", "G"),
        flag_of(fields, "threads", "N"),
        device_flag(),
        {std::string(kSetFlag), "", "NAME=VALUE",
         "any other option ('quadcut options' lists them); may be repeated"},
        json_flag(),
        quiet_flag()};
    form.settings = names_of(fields);
    for (const std::string& name : names_of(more)) form.settings.push_back(name);
    form.examples = {
        "quadcut follow build/demo/simulation/robot.log -o followed",
        "quadcut follow build/demo/simulation/robot.log -o followed --project home.quadcut"};
    return {form, run};
}

}  // namespace quadcut
