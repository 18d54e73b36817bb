// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/output_folder.hpp"
#include "apps/run_flags.hpp"
#include "apps/run_output.hpp"
#include "apps/summary.hpp"
#include "apps/uninterrupted.hpp"
#include "io/file.hpp"
#include "io/map_server.hpp"
#include "io/results.hpp"
#include "io/stored_result.hpp"
#include "quadcut/base/error.hpp"
#include "store/project.hpp"

namespace quadcut {
namespace {

constexpr std::string_view kMapFlag = "--map";
constexpr const char* kReport = "report.json";

Segmentation export_project(const Arguments& arguments, const std::filesystem::path& path) {
    io::FileBatch output = begin_output(arguments, followed_files(), {path});
    const store::Project project(path, store::Access::read);
    const Follower follower = project.follower();
    if (!follower.map().is_placed()) {
        throw InputError(io::display_name(path) + ": has no map yet: no scan was followed");
    }
    Segmentation rooms = follower.rooms();
    rooms.report.num_leaves = follower.map().num_leaves();
    SegmentOptions options = project.options().segment;
    io::RunInfo info = run_info_of(options);
    info.input = project.position().log;
    info.input_hash = project.position().log_hash;
    const Uninterrupted uninterrupted;
    add_followed(output, follower.map().to_grid(), rooms, project.update_lines(), info);
    output.commit();
    return rooms;
}

/// The map that a result was made of: where it is said to be, in the folder, or where it was.
std::filesystem::path find_map(const Arguments& arguments, const std::filesystem::path& folder,
                               const std::string& input) {
    if (const auto given = arguments.value(kMapFlag)) return *given;
    std::error_code error;
    for (const std::filesystem::path& path :
         {folder / "map.yaml", std::filesystem::path(input), folder / input}) {
        if (std::filesystem::is_regular_file(path, error)) return path;
    }
    throw InputError(io::display_name(folder) + ": its map, " +
                     (input.empty() ? "map.yaml" : input) +
                     ", is not there any more: say where it is with --map FILE");
}

/// The map as it was read when it was cut, whatever the file says now.
GridMap read_map_of(const io::StoredResult& result, const std::filesystem::path& path) {
    const io::MapFile file = io::read_map(path, {result.map_keys.resolution_m});
    GridMap map = io::parse_map_image(io::read_file(file.image_path),
                                      io::display_name(file.image_path), result.map_keys)
                      .map;
    const Raster<std::uint16_t>& labels = result.rooms.labels;
    if (map.states.width == labels.width && map.states.height == labels.height) return map;
    throw InputError(io::display_name(path) + ": has " + std::to_string(map.states.width) + " x " +
                     std::to_string(map.states.height) + " cells, and the rooms were cut in " +
                     std::to_string(labels.width) + " x " + std::to_string(labels.height) +
                     ": say with --map FILE which map it was");
}

/// The report stays as it is: nothing is cut again.
Segmentation export_folder(const Arguments& arguments, const std::filesystem::path& folder) {
    io::FileBatch output = begin_output(arguments, io::result_files());
    io::StoredResult result = io::read_stored_result(folder);
    const std::filesystem::path path = find_map(arguments, folder, result.input);
    output.protect(path);
    output.require_free(io::result_files());
    const GridMap map = read_map_of(result, path);
    io::RunInfo info;
    info.map_keys = result.map_keys;
    info.previous_colors = result.colors;
    const std::filesystem::path report = folder / kReport;
    const Uninterrupted uninterrupted;
    io::add_rooms(output, map, result.rooms, info);
    std::error_code error;
    if (std::filesystem::exists(report, error)) output.add(kReport, io::read_file(report));
    output.commit();
    return std::move(result.rooms);
}

void run(const Arguments& arguments) {
    const auto start = std::chrono::steady_clock::now();
    const std::filesystem::path where = arguments.operands[0];
    const bool is_folder = std::filesystem::is_directory(where);
    const Segmentation rooms =
        is_folder ? export_folder(arguments, where) : export_project(arguments, where);
    print_summary({rooms,
                   {},
                   start,
                   io::display_name(output_folder(arguments)),
                   is_folder ? io::result_files() : followed_files()},
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
                   "the map that the results of DIR were made of; if not given, DIR/map.yaml or "
                   "the file that report.json names"},
                  json_flag(),
                  quiet_flag()};
    form.examples = {"quadcut export build/demo -o pictures",
                     "quadcut export build/demo/building.quadcut -o building"};
    return {form, run};
}

}  // namespace quadcut
