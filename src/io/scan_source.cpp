// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/scan_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include "io/carmen.hpp"
#include "io/far_scans.hpp"
#include "io/pose_match.hpp"
#include "io/poses.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

std::uint64_t hash_of(const OpenPieces& open) {
    const Pieces pieces = open();
    std::uint64_t hash = hash_bytes({});
    for (std::string_view piece = pieces(); !piece.empty(); piece = pieces()) {
        hash = hash_bytes(piece, hash);
    }
    return hash;
}

std::uint64_t hash_of(const Pose& pose, std::uint64_t seed) {
    std::array<char, sizeof(double)> bytes{};
    for (const double value : {pose.x, pose.y, pose.yaw_rad}) {
        std::memcpy(bytes.data(), &value, sizeof value);
        seed = hash_bytes({bytes.data(), bytes.size()}, seed);
    }
    return seed;
}

std::string line_text(std::uint64_t line) { return "line " + std::to_string(line); }

/// The scans of a log. It is read to its end once to learn what its lasers give for "no return" and
/// how many scans there are, then for where they are, and then to give them.
class LogSource : public ScanSource {
public:
    LogSource(OpenPieces open, std::string name, const ScanSourceOptions& options)
        : open_(std::move(open)), read_options_{options.max_range_m} {
        facts_.name = std::move(name);
        facts_.content_hash = hash_of(open_);
        look_at_lasers();
        if (options.poses) match_.emplace(read_poses(*options.poses), num_read_);
        std::vector<ScanReach> reaches = look_at_poses();
        if (options.poses) check_match(display_name(*options.poses));
        leave_out_far_scans(reaches, options.resolution_m);
        begin();
    }

    [[nodiscard]] const SourceFacts& facts() const override { return facts_; }
    [[nodiscard]] std::size_t num_done() const override { return num_done_; }
    [[nodiscard]] std::string place() const override { return line_text(reader_->last_line()); }

    [[nodiscard]] std::optional<Scan> next() override {
        while (std::optional<Scan> scan = next_posed()) {
            if (!is_far_.empty() && is_far_[num_posed_ - 1]) continue;
            ++num_done_;
            return scan;
        }
        return std::nullopt;
    }

    void rewind() override {
        begin();
        num_done_ = 0;
    }

private:
    void begin() {
        reader_.emplace(open_, facts_.name, read_options_);
        num_posed_ = 0;
    }

    void look_at_lasers() {
        begin();
        while (const std::optional<Scan> scan = reader_->next()) {
            first_s_ = std::min(first_s_, scan->time_s);
            last_s_ = std::max(last_s_, scan->time_s);
        }
        reader_->require_scans();
        num_read_ = reader_->counts().scans;
        if (!read_options_.max_range_m) limits_m_ = reader_->no_return_limits_m();
        facts_.warnings = reader_->warnings();
    }

    std::vector<ScanReach> look_at_poses() {
        begin();
        std::vector<ScanReach> reaches;
        reaches.reserve(num_read_);
        while (const std::optional<Scan> scan = next_posed()) {
            reaches.push_back({scan->world_from_sensor, longest_reading_m(*scan),
                               static_cast<std::uint32_t>(reader_->last_line())});
        }
        return reaches;
    }

    void check_match(const std::string& name) {
        if (num_posed_ == 0) {
            throw InputError(
                name + ": no pose is near a scan in time: " + match_->why_none(first_s_, last_s_));
        }
        if (num_posed_ == num_read_) return;
        facts_.warnings.push_back(name + ": no pose near " +
                                  std::to_string(num_read_ - num_posed_) + " of the scans of " +
                                  facts_.name + "; they are left out");
    }

    /// The next scan that has a pose.
    std::optional<Scan> next_posed() {
        while (std::optional<Scan> scan = reader_->next()) {
            if (match_) {
                const auto pose = match_->pose_of(reader_->counts().scans - 1, scan->time_s);
                if (!pose) continue;
                scan->world_from_sensor = *pose;
            }
            if (!limits_m_.empty()) {
                scan->max_range_m = std::min(scan->max_range_m, limits_m_[reader_->last_laser()]);
            }
            ++num_posed_;
            return scan;
        }
        return std::nullopt;
    }

    /// One map is made of all, whatever command makes it.
    void leave_out_far_scans(const std::vector<ScanReach>& reaches, double resolution_m) {
        FarScans far = find_far_scans(reaches, resolution_m);
        facts_.num_scans = reaches.size() - far.count;
        if (far.count > 0) tell_of(far, reaches);
        is_far_ = std::move(far.is_far);
        facts_.scans_hash = facts_.content_hash;
        for (std::size_t i = 0; i < reaches.size(); ++i) {
            if (!is_far_.empty() && is_far_[i]) continue;
            facts_.scans_hash = hash_of(reaches[i].pose, facts_.scans_hash);
        }
    }

    void tell_of(const FarScans& far, const std::vector<ScanReach>& reaches) {
        const std::string what =
            facts_.name + ": " + line_text(reaches[far.first].place) + ": " + far.reason;
        if (facts_.num_scans == 0) throw InputError(what + "; nor can any other scan be used");
        facts_.warnings.push_back(what + "; left out (" + std::to_string(far.count) + " of " +
                                  std::to_string(reaches.size()) + " scans)");
    }

    OpenPieces open_;
    LogReadOptions read_options_;
    SourceFacts facts_;
    std::optional<PoseMatch> match_;
    /// Of each laser; none: what the scans say.
    std::vector<double> limits_m_;
    /// Of each scan that has a pose; none: no scan is.
    std::vector<bool> is_far_;
    std::size_t num_read_ = 0;
    double first_s_ = HUGE_VAL;
    double last_s_ = -HUGE_VAL;

    std::optional<CarmenReader> reader_;
    std::size_t num_posed_ = 0;
    std::size_t num_done_ = 0;
};

}  // namespace

void skip_to(ScanSource& source, std::size_t num_done) {
    while (source.num_done() < num_done && source.next()) {
    }
}

std::unique_ptr<ScanSource> open_scan_source(Input input, const ScanSourceOptions& options) {
    std::string name = input.beginning().name;
    return std::make_unique<LogSource>(std::move(input).open_pieces(), std::move(name), options);
}

}  // namespace quadcut::io
