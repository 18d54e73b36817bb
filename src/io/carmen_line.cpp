// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/carmen_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "io/fields.hpp"

namespace quadcut::io {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;
constexpr double kFullTurn = 2.0 * std::numbers::pi;

struct Fan {
    double first_angle_rad = 0.0;
    double angle_step_rad = 0.0;
};

/// The beams of a line that states no angles.
Fan fan_of_count(std::size_t num_beams) {
    struct KnownFan {
        std::size_t num_steps;
        double field_of_view_degrees;
    };
    constexpr std::array<KnownFan, 3> kKnownFans = {{{400, 200.0}, {540, 270.0}, {1080, 270.0}}};
    // An even number is a full fan whose last beam the driver left out.
    const std::size_t num_steps = num_beams - num_beams % 2;
    double field_of_view_degrees = 180.0;
    for (const KnownFan& known : kKnownFans) {
        if (known.num_steps == num_steps) field_of_view_degrees = known.field_of_view_degrees;
    }
    const double field_of_view_rad = field_of_view_degrees * kRadians;
    return {-0.5 * field_of_view_rad, field_of_view_rad / static_cast<double>(num_steps)};
}

std::optional<Pose> read_pose(Fields& fields) {
    const std::optional<double> x = fields.next_number();
    const std::optional<double> y = fields.next_number();
    const std::optional<double> yaw = fields.next_number();
    if (!x || !y || !yaw) return std::nullopt;
    return Pose{*x, *y, *yaw};
}

/// Reads one range. An impossible one becomes infinite, which a scan takes for "says nothing".
float usable_range(double range, std::size_t& num_invalid) {
    constexpr double kMaxRange = 1e6;
    if (std::isfinite(range) && range >= 0.0 && range <= kMaxRange) {
        return static_cast<float>(range);
    }
    ++num_invalid;
    return std::numeric_limits<float>::infinity();
}

/// "number ranges..."; returns what is wrong, or nothing.
std::string read_ranges(Fields& fields, LaserLine& line) {
    const std::string_view count_text = fields.next();
    const std::optional<std::int64_t> count = parse_integer(count_text);
    if (!count || *count < 2) {
        return "expected a number of ranges, at least 2, found " + quote(count_text);
    }
    // Each range takes a white space and a digit: a count beyond that is never allocated for.
    if (static_cast<std::uint64_t>(*count) > fields.rest().size() / 2) {
        return "expected " + std::to_string(*count) + " ranges, the line is too short for them";
    }
    line.ranges_m.reserve(static_cast<std::size_t>(*count));
    for (std::int64_t i = 0; i < *count; ++i) {
        const std::string_view text = fields.next();
        const std::optional<double> range = parse_number(text);
        if (!range) {
            return "expected " + std::to_string(*count) + " ranges, range " +
                   std::to_string(i + 1) + " is " + quote(text);
        }
        line.ranges_m.push_back(usable_range(*range, line.num_invalid_ranges));
    }
    return {};
}

/// "time host logger_time".
void read_times(Fields& fields, LaserLine& line) {
    const std::optional<double> time = fields.next_number();
    const std::string_view host = fields.next();
    const std::optional<double> logger_time = fields.next_number();
    if (time && std::isfinite(*time)) line.time_s = time;
    line.is_whole = !host.empty() && logger_time.has_value();
}

/// "type start_angle field_of_view resolution max_range accuracy remission_mode".
std::string read_laser_config(Fields& fields, LaserLine& line, double& field_of_view_rad) {
    constexpr std::size_t kNumFields = 7;
    std::array<double, kNumFields> values{};
    for (double& value : values) {
        const std::string_view text = fields.next();
        const std::optional<double> number = parse_number(text);
        if (!number) return "expected the seven numbers of the laser, found " + quote(text);
        value = *number;
    }
    line.first_angle_rad = values[1];
    field_of_view_rad = values[2];
    line.angle_step_rad = values[3];
    if (values[4] > 0.0) line.max_range_m = values[4];
    if (!(std::abs(line.first_angle_rad) <= kFullTurn)) {
        return "expected a start angle within one turn";
    }
    return {};
}

/// Makes sure of the step between beams once their number is known.
std::string settle_step(LaserLine& line, double field_of_view_rad) {
    const auto num_steps = static_cast<double>(line.ranges_m.size() - 1);
    if (line.angle_step_rad == 0.0) line.angle_step_rad = field_of_view_rad / num_steps;
    constexpr double kSlack = 1.01;
    const double swept = std::abs(line.angle_step_rad) * num_steps;
    if (!(swept > 0.0) || swept > kSlack * kFullTurn) {
        return "expected beams that sweep at most one turn";
    }
    return {};
}

std::string read_remissions(Fields& fields) {
    const std::optional<std::int64_t> count = fields.next_integer();
    if (!count || *count < 0) return "expected the number of remission values";
    for (std::int64_t i = 0; i < *count; ++i) {
        if (fields.next().empty()) {
            return "expected " + std::to_string(*count) + " remission values, found " +
                   std::to_string(i);
        }
    }
    return {};
}

/// FLASER and RLASER: "ranges, laser pose, odometry pose, times".
std::string read_old_line(Fields& fields, LaserLine& line) {
    if (std::string problem = read_ranges(fields, line); !problem.empty()) return problem;
    const Fan fan = fan_of_count(line.ranges_m.size());
    line.first_angle_rad = fan.first_angle_rad;
    line.angle_step_rad = fan.angle_step_rad;
    const std::optional<Pose> pose = read_pose(fields);
    if (!pose) return "expected the laser's x, y and theta after the ranges";
    line.laser_pose = *pose;
    line.odometry = read_pose(fields);
    read_times(fields, line);
    return {};
}

/// ROBOTLASER and RAWLASER: "laser, ranges, remissions", and for the first of them "laser pose,
/// robot pose, two speeds, three distances of the safety system", then the times.
std::string read_new_line(Fields& fields, LaserLine& line) {
    double field_of_view_rad = 0.0;
    std::string problem = read_laser_config(fields, line, field_of_view_rad);
    if (problem.empty()) problem = read_ranges(fields, line);
    if (problem.empty()) problem = settle_step(line, field_of_view_rad);
    if (problem.empty()) problem = read_remissions(fields);
    if (!problem.empty()) return problem;
    if (line.name.kind == LaserKind::robot) {
        const std::optional<Pose> pose = read_pose(fields);
        if (!pose) return "expected the laser's x, y and theta after the remission values";
        line.laser_pose = *pose;
        line.odometry = read_pose(fields);
        constexpr int kNumSpeedsAndDistances = 5;
        for (int i = 0; i < kNumSpeedsAndDistances; ++i) fields.next();
    }
    read_times(fields, line);
    return {};
}

}  // namespace

