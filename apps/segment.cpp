// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/segment.hpp"

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
#include "apps/progress.hpp"
#include "apps/run_flags.hpp"
#include "apps/run_output.hpp"
#include "apps/second_look.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "formats/registry.hpp"
#include "io/file.hpp"
#include "io/map_server.hpp"
#include "io/no_rooms.hpp"
#include "io/no_rooms_in_map.hpp"
#include "io/poses.hpp"
#include "io/previous_result.hpp"
#include "io/scan_source.hpp"
#include "io/scanned_map.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/follow/track.hpp"
#include "quadcut/segment/inside.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/zones/independence.hpp"
#include "quadcut/zones/submaps.hpp"
#include "quadcut/zones/zones.hpp"

namespace quadcut {
namespace {

constexpr std::string_view kPreviousFlag = "--previous";
constexpr std::string_view kHierarchyFlag = "--hierarchy";

/// What is cut, whether it came as a map or as a log.
struct Input {
    GridMap map;
    io::MapKeys keys;
    std::vector<Point> trajectory;
    std::vector<std::string> warnings;
    /// Of a map: what its greys say of why it may have no rooms.
    std::string why_no_rooms;
    std::uint64_t content_hash = 0;
    /// Of a log.
    std::unique_ptr<io::ScanSource> scans;
};

Input input_of_log(const Arguments& arguments, io::Input file, const IntegrateOptions& integrate,
                   StageClock& clock, Progress& progress) {
    const double resolution_m = resolution_of(arguments).value_or(kLogResolution);
    std::unique_ptr<io::ScanSource> source =
        io::open_scan_source(std::move(file), {poses_of(arguments), resolution_m, {}});
    const io::SourceFacts& facts = source->facts();
    clock.begin("map");
    io::ScannedMap scanned =
        io::map_scans(*source, resolution_m, integrate, [&](std::size_t num_done) {
            progress.update(num_done, facts.num_scans, {"scans", {}});
        });
    Input input;
    input.map = std::move(scanned.map);
    input.trajectory = std::move(scanned.trajectory);
    input.warnings = facts.warnings;
    input.content_hash = facts.content_hash;
    input.scans = std::move(source);
    if (has_grey_flag(arguments)) {
        input.warnings.emplace_back(
            "--free-thresh, --occupied-thresh, --negate and --trust-yaml play no part for a log");
    }
    return input;
}

Input input_of_map(const Arguments& arguments, io::Input bytes,
                   const std::vector<std::string>& files, io::FileBatch& output) {
    io::MapFile file = io::parse_map(std::move(bytes).read_all(), map_read_options_of(arguments));
    output.protect(file.image_path);
    output.require_free(files);
    Input input;
    input.why_no_rooms = io::why_no_rooms(file.greys, file.keys);
    input.map = std::move(file.map);
    input.keys = std::move(file.keys);
    input.warnings = std::move(file.warnings);
    input.content_hash = file.content_hash;
    if (has_scan_setting(arguments)) {
        input.warnings.emplace_back("options of scans play no part for a map");
    }
    if (const auto poses = poses_of(arguments)) {
        for (const io::TimedPose& pose : io::read_poses(*poses)) {
            input.trajectory.push_back({pose.pose.x, pose.pose.y});
        }
    }
    return input;
}

/// As many submaps as were asked for are all shown, whether the log's own trajectory crosses them
/// or not; poses that are given with --poses still say what is inside.
void keep_the_number(const Arguments& arguments, const SegmentOptions& options, Input& input) {
    const bool is_own = input.scans && !poses_of(arguments);
    if (is_own && options.preset == Preset::paper && options.paper.num_submaps != 0) {
        input.trajectory.clear();
    }
}

/// What was asked for and plays no part.
void warn_of_the_ineffective(const SegmentOptions& options, Input& input) {
    if (options.preset == Preset::paper && options.with_hierarchy) {
        input.warnings.emplace_back("--hierarchy plays no part in the preset paper");
    }
    if (!input.trajectory.empty() && visited_cells(input.map, input.trajectory).empty()) {
        input.warnings.push_back("none of the " + std::to_string(input.trajectory.size()) +
                                 " poses lies in the map");
    }
}

void write(io::FileBatch& output, const formats::Formats& formats, const Input& input,
           const Segmentation& rooms, const io::RunInfo& info) {
    const Uninterrupted uninterrupted;
    formats::add_files(output, formats, {input.map, rooms, info});
    output.commit();
}

/// What the run will write: the map, too, when it is made of a log.
formats::Formats formats_for(io::FileKind kind) {
    using formats::Part;
    return kind == io::FileKind::laser_log
               ? formats::formats_of({Part::rooms, Part::report, Part::map})
               : formats::formats_of({Part::rooms, Part::report});
}

/// The result whose ids and names are kept; read first, since the new one may take its place.
std::optional<io::PreviousResult> read_previous(const Arguments& arguments, StageClock& clock) {
    const std::optional<std::string> folder = arguments.value(kPreviousFlag);
    if (!folder) return std::nullopt;
    clock.begin("previous");
    return io::read_previous_result(*folder);
}

/// They on the cells of the map that is cut now.
EarlierRooms earlier_rooms(const std::optional<io::PreviousResult>& previous, Input& input) {
    if (!previous) return {};
    io::PlacedRooms placed = io::place_on_map(*previous, input.map);
    input.warnings.insert(input.warnings.end(), placed.warnings.begin(), placed.warnings.end());
    return std::move(placed.rooms);
}

/// What became of the rooms of an earlier result, whose ids and names the rooms get.
std::vector<RoomEvent> recognise(const EarlierRooms& earlier, StageClock& clock,
                                 Segmentation& rooms) {
    clock.begin("track");
    Tracked tracked = track(rooms, earlier);
    rooms = std::move(tracked.segmentation);
    const bool is_any_kept =
        std::any_of(tracked.events.begin(), tracked.events.end(),
                    [](const RoomEvent& event) { return event.change == RoomChange::kept; });
    if (!is_any_kept && !rooms.rooms.empty() && !earlier.rooms.empty()) {
        rooms.report.warnings.emplace_back(
            "no room is where one of the earlier result is: are both in the same map frame?");
    }
    return std::move(tracked.events);
}

/// Zones, by what joins their rooms, and how independent they are by what the scans of a log see.
/// Their rooms are known only now, so that each scan is looked at again.
void find_zones_in(Input& input, const FollowOptions& options, const RunOptions& run,
                   StageClock& clock, Segmentation& rooms, io::RunInfo& info) {
    if (options.zones.count == kNoZones) return;
    clock.begin("zones");
    std::vector<Sighting> sightings;
    if (input.scans) {
        sightings = look_again(*input.scans, input.map, rooms, options.integrate, run);
    }
    rooms.zones = find_zones(rooms, covisibility_of(sightings, rooms), options.zones);
    if (input.scans) info.independence = independence_of(sightings, input.map, rooms);
}

void run(const Arguments& arguments) {
    const auto start = std::chrono::steady_clock::now();
    FollowOptions all_options;
    SegmentOptions& options = all_options.segment;
    RunOptions run_options;
    set_fields(arguments,
               option_fields(options, all_options.zones, all_options.integrate, run_options));
    options.with_hierarchy = arguments.has(kHierarchyFlag);
    const RunDevice device(arguments, run_options.num_threads);
    run_options.accelerator = device.accelerator();
    Progress progress(progress_style_of(arguments));
    StageClock clock([&progress](std::string_view stage) { progress.begin(stage); });
    run_options.on_stage = [&clock](std::string_view stage) { clock.begin(stage); };

    clock.begin("read");
    KnownInput known = open_map_or_log(arguments.operands[0]);
    const formats::Formats formats = formats_for(known.kind);
    const std::vector<std::string> files = formats::files_of(formats);
    io::FileBatch output = begin_output(arguments, files);
    const std::optional<io::PreviousResult> previous = read_previous(arguments, clock);
    clock.begin("read");
    Input input = known.kind == io::FileKind::laser_log
                      ? input_of_log(arguments, std::move(known.input), all_options.integrate,
                                     clock, progress)
                      : input_of_map(arguments, std::move(known.input), files, output);
    keep_the_number(arguments, options, input);
    warn_of_the_ineffective(options, input);
    io::RunInfo info = run_info_of(all_options, run_options);
    const EarlierRooms earlier = earlier_rooms(previous, input);
    Segmentation rooms = segment(input.map, options, run_options, input.trajectory, earlier.labels);
    if (options.preset == Preset::rooms && options.paper.num_submaps != 0) {
        rooms = joined_into_submaps(std::move(rooms), options.paper.num_submaps, input.map,
                                    run_options.executor());
    }
    if (rooms.rooms.empty()) {
        rooms.report.warnings.push_back(io::why_no_rooms(input.map, options, input.trajectory));
        if (!input.why_no_rooms.empty()) rooms.report.warnings.push_back(input.why_no_rooms);
    }
    if (previous) {
        info.previous_colors = previous->legend.colors;
        info.events = recognise(earlier, clock, rooms);
    }
    find_zones_in(input, all_options, run_options, clock, rooms, info);
    rooms.report.stages_ms = clock.finish();
    rooms.report.warnings.insert(rooms.report.warnings.begin(), input.warnings.begin(),
                                 input.warnings.end());
    progress.begin("write");
    info.input = arguments.operands[0];
    info.input_hash = input.content_hash;
    info.map_keys = input.keys;
    write(output, formats, input, rooms, info);

    progress.wipe();
    print_warnings(rooms.report.warnings);
    device.print_notes(options);
    print_summary({rooms, info.events, start, io::display_name(output_folder(arguments)), files},
                  summary_style_of(arguments));
}

}  // namespace

Command segment_command() {
    SegmentOptions defaults;
    ZoneOptions zones;
    IntegrateOptions integrate;
    RunOptions run_options;
    const std::vector<OptionField> fields = option_fields(defaults, zones, integrate, run_options);
    CommandForm form;
    form.name = "segment";
    form.text =
        "Cuts a map (map_server YAML, or an image: PNG, PGM, TIFF, BMP, JPEG, GIF) or the map of a "
        "laser log (CARMEN) into rooms. '-' is standard input.";
    form.operands = {"MAP|LOG"};
    form.flags = {output_flag(),
                  force_flag(),
                  resolution_flag(),
                  flag_of(fields, "preset", "NAME"),
                  flag_of(fields, "submaps", "K"),
                  flag_of(fields, "door_width", "M"),
                  flag_of(fields, "granularity", "G"),
                  {std::string(kHierarchyFlag), "", "",
                   "rooms.geojson also gets the regions of all granularities, nested"},
                  flag_of(fields, "zones", "K"),
                  poses_flag(),
                  {std::string(kPreviousFlag), "", "DIR",
                   "an earlier result of the building: rooms that are the same keep id and name; "
                   "may be the folder of -o"},
                  flag_of(fields, "threads", "N"),
                  device_flag(),
                  set_flag(),
                  json_flag(),
                  quiet_flag()};
    form.settings = names_of(fields);
    form.examples = {
        "quadcut segment build/demo/map.yaml -o rooms",
        "quadcut segment build/demo/simulation/robot.log -o rooms_of_log --previous build/demo"};
    const std::vector<Flag> greys = grey_flags();
    form.flags.insert(form.flags.begin() + 3, greys.begin(), greys.end());
    return {form, run};
}

}  // namespace quadcut
