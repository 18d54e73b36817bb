// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/scanned_map.hpp"

#include <optional>

#include "quadcut/base/error.hpp"
#include "quadcut/map/occupancy_map.hpp"

namespace quadcut::io {

ScannedMap map_scans(ScanSource& source, double resolution_m, const IntegrateOptions& integrate,
                     const ScanProgress& progress) {
    ScannedMap result;
    const auto next = [&] {
        std::optional<Scan> scan = source.next();
        if (scan)
            result.trajectory.push_back({scan->world_from_sensor.x, scan->world_from_sensor.y});
        return scan;
    };
    const OccupancyMap map = map_from_scans(next, resolution_m, integrate, progress);
    result.map = map.to_grid();
    if (result.map.states.values.empty()) {
        throw InputError(source.facts().name +
                         ": no reading says anything: expected ranges above 0 that hit something");
    }
    result.num_leaves = map.num_leaves();
    return result;
}

}  // namespace quadcut::io
