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
#include "io/file.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/base/stage_clock.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/integrate.hpp"
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
    std::string name;  ///< of the log, in messages
    std::vector<Scan> scans;
    /// The line of each.
    std::vector<std::uint64_t> lines;
    std::vector<std::string> warnings;
    std::uint64_t content_hash = 0;
};

/// The scans of a log that was read; `poses` names a file of poses that replace the log's own (see
/// with_poses). Scans that are too far from the others for one map (see find_far_scans) are left
/// out, with a warning. Throws InputError.
[[nodiscard]] PosedLog parse_posed_log(io::InputFile log,
                                       const std::optional<std::filesystem::path>& poses,
                                       double resolution_m);

/// Maps a log that was read, with poses as parse_posed_log() has them. The stages are `read` and
/// `map`. Throws InputError.
[[nodiscard]] LogMap map_log(io::InputFile log, const std::optional<std::filesystem::path>& poses,
                             double resolution_m, const IntegrateOptions& integrate,
                             StageClock& clock, Progress& progress);

}  // namespace quadcut
