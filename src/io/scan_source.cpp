// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/scan_source.hpp"

#include <array>
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

struct PosedLog {
    std::vector<Scan> scans;
    std::vector<std::uint64_t> lines;
};

/// Gives the scans the poses of a file.
void replace_poses(const std::filesystem::path& poses, PosedLog& posed, SourceFacts& facts) {
    const std::string name = display_name(poses);
    PosedScans matched = with_poses(std::move(posed.scans), read_poses(poses), name);
    if (matched.num_left_out > 0) {
        facts.warnings.push_back(name + ": no pose near " + std::to_string(matched.num_left_out) +
                                 " of the scans of " + facts.name + "; they are left out");
    }
    posed.scans = std::move(matched.scans);
    std::vector<std::uint64_t> lines;
    for (const std::size_t place : matched.places) lines.push_back(posed.lines[place]);
    posed.lines = std::move(lines);
}

/// One map is made of all, whatever command makes it.
void leave_out_far_scans(double resolution_m, PosedLog& posed, SourceFacts& facts) {
    const FarScans far = find_far_scans(posed.scans, resolution_m);
    if (far.count == 0) return;
    const std::size_t num_scans = posed.scans.size();
    const std::string what =
        facts.name + ": line " + std::to_string(posed.lines[far.first]) + ": " + far.reason;
    if (far.count == num_scans) throw InputError(what + "; nor can any other scan be used");
    facts.warnings.push_back(what + "; left out (" + std::to_string(far.count) + " of " +
                             std::to_string(num_scans) + " scans)");
    PosedLog kept;
    for (std::size_t i = 0; i < num_scans; ++i) {
        if (far.is_far[i]) continue;
        kept.scans.push_back(std::move(posed.scans[i]));
        kept.lines.push_back(posed.lines[i]);
    }
    posed = std::move(kept);
}

std::string_view bytes_of(const double& value, std::array<char, sizeof(double)>& buffer) {
    std::memcpy(buffer.data(), &value, sizeof value);
    return {buffer.data(), buffer.size()};
}

std::uint64_t hash_of(const std::vector<Scan>& scans, std::uint64_t seed) {
    std::array<char, sizeof(double)> buffer{};
    for (const Scan& scan : scans) {
        const Pose& pose = scan.world_from_sensor;
        for (const double value : {pose.x, pose.y, pose.yaw_rad}) {
            seed = hash_bytes(bytes_of(value, buffer), seed);
        }
    }
    return seed;
}

class LogSource : public ScanSource {
public:
    LogSource(PosedLog log, SourceFacts facts) : log_(std::move(log)), facts_(std::move(facts)) {}

    [[nodiscard]] const SourceFacts& facts() const override { return facts_; }
    [[nodiscard]] std::size_t num_done() const override { return num_done_; }
    [[nodiscard]] std::optional<Scan> next() override {
        if (num_done_ == log_.scans.size()) return std::nullopt;
        return log_.scans[num_done_++];
    }
    [[nodiscard]] std::string place() const override {
        return "line " + std::to_string(log_.lines[num_done_ - 1]);
    }

private:
    PosedLog log_;
    SourceFacts facts_;
    std::size_t num_done_ = 0;
};

}  // namespace

void skip_to(ScanSource& source, std::size_t num_done) {
    while (source.num_done() < num_done && source.next()) {
    }
}

std::unique_ptr<ScanSource> open_scan_source(InputFile file, const ScanSourceOptions& options) {
    LogFile read = parse_carmen_log(file.bytes, file.name, {options.max_range_m});
    SourceFacts facts{std::move(file.name), 0, read.content_hash, 0, std::move(read.warnings)};
    PosedLog log{std::move(read.scans), std::move(read.lines)};
    if (options.poses) replace_poses(*options.poses, log, facts);
    leave_out_far_scans(options.resolution_m, log, facts);
    facts.num_scans = log.scans.size();
    facts.scans_hash = hash_of(log.scans, facts.content_hash);
    return std::make_unique<LogSource>(std::move(log), std::move(facts));
}

}  // namespace quadcut::io
