// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "apps/run_flags.hpp"
#include "io/room_list.hpp"
#include "quadcut/follow/track.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

/// What a table on a terminal shows: 60 columns are enough for it.
inline constexpr io::TableLimits kTerminalTable{20, 30};
/// Whether standard output is a terminal, where a person reads.
[[nodiscard]] bool is_for_people();

/// What a run has to say at its end.
struct RunSummary {
    const Segmentation& rooms;
    /// What became of the rooms of an earlier result, if there was one.
    std::optional<std::vector<RoomEvent>> events;
    std::chrono::steady_clock::time_point begun_at;
    std::string folder;
    std::vector<std::string> files;
};

/// "rooms: rooms.svg rooms.yaml": what was written, and where.
[[nodiscard]] std::string files_line(const std::string& folder,
                                     const std::vector<std::string>& files);

/// Prints it, on a terminal with a table of the rooms.
void print_summary(const RunSummary& run, SummaryStyle style);

}  // namespace quadcut
