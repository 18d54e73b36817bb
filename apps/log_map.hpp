// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/progress.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut {

/// A map made of a laser log.
struct LogMap {
    GridMap map;
    /// Where the laser was at each scan, metres in the map frame.
    std::vector<Point> trajectory;
    std::size_t num_leaves = 0;
    std::vector<std::string> warnings;
    std::uint64_t content_hash = 0;
};

/// The scans of a laser log, in the order of its lines.
struct PosedLog {
    std::vector<Scan> scans;
    /// The line of each.
    std::vector<std::uint64_t> lines;
    std::vector<std::string> warnings;
    std::uint64_t content_hash = 0;
};

/// Reads a log; `poses` names a file of poses that replace the log's own (see with_poses). Scans
/// that are too far from the others for one map (see find_far_scans) are left out, with a warning.
/// The stage is `read`. Throws InputError.
[[nodiscard]] PosedLog read_posed_log(const std::filesystem::path& log,
                                      const std::optional<std::filesystem::path>& poses,
                                      double resolution_m, StageClock& clock);

/// Reads a log as read_posed_log() does and maps it. The stages are `read` and `map`. Throws
/// InputError.
[[nodiscard]] LogMap map_log(const std::filesystem::path& log,
                             const std::optional<std::filesystem::path>& poses, double resolution_m,
                             StageClock& clock, Progress& progress);

}  // namespace quadcut
