// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/follow_session.hpp"
#include "apps/map_of_result.hpp"
#include "apps/message.hpp"
#include "apps/output_folder.hpp"
#include "apps/room_place.hpp"
#include "apps/run_flags.hpp"
#include "apps/run_output.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "formats/results.hpp"
#include "io/file.hpp"
#include "io/map_server.hpp"
#include "io/map_writer.hpp"
#include "io/stored_result.hpp"
#include "project/project.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/follow/followed_map.hpp"

namespace quadcut {
namespace {

constexpr std::string_view kMapFlag = "--map";
constexpr const char* kReport = "report.json";

/// What is in the files.
struct Exported {
    Segmentation rooms;
    std::vector<std::string> files;
};

Exported export_project(const Arguments& arguments, const std::filesystem::path& path) {
    io::FileBatch output = begin_output(arguments, followed_files());
    const store::Project project(path, store::Access::read);
    const Follower follower = project.follower();
    if (!follower.map().is_placed()) {
        throw InputError(io::display_name(path) + ": has no map yet: no scan was followed");
    }
    SegmentOptions options = project.options().segment;
    Segmentation rooms = followed_rooms(follower, options, warnings_of(project.position()));
    print_warnings(rooms.report.warnings);
    io::RunInfo info = run_info_of(options);
    info.input = project.position().log;
    info.input_hash = project.position().log_hash;
    const Uninterrupted uninterrupted;
    add_followed(output, follower.map().to_grid(), rooms, project.update_lines(), info);
    output.commit();
    return {std::move(rooms), followed_files()};
}

/// The report stays as it is: nothing is cut again. The map of a log goes along.
Exported export_folder(const Arguments& arguments, const std::filesystem::path& folder) {
    io::FileBatch output = begin_output(arguments, formats::result_files());
    io::StoredResult result = io::read_stored_result(folder);
    const io::MapFile map = map_of_result(folder, result, arguments.value(kMapFlag));
    print_warnings(map.warnings);
    Exported exported{std::move(result.rooms), formats::result_files()};
    std::vector<std::string> carried{kReport};
    std::error_code error;
    const bool is_there = std::filesystem::equivalent(folder, output_folder(arguments), error);
    if (!is_there && is_part_of_result(folder, map)) {
        for (const std::string& file : io::map_files()) {
            carried.push_back(file);
            exported.files.push_back(file);
        }
    }
    output.protect(map.image_path);
    output.require_free(exported.files);
    io::RunInfo info;
    info.map_keys = std::move(result.map_keys);
    info.previous_colors = std::move(result.colors);
    info.regions = std::move(result.regions);
    const Uninterrupted uninterrupted;
    formats::add_rooms(output, map.map, exported.rooms, info);
    for (const std::string& file : carried) {
        if (std::filesystem::exists(folder / file, error)) {
            output.add(file, io::read_file(folder / file));
        }
    }
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
                  {std::string(kMapFlag), "", "FILE",
                   "the map that the results of DIR were made of; if not given, the file that "
                   "report.json names or DIR/map.yaml"},
                  json_flag(),
                  quiet_flag()};
    form.examples = {"quadcut export build/demo -o pictures",
                     "quadcut export build/demo/building.quadcut -o building"};
    return {form, run};
}

}  // namespace quadcut
