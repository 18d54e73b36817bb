// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quadcut/base/geometry.hpp"

namespace quadcut::io {

/// What the laser lines of a CARMEN log are called: FLASER, RLASER, ROBOTLASER1 to 9,
/// RAWLASER1 to 9.
enum class LaserKind { front, rear, robot, raw };

/// Which laser of the log a line belongs to. `number` is 1 for front and rear.
struct LaserName {
    LaserKind kind = LaserKind::front;
    int number = 1;
    friend bool operator==(const LaserName&, const LaserName&) = default;
};

/// The laser that a message name stands for; nothing for every other message.
[[nodiscard]] std::optional<LaserName> find_laser(std::string_view message_name);

/// One laser line, in the log's own terms.
struct LaserLine {
    LaserName name;
    double first_angle_rad = 0.0;
    double angle_step_rad = 0.0;
    /// Infinite where the line does not state it.
    double max_range_m = std::numeric_limits<double>::infinity();
    /// Ranges that are no number, too large for one, or negative are infinite.
    std::vector<float> ranges_m;
    std::size_t num_invalid_ranges = 0;
    /// Of the laser; of no use in a raw line, which has none.
    Pose laser_pose;
    std::optional<Pose> odometry;
    std::optional<double> time_s;
    /// Whether the line goes on to its last time stamp: if not, it may be cut off in a number.
    bool is_whole = false;
};

/// A laser line, or why it is none.
struct ParsedLaserLine {
    std::optional<LaserLine> line;
    std::string problem;
};

/// Parses what follows the message name. FLASER and RLASER state no angles: their beams start at
/// -90 degrees and are 1 degree apart for 180 and 181 beams, 0.5 degrees for 360 and 361 (the
/// last beam of an even number is missing; the poses of corrected logs agree with it). 400, 540
/// and 1080 beams, and one more of each, are the known scanners of 200 and 270 degrees; any other
/// number spans 180 degrees. The fields behind the laser's pose may be missing.
[[nodiscard]] ParsedLaserLine parse_laser_line(LaserName name, std::string_view fields);

/// Whether a pose is finite and within 10,000 km: beyond lies nothing but damage.
[[nodiscard]] bool is_plausible(const Pose& pose);

}  // namespace quadcut::io
