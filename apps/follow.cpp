// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/device.hpp"
#include "apps/follow_session.hpp"
#include "apps/log_map.hpp"
#include "apps/message.hpp"
#include "apps/output_folder.hpp"
#include "apps/progress.hpp"
#include "apps/run_flags.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "io/file.hpp"
#include "io/map_server.hpp"
#include "io/results.hpp"
#include "quadcut/base/error.hpp"
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
    fields.push_back({"speed", "", 0.0, 1e6, "times as fast as the robot was; 0: as fast as it can",
                      "", &choice.speed});
    return fields;
}

/// Waits until a scan is due, and refines rooms meanwhile.
class Pace {
public:
    explicit Pace(double speed) : speed_(speed) {}

    void wait_for_next(FollowSession& session) {
        const Scan& scan = session.next();
        if (speed_ <= 0.0 || !std::isfinite(scan.time_s)) return;
        if (!is_started_) {
            is_started_ = true;
            start_ = std::chrono::steady_clock::now();
            start_s_ = scan.time_s;
        }
        // Time stamps may run backwards; then nothing is waited for.
        const std::chrono::duration<double> due((scan.time_s - start_s_) / speed_);
        while (std::chrono::steady_clock::now() - start_ + kIdle < due) {
            if (!session.refine()) break;
        }
        std::this_thread::sleep_until(start_ +
                                      std::chrono::duration_cast<std::chrono::nanoseconds>(due));
    }

private:
    /// A refinement may take so long.
    static constexpr std::chrono::milliseconds kIdle{200};

    double speed_;
    bool is_started_ = false;
    std::chrono::steady_clock::time_point start_;
    double start_s_ = 0.0;
};

std::vector<std::string> write(const std::filesystem::path& folder, const Follower& follower,
                               const Segmentation& rooms, const std::string& updates,
                               const io::RunInfo& info) {
    const Uninterrupted uninterrupted;
    const GridMap map = follower.map().to_grid();
    io::write_map(folder, map);
    io::write_results(folder, map, rooms, info);
    io::write_file_atomically(folder / "updates.jsonl", updates);
    return {"rooms_color.png", "rooms.svg",   "rooms.png", "rooms.yaml", "rooms.geojson",
            "graph.json",      "report.json", "map.pgm",   "map.yaml",   "updates.jsonl"};
}

FollowSession begin_session(const Arguments& arguments, const FollowOptions& options,
                            const PosedLog& log) {
    const std::optional<std::string> project = arguments.value("--project");
    if (!project) return {options, log.scans, log.lines};
    store::LogPosition position;
    position.log = io::display_name(arguments.operands[0]);
    position.log_hash = hash_of(log.scans, log.content_hash);
    return {options, log.scans, log.lines, position, *project};
}

void run(const Arguments& arguments) {
    const auto start = std::chrono::steady_clock::now();
    const std::filesystem::path folder = output_folder(arguments);
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
    const PosedLog log =
        read_posed_log(arguments.operands[0], poses_of(arguments), options.resolution_m, clock);

    clock.begin("follow");
    io::RunInfo info;
    info.version = QUADCUT_VERSION;
    info.input = arguments.operands[0];
    info.input_hash = log.content_hash;
    info.options = option_fields(options.segment);
    std::erase_if(info.options, [](const OptionField& field) { return field.name == "threads"; });
    info.num_threads = static_cast<int>(options.segment.num_threads);
    FollowSession session = begin_session(arguments, options, log);
    const Follower& follower = session.follower();
    Pace pace(play.speed);
    while (!session.is_done()) {
        pace.wait_for_next(session);
        session.add_next();
        progress.update(session.num_done(), log.scans.size(), [&] { return session.story(); });
        if (play.every != 0 && session.num_done() % play.every == 0 && follower.num_rooms() > 0) {
            write(folder, follower, follower.rooms(), session.updates(), info);
        }
    }
    session.finish();
    if (!follower.map().is_placed()) {
        throw InputError(io::display_name(arguments.operands[0]) +
                         ": no reading says anything: expected ranges above 0 that hit something");
    }
    clock.begin("doors");
    Segmentation rooms = follower.rooms();
    rooms.report.num_leaves = follower.map().num_leaves();
    rooms.report.stages_ms = clock.finish();
    rooms.report.warnings = log.warnings;
    for (std::string& warning : session.warnings()) {
        rooms.report.warnings.push_back(std::move(warning));
    }
    progress.begin("write");
    const std::vector<std::string> files = write(folder, follower, rooms, session.updates(), info);
    progress.wipe();
    print_warnings(rooms.report.warnings);
    device.print_notes(options.segment);
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    print_summary(rooms, std::nullopt, elapsed.count(), io::display_name(folder), files,
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
    return {form, run};
}

}  // namespace quadcut
