// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/run_output.hpp"

#include <utility>

#include "formats/registry.hpp"
#include "io/no_rooms_in_map.hpp"
#include "io/option_text.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/version.hpp"

namespace quadcut {
namespace {

using formats::Part;

formats::Formats followed_formats() {
    return formats::formats_of({Part::rooms, Part::report, Part::map, Part::updates});
}

}  // namespace

io::RunInfo run_info_of(FollowOptions& options, const RunOptions& run) {
    io::RunInfo info;
    info.version = kVersion;
    info.options = option_fields(options.segment);
    FollowOptions defaults;
    const std::vector<OptionField> all = option_fields(options);
    const std::vector<OptionField> by_default = option_fields(defaults);
    for (std::size_t i = info.options.size(); i < all.size(); ++i) {
        const bool is_changed = io::option_text(all[i]) != io::option_text(by_default[i]);
        if (is_changed) info.options.push_back(all[i]);
    }
    info.num_threads = static_cast<int>(run.num_threads);
    return info;
}

std::vector<std::string> followed_files() { return formats::files_of(followed_formats()); }

Segmentation followed_rooms(const Snapshot& building, const SegmentOptions& options,
                            std::vector<std::string> warnings) {
    Segmentation rooms = building.rooms();
    rooms.report.num_leaves = building.followed()->map.num_leaves();
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
    formats::add_files(output, followed_formats(),
                       {building.map(), rooms, info, building.updates()});
}

}  // namespace quadcut
