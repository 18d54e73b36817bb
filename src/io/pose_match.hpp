// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/poses.hpp"
#include "quadcut/base/geometry.hpp"

namespace quadcut::io {

/// A pose counts for scans this long before the first one or after the last one, seconds (or scans,
/// when poses are numbered).
inline constexpr double kPoseReach = 0.5;

/// Other poses of the laser for scans. Poses whose times are the numbers of scans (whole, from 0 up
/// to less than `num_scans`, as g2o has them) are matched by number, others by time stamp. A scan
/// between two poses gets what lies between them, in proportion; one outside of all of them, by
/// more than kPoseReach, gets none.
class PoseMatch {
public:
    /// @pre poses is not empty.
    PoseMatch(std::vector<TimedPose> poses, std::size_t num_scans);

    /// Of the scan of that number, from 0 on. O(log poses).
    [[nodiscard]] std::optional<Pose> pose_of(std::size_t number, double time_s) const;

    /// "the poses are of 3 to 9 s, the scans of 100 to 200 s": why none of the scans, whose first
    /// and last time are given, has a pose.
    [[nodiscard]] std::string why_none(double first_s, double last_s) const;

private:
    std::vector<TimedPose> poses_;  ///< in order of time
    bool are_numbered_;
};

}  // namespace quadcut::io
