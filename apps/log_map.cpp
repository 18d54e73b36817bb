// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/log_map.hpp"

#include <utility>

#include "apps/far_scans.hpp"
#include "apps/pose_match.hpp"
#include "io/carmen.hpp"
#include "io/poses.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/map/occupancy_map.hpp"

namespace quadcut {

namespace {

/// Gives the scans the poses of a file.
void replace_poses(const std::filesystem::path& poses, PosedLog& posed) {
    const std::string name = io::display_name(poses);
    PosedScans matched = with_poses(std::move(posed.scans), io::read_poses(poses), name);
    if (matched.num_left_out > 0) {
        posed.warnings.push_back(name + ": no pose near " + std::to_string(matched.num_left_out) +
                                 " of the scans of " + posed.name + "; they are left out");
    }
    posed.scans = std::move(matched.scans);
    std::vector<std::uint64_t> lines;
    for (const std::size_t place : matched.places) lines.push_back(posed.lines[place]);
    posed.lines = std::move(lines);
}

/// One map is made of all, whatever command makes it.
void leave_out_far_scans(double resolution_m, PosedLog& posed) {
    const FarScans far = find_far_scans(posed.scans, resolution_m);
    if (far.count == 0) return;
    const std::size_t num_scans = posed.scans.size();
    const std::string what =
        posed.name + ": line " + std::to_string(posed.lines[far.first]) + ": " + far.reason;
    if (far.count == num_scans) throw InputError(what + "; nor can any other scan be used");
    posed.warnings.push_back(what + "; left out (" + std::to_string(far.count) + " of " +
                             std::to_string(num_scans) + " scans)");
    std::size_t num_kept = 0;
    for (std::size_t i = 0; i < num_scans; ++i) {
        if (far.is_far[i]) continue;
        // Nothing is moved onto itself.
        if (num_kept != i) posed.scans[num_kept] = std::move(posed.scans[i]);
        posed.lines[num_kept++] = posed.lines[i];
    }
    posed.scans.resize(num_kept);
    posed.lines.resize(num_kept);
}

}  // namespace

PosedLog parse_posed_log(io::InputFile log, const std::optional<std::filesystem::path>& poses,
                         double resolution_m) {
    io::LogFile file = io::parse_carmen_log(log.bytes, log.name);
    PosedLog posed{std::move(log.name), std::move(file.scans), std::move(file.lines),
                   std::move(file.warnings), file.content_hash};
    if (poses) replace_poses(*poses, posed);
    leave_out_far_scans(resolution_m, posed);
    return posed;
}

LogMap map_log(io::InputFile log, const std::optional<std::filesystem::path>& poses,
               double resolution_m, const IntegrateOptions& integrate, StageClock& clock,
               Progress& progress) {
    clock.begin("read");
    PosedLog posed = parse_posed_log(std::move(log), poses, resolution_m);
    const std::vector<Scan>& scans = posed.scans;
    LogMap result;
    result.warnings = std::move(posed.warnings);
    result.content_hash = posed.content_hash;
    clock.begin("map");
    const OccupancyMap map =
        map_from_scans(scans, resolution_m, integrate, [&](std::size_t num_done) {
            progress.update(num_done, scans.size(), {"scans", {}});
        });
    result.map = map.to_grid();
    if (result.map.states.values.empty()) {
        throw InputError(posed.name +
                         ": no reading says anything: expected ranges above 0 that hit something");
    }
    result.num_leaves = map.num_leaves();
    result.trajectory.reserve(scans.size());
    for (const Scan& scan : scans) {
        result.trajectory.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
    }
    return result;
}

}  // namespace quadcut
