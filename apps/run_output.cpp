// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/run_output.hpp"

#include <utility>

#include "formats/results.hpp"
#include "io/map_writer.hpp"
#include "io/no_rooms_in_map.hpp"
#include "quadcut/version.hpp"

namespace quadcut {
namespace {

constexpr const char* kUpdates = "updates.jsonl";

}  // namespace

io::RunInfo run_info_of(SegmentOptions& options, const RunOptions& run) {
    io::RunInfo info;
    info.version = kVersion;
    info.options = option_fields(options);
    info.num_threads = static_cast<int>(run.num_threads);
    return info;
}

std::vector<std::string> followed_files() {
    std::vector<std::string> files = formats::result_files();
    for (std::string& file : io::map_files()) files.push_back(std::move(file));
    files.emplace_back(kUpdates);
    return files;
}

Segmentation followed_rooms(const Snapshot& building, const SegmentOptions& options,
                            std::vector<std::string> warnings) {
    Segmentation rooms = building.rooms();
    rooms.report.num_leaves = building.num_leaves();
    rooms.report.warnings = std::move(warnings);
    if (rooms.rooms.empty()) {
        rooms.report.warnings.push_back(io::why_no_rooms(building.map(), options));
    }
    return rooms;
}

std::string num_rooms_text(std::size_t num_rooms) {
    return std::to_string(num_rooms) + (num_rooms == 1 ? " room" : " rooms");
}

void add_followed(io::FileBatch& output, const Snapshot& building, const Segmentation& rooms,
                  const io::RunInfo& info) {
    io::add_map(output, building.map());
    formats::add_results(output, building.map(), rooms, info);
    output.add(kUpdates, building.updates());
}

}  // namespace quadcut
