// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/follow.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "apps/command.hpp"
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
#include "io/updates.hpp"
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

    void wait_for(const Scan& scan, Follower& follower) {
        if (speed_ <= 0.0 || !std::isfinite(scan.time_s)) return;
        if (!is_started_) {
            is_started_ = true;
            start_ = std::chrono::steady_clock::now();
            start_s_ = scan.time_s;
        }
        // Time stamps may run backwards; then nothing is waited for.
        const std::chrono::duration<double> due((scan.time_s - start_s_) / speed_);
        while (std::chrono::steady_clock::now() - start_ + kIdle < due) {
            if (!follower.refine()) break;
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

/// Scans that cannot be used are left out and counted: a robot's log goes on.
class RefusedScans {
public:
    /// The line of updates.jsonl; nothing for a scan that is left out.
    std::string add(const Scan& scan, Follower& follower) {
        try {
            return io::to_json_line(follower.add_scan(scan));
        } catch (const InputError& error) {
            if (count_++ == 0) first_ = error.what();
            return {};
        }
    }
    void warn(std::vector<std::string>& warnings) const {
        if (count_ == 0) return;
        warnings.push_back("scans left out: " + std::to_string(count_) + "; the first: " + first_);
    }

private:
    std::size_t count_ = 0;
    std::string first_;
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
    Progress progress(progress_style_of(arguments));
    StageClock clock([&progress](std::string_view stage) { progress.begin(stage); });
    const PosedLog log = read_posed_log(arguments.operands[0], poses_of(arguments), clock);

    clock.begin("follow");
    io::RunInfo info;
    info.version = QUADCUT_VERSION;
    info.input = arguments.operands[0];
    info.input_hash = log.content_hash;
    info.options = option_fields(options.segment);
    std::erase_if(info.options, [](const OptionField& field) { return field.name == "threads"; });
    info.num_threads = static_cast<int>(options.segment.num_threads);
    Follower follower(options);
    Pace pace(play.speed);
    std::string updates;
    RefusedScans refused;
    for (std::size_t i = 0; i < log.scans.size(); ++i) {
        pace.wait_for(log.scans[i], follower);
        updates += refused.add(log.scans[i], follower);
        progress.update(i + 1, log.scans.size());
        if (play.every != 0 && (i + 1) % play.every == 0 && follower.num_rooms() > 0) {
            write(folder, follower, follower.rooms(), updates, info);
        }
    }
    updates += io::to_json_line(follower.finish());
    if (!follower.map().is_placed()) {
        throw InputError(io::display_name(arguments.operands[0]) +
                         ": no reading says anything: expected ranges above 0 that hit something");
    }
    clock.begin("doors");
    Segmentation rooms = follower.rooms();
    rooms.report.num_leaves = follower.map().num_leaves();
    rooms.report.stages_ms = clock.finish();
    rooms.report.warnings = log.warnings;
    refused.warn(rooms.report.warnings);
    progress.begin("write");
    const std::vector<std::string> files = write(folder, follower, rooms, updates, info);
    progress.wipe();
    print_warnings(rooms.report.warnings);
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
    form.flags = {output_flag(),
                  resolution_flag(),
                  flag_of(more, "every", "N"),
                  flag_of(more, "speed", "X"),
                  poses_flag(),
                  flag_of(fields, "door_width", "M"),
                  flag_of(fields, "granularity", "G"),
                  flag_of(fields, "threads", "N"),
                  {std::string(kSetFlag), "", "NAME=VALUE",
                   "any other option ('quadcut options' lists them); may be repeated"},
                  json_flag(),
                  quiet_flag()};
    form.planned_flags = {"--project"};
    return {form, run};
}

}  // namespace quadcut
