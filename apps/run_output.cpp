// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/run_output.hpp"

#include <utility>

#include "formats/results.hpp"
#include "io/map_writer.hpp"
#include "io/no_rooms_in_map.hpp"
#include "quadcut/follow/followed_map.hpp"

namespace quadcut {
namespace {

constexpr const char* kUpdates = "updates.jsonl";

}  // namespace

io::RunInfo run_info_of(SegmentOptions& options) {
    io::RunInfo info;
    info.version = QUADCUT_VERSION;
    info.options = option_fields(options);
    // The result is the same on any number of threads.
    std::erase_if(info.options, [](const OptionField& field) { return field.name == "threads"; });
    info.num_threads = static_cast<int>(options.num_threads);
    return info;
}

std::vector<std::string> followed_files() {
    std::vector<std::string> files = formats::result_files();
    for (std::string& file : io::map_files()) files.push_back(std::move(file));
    files.emplace_back(kUpdates);
    return files;
}

Segmentation followed_rooms(const Follower& follower, const SegmentOptions& options,
                            std::vector<std::string> warnings) {
    Segmentation rooms = follower.rooms();
    rooms.report.num_leaves = follower.map().num_leaves();
    rooms.report.warnings = std::move(warnings);
    if (rooms.rooms.empty()) {
        rooms.report.warnings.push_back(io::why_no_rooms(follower.map().to_grid(), options));
    }
    return rooms;
}

void add_followed(io::FileBatch& output, const GridMap& map, const Segmentation& rooms,
                  const std::string& updates, const io::RunInfo& info) {
    io::add_map(output, map);
    formats::add_results(output, map, rooms, info);
    output.add(kUpdates, updates);
}

}  // namespace quadcut
