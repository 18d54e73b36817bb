// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/poses.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut::io {

/// A pose counts for scans this long before the first one or after the last one, seconds (or scans,
/// when poses are numbered).
inline constexpr double kPoseReach = 0.5;

struct PosedScans {
    std::vector<Scan> scans;
    /// The place of each among those that were given.
    std::vector<std::size_t> places;
    /// Scans that no pose is near to; they are left out.
    std::size_t num_left_out = 0;
};

/// Gives the scans other poses of the laser. Poses whose times are the numbers of scans (whole,
/// from 0 up to less than scans.size(), as g2o has them) are matched by number, others by time
/// stamp. A scan between two poses gets what lies between them, in proportion; one outside of all
/// of them, by more than kPoseReach, is left out. Throws InputError, beginning with `name`, when no
/// scan is left.
/// @pre poses is not empty.
[[nodiscard]] PosedScans with_poses(std::vector<Scan> scans, std::vector<TimedPose> poses,
                                    const std::string& name);

}  // namespace quadcut::io
