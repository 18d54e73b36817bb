// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/log_map.hpp"

#include <utility>

namespace quadcut {

PosedLog parse_posed_log(io::Input log, const std::optional<std::filesystem::path>& poses,
                         double resolution_m) {
    const auto source = io::open_scan_source(std::move(log), {poses, resolution_m, {}});
    PosedLog posed{
        source->facts().name, {}, {}, source->facts().warnings, source->facts().content_hash};
    while (std::optional<Scan> scan = source->next()) {
        posed.scans.push_back(std::move(*scan));
        posed.lines.push_back(std::stoull(source->place().substr(5)));
    }
    return posed;
}

}  // namespace quadcut
