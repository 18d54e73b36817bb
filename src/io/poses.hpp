// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "quadcut/base/geometry.hpp"

namespace quadcut::io {

/// Where the robot was, in the map frame, and when. Files without times count 0, 1, 2, ...
struct TimedPose {
    double time_s = 0.0;
    Pose pose;
};

/// Reads a trajectory, plain or gzip, in the order of its lines: TUM (`t x y z qx qy qz qw`; z is
/// left out, yaw is the turn about z of the normalised quaternion) or g2o (VERTEX_SE2
/// `id x y yaw`, VERTEX_SE3:QUAT `id x y z qx qy qz qw`, the id as time; edges and other entries
/// are ignored), told apart by the first line that is neither blank nor a comment (`#`). Throws
/// InputError that names the line when one is malformed or not finite, or when there is no pose.
[[nodiscard]] std::vector<TimedPose> read_poses(const std::filesystem::path& path);
[[nodiscard]] std::vector<TimedPose> parse_poses(std::string_view bytes, const std::string& name);

}  // namespace quadcut::io
