// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/log_map.hpp"

#include <utility>

#include "apps/pose_match.hpp"
#include "io/carmen.hpp"
#include "io/poses.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/occupancy_map.hpp"

namespace quadcut {

PosedLog parse_posed_log(io::InputFile log, const std::optional<std::filesystem::path>& poses) {
    io::LogFile file = io::parse_carmen_log(log.bytes, log.name);
    PosedLog result{std::move(log.name), std::move(file.scans), std::move(file.warnings),
                    file.content_hash};
    if (poses) {
        const std::string name = io::display_name(*poses);
        PosedScans posed = with_poses(std::move(result.scans), io::read_poses(*poses), name);
        if (posed.num_left_out > 0) {
            result.warnings.push_back(name + ": no pose near " +
                                      std::to_string(posed.num_left_out) + " of the scans of " +
                                      result.name + "; they are left out");
        }
        result.scans = std::move(posed.scans);
    }
    return result;
}

LogMap map_log(io::InputFile log, const std::optional<std::filesystem::path>& poses,
               double resolution_m, StageClock& clock, Progress& progress) {
    clock.begin("read");
    PosedLog posed = parse_posed_log(std::move(log), poses);
    const std::vector<Scan>& scans = posed.scans;
    LogMap result;
    result.warnings = std::move(posed.warnings);
    result.content_hash = posed.content_hash;
    clock.begin("map");
    const OccupancyMap map = map_from_scans(scans, resolution_m, {}, [&](std::size_t num_done) {
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
