// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/map_of_result.hpp"
#include "apps/message.hpp"
#include "apps/output_folder.hpp"
#include "apps/poses_of_result.hpp"
#include "apps/run_flags.hpp"
#include "apps/run_output.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "formats/registry.hpp"
#include "io/file.hpp"
#include "io/map_server.hpp"
#include "io/stored_result.hpp"
#include "project/building_at.hpp"
#include "project/project.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/follow/followed_map.hpp"

namespace quadcut {
namespace {

constexpr std::string_view kMapFlag = "--map";
constexpr std::string_view kAsFlag = "--as";

using formats::Formats;
using formats::Part;

/// Those that --as names, or else all that tell of the parts.
Formats formats_for(const Arguments& arguments, std::initializer_list<Part> otherwise) {
    const std::optional<std::string> names = arguments.value(kAsFlag);
    if (!names) return formats::formats_of(otherwise);
    try {
        return formats::find_formats(*names);
    } catch (const InputError& error) {
        throw InputError(std::string(kAsFlag) + ": " + error.what());
    }
}

Flag as_flag() {
    std::string text = "only some of the files, by their formats, parted by commas:";
    for (const formats::Format& format : formats::all_formats()) {
        text.append(" ").append(format.name).append(" (");
        for (const std::string& file : format.files) {
            text.append(file).append(&file == &format.files.back() ? ")," : ", ");
        }
    }
    text.pop_back();
    return {std::string(kAsFlag), "", "FORMAT", text};
}

/// What is in the files.
struct Exported {
    Segmentation rooms;
    std::vector<std::string> files;
};

bool tells_poses(const Formats& formats) {
    return std::any_of(formats.begin(), formats.end(),
                       [](const formats::Format& format) { return format.part == Part::poses; });
}

/// Poses are told with their zones.
void require_zones(const Segmentation& rooms, const std::filesystem::path& where) {
    if (rooms.zones.count != 0) return;
    throw InputError(io::display_name(where) +
                     ": its rooms are in no zones, which poses are told by: cut it again with "
                     "--zones auto, or with their number");
}

Exported export_project(const Arguments& arguments, const std::filesystem::path& path) {
    const Formats wanted =
        formats_for(arguments, {Part::rooms, Part::report, Part::map, Part::updates});
    const std::vector<std::string> files = formats::files_of(wanted);
    io::FileBatch output = begin_output(arguments, files);
    const Project project = Project::open(path, Access::read);
    const std::shared_ptr<const Snapshot> building = project.snapshot();
    if (building->map().states.values.empty()) {
        throw InputError(io::display_name(path) + ": has no map yet: no scan was followed");
    }
    const ScanPosition position = project.position().value_or(ScanPosition{});
    FollowOptions options = project.options();
    Segmentation rooms = followed_rooms(*building, options.segment, warnings_of(position));
    print_warnings(rooms.report.warnings);
    io::RunInfo info = run_info_of(options, {});
    info.input = position.source;
    info.input_hash = position.source_hash;
    if (tells_poses(wanted)) {
        require_zones(rooms, path);
        info.poses = building->poses();
        if (info.poses.empty()) {
            throw InputError(io::display_name(path) +
                             ": knows no poses: a quadcut before it kept them, or no scan, has "
                             "made it; follow its scans into a new project");
        }
    }
    const Uninterrupted uninterrupted;
    formats::add_files(output, wanted, {building->map(), rooms, info, building->updates()});
    output.commit();
    return {std::move(rooms), files};
}

/// What is wanted of a folder: its files as they are, but for the rooms. Nothing is cut again.
Formats wanted_of_folder(const Arguments& arguments, const std::filesystem::path& folder,
                         const io::MapFile& map) {
    std::error_code error;
    const bool is_there = std::filesystem::equivalent(folder, output_folder(arguments), error);
    // The map of a log goes along.
    return !is_there && is_part_of_result(folder, map)
               ? formats_for(arguments, {Part::rooms, Part::report, Part::map})
               : formats_for(arguments, {Part::rooms, Part::report});
}

void add_as_it_is(io::FileBatch& output, const std::filesystem::path& path, bool may_be_missing) {
    std::error_code error;
    if (std::filesystem::exists(path, error)) {
        output.add(path.filename().string(), io::read_file(path));
    } else if (!may_be_missing) {
        throw InputError(io::display_name(path) + ": is not there to be exported");
    }
}

Exported export_folder(const Arguments& arguments, const std::filesystem::path& folder) {
    io::FileBatch output = begin_output(
        arguments, formats::files_of(formats_for(arguments, {Part::rooms, Part::report})));
    io::StoredResult result = io::read_stored_result(folder);
    const io::MapFile map = map_of_result(folder, result, arguments.value(kMapFlag));
    print_warnings(map.warnings);
    const Formats wanted = wanted_of_folder(arguments, folder, map);
    Exported exported{std::move(result.rooms), formats::files_of(wanted)};
    output.protect(map.image_path);
    output.require_free(exported.files);
    io::RunInfo info;
    info.map_keys = std::move(result.map_keys);
    info.previous_colors = std::move(result.colors);
    info.regions = std::move(result.regions);
    if (tells_poses(wanted)) {
        require_zones(exported.rooms, folder);
        ResultPoses found =
            poses_of_result(folder, result, map.map.resolution_m, poses_of(arguments));
        print_warnings(found.warnings);
        info.poses = std::move(found.poses);
    }
    const Uninterrupted uninterrupted;
    Formats anew;
    for (const formats::Format& format : wanted) {
        if (format.part == Part::rooms || format.part == Part::poses) {
            anew.push_back(format);
            continue;
        }
        for (const std::string& file : format.files) {
            add_as_it_is(output, folder / file, !arguments.has(kAsFlag));
        }
    }
    formats::add_files(output, anew, {map.map, exported.rooms, info});
    output.commit();
    return exported;
}

void run(const Arguments& arguments) {
    const auto start = std::chrono::steady_clock::now();
    const std::filesystem::path where = arguments.operands[0];
    Exported exported = room_place_of(where) == RoomPlace::folder
                            ? export_folder(arguments, where)
                            : export_project(arguments, where);
    print_summary({exported.rooms,
                   {},
                   start,
                   io::display_name(output_folder(arguments)),
                   std::move(exported.files)},
                  summary_style_of(arguments));
}

}  // namespace

Command export_command() {
    CommandForm form;
    form.name = "export";
    form.text = "Writes pictures and files of a project, or of results with edited names, anew.";
    form.operands = {"DIR|PROJECT"};
    form.flags = {output_flag(),
                  force_flag(),
                  as_flag(),
                  {std::string(kMapFlag), "", "FILE",
                   "the map that the results of DIR were made of; if not given, the file that "
                   "report.json names or DIR/map.yaml"},
                  {"--poses", "", "FILE",
                   "for g2o-submaps of DIR: where the scans were taken, TUM or g2o; if not given, "
                   "as the log that report.json names says"},
                  json_flag(),
                  quiet_flag()};
    form.examples = {"quadcut export build/demo -o pictures",
                     "quadcut export build/demo -o plan --as svg,geojson",
                     "quadcut export build/demo/building.quadcut -o building"};
    return {form, run};
}

}  // namespace quadcut