std::optional<LaserName> find_laser(std::string_view message_name) {
    if (message_name == "FLASER") return LaserName{LaserKind::front, 1};
    if (message_name == "RLASER") return LaserName{LaserKind::rear, 1};
    LaserName name;
    if (message_name.starts_with("ROBOTLASER")) {
        name.kind = LaserKind::robot;
        message_name.remove_prefix(std::string_view("ROBOTLASER").size());
    } else if (message_name.starts_with("RAWLASER")) {
        name.kind = LaserKind::raw;
        message_name.remove_prefix(std::string_view("RAWLASER").size());
    } else {
        return std::nullopt;
    }
    if (message_name.size() != 1 || message_name[0] < '1' || message_name[0] > '9') {
        return std::nullopt;
    }
    name.number = message_name[0] - '0';
    return name;
}

ParsedLaserLine parse_laser_line(LaserName name, std::string_view fields) {
    Fields cursor(fields);
    LaserLine line;
    line.name = name;
    const bool is_old = name.kind == LaserKind::front || name.kind == LaserKind::rear;
    std::string problem = is_old ? read_old_line(cursor, line) : read_new_line(cursor, line);
    if (!problem.empty()) return {std::nullopt, std::move(problem)};
    return {std::move(line), {}};
}

bool is_plausible(const Pose& pose) {
    constexpr double kMaxDistance = 1e7;
    // Written so that a NaN fails.
    return std::abs(pose.x) <= kMaxDistance && std::abs(pose.y) <= kMaxDistance &&
           std::isfinite(pose.yaw_rad);
}

}  // namespace quadcut::io
