// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/carmen_line.hpp"
#include "io/line_reader.hpp"
#include "io/no_return.hpp"
#include "io/pieces.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut::io {

struct LogReadOptions {
    /// A reading from here on means "no return"; when not given, what the log states or shows.
    std::optional<double> max_range_m = {};
};

/// How often something was wrong in a log, and where first.
struct LineCount {
    std::uint64_t count = 0;
    std::uint64_t first_line = 0;
    std::string first_problem;
};

/// What was met in a log.
struct LogCounts {
    std::uint64_t lines = 0;
    std::uint64_t scans = 0;
    std::uint64_t other_messages = 0;  ///< well-named messages of other kinds
    LineCount garbage_lines;           ///< no message at all
    LineCount bad_laser_lines;         ///< laser messages that cannot be used
    LineCount bad_poses;               ///< laser messages whose pose is no number, or absurd
    LineCount scans_without_odometry;  ///< RAWLASER before the first ODOM
    LineCount uncorrected_scans;       ///< RLASER left in the frame that FLASER was moved out of
    LineCount backward_times;          ///< kept: the order of the lines is right
    LineCount invalid_ranges;          ///< single beams
};

/// Reads the scans of a CARMEN log one by one, plain or gzip by content: FLASER, RLASER and
/// ROBOTLASER with the laser's pose that they state; RAWLASER (only in a log without any of the
/// former) with the pose of the last ODOM and the laser's PARAM offset. Lines that cannot be used
/// are skipped and counted. Cost: linear in the bytes; memory for a line and a piece.
class CarmenReader {
public:
    /// `name` stands in messages.
    CarmenReader(OpenPieces open, std::string name, LogReadOptions options = {});

    /// The next scan; nothing at the end. Its max_range_m is the least of what its line, PARAM and
    /// kMaxUsableRange say (or the option's). Throws InputError when compressed bytes are damaged.
    std::optional<Scan> next();

    /// Which laser the last scan came from: 0, 1, ... in the order of their first line.
    [[nodiscard]] std::size_t last_laser() const { return last_laser_; }
    /// The number of its line, counted from 1.
    [[nodiscard]] std::uint64_t last_line() const { return counts_.lines; }
    /// From where on a reading means "no return", for each laser, as far as was read.
    [[nodiscard]] std::vector<double> no_return_limits_m() const;
    [[nodiscard]] const LogCounts& counts() const { return counts_; }
    /// One sentence for each thing that a user should know of.
    [[nodiscard]] std::vector<std::string> warnings() const;
    /// Throws InputError that says why when no scan came out of the log.
    void require_scans() const;

private:
    struct Laser {
        LaserName name;
        NoReturnFinder no_return;
    };

    std::optional<Scan> read_laser(LaserName name, std::string_view fields, const Line& line);
    bool find_pose(LaserLine& laser, const Line& line);
    bool turn_rear_laser(LaserLine& laser, const Line& line);
    Scan make_scan(LaserLine laser, const Line& line);
    void read_other(std::string_view message, std::string_view fields, const Line& line);
    void read_parameter(std::string_view fields);
    bool is_superseded(LaserName name);

    OpenPieces open_;
    std::string name_;
    LogReadOptions options_;
    LineReader lines_;
    LogCounts counts_;
    std::vector<Laser> lasers_;
    std::size_t last_laser_ = 0;
    std::optional<Pose> odometry_;
    std::optional<double> front_yaw_;
    bool is_front_corrected_ = false;
    std::optional<bool> has_posed_lines_;
    double last_time_s_ = 0.0;
    bool has_time_ = false;
    double front_offset_m_ = 0.0;
    double rear_offset_m_ = 0.0;
    double front_max_range_m_ = kMaxUsableRange;
    double rear_max_range_m_ = kMaxUsableRange;
};

/// A whole log.
struct LogFile {
    std::vector<Scan> scans;
    std::vector<std::uint64_t> lines;  ///< of each scan, counted from 1
    std::vector<std::string> warnings;
    LogCounts counts;
    std::uint64_t content_hash = 0;  ///< of the file's bytes
};

/// Reads all scans of a log, in the order of its lines. max_range_m of each scan is lowered to the
/// value that its laser is seen to give for "no return". Throws InputError when the file cannot be
/// read, is damaged, or holds no laser line that can be used.
[[nodiscard]] LogFile read_carmen_log(const std::filesystem::path& path,
                                      const LogReadOptions& options = {});
[[nodiscard]] LogFile parse_carmen_log(std::string_view bytes, const std::string& name,
                                       const LogReadOptions& options = {});

}  // namespace quadcut::io
