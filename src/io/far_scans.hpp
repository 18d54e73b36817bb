// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quadcut/map/integrate.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut::io {

/// How large the map of a log may become: files and memory go with the box around all of it, seen
/// or not. Poses are connected where a chain of them has gaps of up to kPoseGapM.
struct ExtentLimit {
    /// Cells of the box around all.
    std::int64_t most = kMaxCellsOfScans;
    /// Fewer when it also holds poses that are not connected with the rest: so many, and
    std::int64_t scattered = std::int64_t{1} << 22;
    /// so many for each cell of the boxes around what is connected.
    std::int64_t scattered_per_cell = 8;
};

/// Gaps of more than 2.8 times as much never connect.
inline constexpr double kPoseGapM = 10.0;

/// What of a scan says where it may be in a map: 32 bytes.
struct ScanReach {
    Pose pose;
    float longest_m = 0.0F;   ///< its longest reading that says something; 0: none
    std::uint32_t place = 0;  ///< where it stands in what it was read from
};

/// Scans that cannot be part of one map with the others.
struct FarScans {
    /// By scan; empty: none is.
    std::vector<bool> is_far;
    std::size_t count = 0;
    /// Of the first of them.
    std::size_t first = 0;
    std::string reason;
};

/// Finds the scans that lie too far from the others, or whose pose is no place at all. The largest
/// part of connected poses is kept, from the middle outwards as far as `limit.most` reaches; other
/// parts are kept, the nearest first, as long as the box around all is within the limit. Which
/// scans are kept does not depend on their order. O(scans log scans).
[[nodiscard]] FarScans find_far_scans(std::span<const ScanReach> scans, double resolution_m,
                                      const ExtentLimit& limit = {});

}  // namespace quadcut::io
