// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/carmen.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "io/fields.hpp"
#include "io/file.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr double kPi = std::numbers::pi;

double normalized(double yaw_rad) { return std::remainder(yaw_rad, 2.0 * kPi); }

void note(LineCount& count, const Line& line, std::string problem, std::uint64_t times = 1) {
    if (times == 0) return;
    if (count.count == 0) {
        count.first_line = line.number;
        count.first_problem = std::move(problem);
    }
    count.count += times;
}

/// Message names are capitals, digits and the like; garbage is anything else.
bool is_message_name(std::string_view text) {
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    const auto fits = [&](char c) {
        return is_capital(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    return !text.empty() && is_capital(text[0]) && std::all_of(text.begin(), text.end(), fits);
}

/// Whether any laser line of the log states a pose.
bool find_posed_lines(const OpenPieces& open, const std::string& name) {
    LineReader lines(open(), name);
    while (const std::optional<Line> line = lines.next()) {
        const std::optional<LaserName> laser = find_laser(Fields(line->text).next());
        if (laser && laser->kind != LaserKind::raw) return true;
    }
    return false;
}

/// Whether the laser is elsewhere than the odometry, farther than a laser is from its robot.
bool is_corrected(const LaserLine& laser) {
    constexpr double kMaxLaserOffset = 1.0;
    if (!laser.odometry) return false;
    const Pose& pose = laser.laser_pose;
    return distance({pose.x, pose.y}, {laser.odometry->x, laser.odometry->y}) > kMaxLaserOffset;
}

/// Ranges are floats: a limit between two of them must not let the lower one pass.
double as_range(double limit_m) { return static_cast<double>(static_cast<float>(limit_m)); }

std::string describe(const LineCount& count, const char* one, const char* many) {
    return std::to_string(count.count) + " " + (count.count == 1 ? one : many) +
           ", the first in line " + std::to_string(count.first_line) +
           (count.first_problem.empty() ? "" : ": " + count.first_problem);
}

}  // namespace

CarmenReader::CarmenReader(OpenPieces open, std::string name, LogReadOptions options)
    : open_(std::move(open)), name_(std::move(name)), options_(options), lines_(open_(), name_) {}

std::optional<Scan> CarmenReader::next() {
    while (const std::optional<Line> line = lines_.next()) {
        counts_.lines = line->number;
        Fields fields(line->text);
        const std::string_view message = fields.next();
        if (message.empty() || message.starts_with('#')) continue;
        if (line->too_long) {
            note(counts_.garbage_lines, *line, "expected a shorter line");
            continue;
        }
        if (const std::optional<LaserName> laser = find_laser(message)) {
            std::optional<Scan> scan = read_laser(*laser, fields.rest(), *line);
            if (scan) return scan;
        } else {
            read_other(message, fields.rest(), *line);
        }
    }
    return std::nullopt;
}

/// Logs of later CARMEN versions hold each sweep twice, with and without its pose.
bool CarmenReader::is_superseded(LaserName name) {
    if (name.kind != LaserKind::raw) return false;
    if (!has_posed_lines_) has_posed_lines_ = find_posed_lines(open_, name_);
    return *has_posed_lines_;
}

std::optional<Scan> CarmenReader::read_laser(LaserName name, std::string_view fields,
                                             const Line& line) {
    if (is_superseded(name)) {
        ++counts_.other_messages;
        return std::nullopt;
    }
    ParsedLaserLine parsed = parse_laser_line(name, fields);
    if (parsed.line && !line.ended && !parsed.line->is_whole) {
        parsed = {std::nullopt, "the file ends in the middle of the line"};
    }
    if (!parsed.line) {
        note(counts_.bad_laser_lines, line, std::move(parsed.problem));
        return std::nullopt;
    }
    LaserLine& laser = *parsed.line;
    if (!find_pose(laser, line)) return std::nullopt;
    note(counts_.invalid_ranges, line, {}, laser.num_invalid_ranges);
    return make_scan(std::move(laser), line);
}

/// Makes laser_pose the pose of the sensor in the world, whatever the kind of line.
bool CarmenReader::find_pose(LaserLine& laser, const Line& line) {
    if (laser.name.kind == LaserKind::raw) {
        if (!odometry_) {
            note(counts_.scans_without_odometry, line, "expected ODOM before it");
            return false;
        }
        Pose robot_from_laser;
        if (laser.name.number == 1) robot_from_laser = {front_offset_m_, 0.0, 0.0};
        if (laser.name.number == 2) robot_from_laser = {rear_offset_m_, 0.0, kPi};
        laser.laser_pose = compose(*odometry_, robot_from_laser);
    }
    if (!is_plausible(laser.laser_pose)) {
        note(counts_.bad_poses, line, "expected a finite pose");
        return false;
    }
    if (laser.name.kind == LaserKind::front) {
        front_yaw_ = laser.laser_pose.yaw_rad;
        is_front_corrected_ = is_corrected(laser);
    }
    if (laser.name.kind == LaserKind::rear && !turn_rear_laser(laser, line)) return false;
    laser.laser_pose.yaw_rad = normalized(laser.laser_pose.yaw_rad);
    return true;
}

bool CarmenReader::turn_rear_laser(LaserLine& laser, const Line& line) {
    // Programs that correct the poses of a log may have known of FLASER only.
    if (is_front_corrected_ && laser.odometry && !is_corrected(laser)) {
        note(counts_.uncorrected_scans, line, "expected a corrected pose, as FLASER has");
        return false;
    }
    // Some writers state the robot's heading, others the rear laser's, half a turn from it.
    double robot_yaw = laser.odometry ? laser.odometry->yaw_rad : laser.laser_pose.yaw_rad;
    if (front_yaw_) robot_yaw = *front_yaw_;
    const double turned = normalized(laser.laser_pose.yaw_rad - robot_yaw);
    if (!(std::abs(turned) > 0.5 * kPi)) laser.laser_pose.yaw_rad += kPi;
    return true;
}

Scan CarmenReader::make_scan(LaserLine laser, const Line& line) {
    const auto known = std::find_if(lasers_.begin(), lasers_.end(), [&laser](const Laser& other) {
        return other.name == laser.name;
    });
    last_laser_ = static_cast<std::size_t>(known - lasers_.begin());
    if (known == lasers_.end()) lasers_.push_back({laser.name, {}});
    lasers_[last_laser_].no_return.add(laser.ranges_m);

    if (laser.time_s && has_time_ && *laser.time_s < last_time_s_) {
        note(counts_.backward_times, line, {});
    }
    if (laser.time_s) {
        last_time_s_ = *laser.time_s;
        has_time_ = true;
    }
    double max_range_m = std::min(laser.max_range_m, kMaxUsableRange);
    if (laser.name.kind == LaserKind::front) {
        max_range_m = std::min(max_range_m, front_max_range_m_);
    } else if (laser.name.kind == LaserKind::rear) {
        max_range_m = std::min(max_range_m, rear_max_range_m_);
    }
    ++counts_.scans;
    return {laser.laser_pose,     laser.first_angle_rad,
            laser.angle_step_rad, as_range(options_.max_range_m.value_or(max_range_m)),
            last_time_s_,         std::move(laser.ranges_m)};
}

void CarmenReader::read_other(std::string_view message, std::string_view fields, const Line& line) {
    if (!is_message_name(message)) {
        note(counts_.garbage_lines, line, "expected a message, found " + quote(line.text));
        return;
    }
    ++counts_.other_messages;
    if (message == "PARAM") read_parameter(fields);
    if (message != "ODOM") return;
    Fields numbers(fields);
    const std::optional<double> x = numbers.next_number();
    const std::optional<double> y = numbers.next_number();
    const std::optional<double> yaw = numbers.next_number();
    if (x && y && yaw && is_plausible({*x, *y, *yaw})) {
        odometry_ = Pose{*x, *y, *yaw};
    } else {
        note(counts_.bad_poses, line, "expected x, y and theta after ODOM");
    }
}

void CarmenReader::read_parameter(std::string_view fields) {
    Fields cursor(fields);
    const std::string_view parameter = cursor.next();
    const std::optional<double> value = cursor.next_number();
    if (!value || !std::isfinite(*value)) return;
    if (parameter == "robot_frontlaser_offset") front_offset_m_ = *value;
    if (parameter == "robot_rearlaser_offset") rear_offset_m_ = *value;
    if (*value <= 0.0) return;
    if (parameter == "robot_front_laser_max") front_max_range_m_ = *value;
    if (parameter == "robot_rear_laser_max") rear_max_range_m_ = *value;
}

std::vector<double> CarmenReader::no_return_limits_m() const {
    std::vector<double> limits;
    for (const Laser& laser : lasers_) limits.push_back(as_range(laser.no_return.limit_m()));
    return limits;
}

std::vector<std::string> CarmenReader::warnings() const {
    std::vector<std::string> texts;
    const auto warn = [&](const LineCount& count, const char* one, const char* many) {
        if (count.count > 0) texts.push_back(name_ + ": " + describe(count, one, many));
    };
    warn(counts_.garbage_lines, "line that is no message skipped",
         "lines that are no messages skipped");
    warn(counts_.bad_laser_lines, "unusable laser line skipped", "unusable laser lines skipped");
    warn(counts_.bad_poses, "line with an unusable pose skipped",
         "lines with unusable poses skipped");
    warn(counts_.scans_without_odometry, "raw scan without a pose skipped",
         "raw scans without a pose skipped");
    warn(counts_.uncorrected_scans, "rear scan skipped", "rear scans skipped");
    warn(counts_.invalid_ranges, "beam with a negative range or none ignored",
         "beams with negative ranges or none ignored");
    warn(counts_.backward_times, "time stamp runs backwards (the order of the lines is kept)",
         "time stamps run backwards (the order of the lines is kept)");
    return texts;
}

void CarmenReader::require_scans() const {
    if (counts_.scans > 0) return;
    if (open_()().empty()) {
        throw InputError(name_ + ": the file is empty, expected a CARMEN log");
    }
    const auto refuse = [this](const LineCount& count) {
        if (count.count == 0) return;
        throw InputError(name_ + ": none of the laser lines can be used; the first is line " +
                         std::to_string(count.first_line) + ": " + count.first_problem);
    };
    refuse(counts_.bad_laser_lines);
    refuse(counts_.scans_without_odometry);
    refuse(counts_.bad_poses);
    throw InputError(name_ + ": no laser line in " + std::to_string(counts_.lines) +
                     " lines, expected FLASER, RLASER, ROBOTLASER1 or RAWLASER1");
}

LogFile parse_carmen_log(std::string_view bytes, const std::string& name,
                         const LogReadOptions& options) {
    CarmenReader reader([bytes] { return pieces_of(bytes); }, name, options);
    LogFile log;
    std::vector<std::size_t> lasers;
    while (std::optional<Scan> scan = reader.next()) {
        log.scans.push_back(std::move(*scan));
        log.lines.push_back(reader.last_line());
        lasers.push_back(reader.last_laser());
    }
    reader.require_scans();
    const std::vector<double> limits = reader.no_return_limits_m();
    for (std::size_t i = 0; i < log.scans.size() && !options.max_range_m; ++i) {
        log.scans[i].max_range_m = std::min(log.scans[i].max_range_m, limits[lasers[i]]);
    }
    log.warnings = reader.warnings();
    log.counts = reader.counts();
    log.content_hash = hash_bytes(bytes);
    return log;
}

LogFile read_carmen_log(const std::filesystem::path& path, const LogReadOptions& options) {
    return parse_carmen_log(read_file(path), display_name(path), options);
}

}  // namespace quadcut::io
