// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/integrate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "quadcut/base/error.hpp"
#include "quadcut/map/scan_cells.hpp"

namespace quadcut {
namespace {

constexpr double kMaxRangeCells = 8192.0;

Pose sensor_in_cells(const OccupancyMap& map, const Scan& scan) {
    const Pose& pose = scan.world_from_sensor;
    if (!std::isfinite(pose.yaw_rad) || !std::isfinite(scan.first_angle_rad) ||
        !std::isfinite(scan.angle_step_rad)) {
        throw InputError("scan: an angle is not a finite number");
    }
    // Throws when the position is not finite or too far away.
    static_cast<void>(map.cell_at({pose.x, pose.y}));
    const Pose map_from_sensor = compose(inverse(map.world_from_map()), pose);
    return {map_from_sensor.x / map.resolution_m(), map_from_sensor.y / map.resolution_m(),
            map_from_sensor.yaw_rad};
}

SightModel sight_model(const OccupancyMap& map, const IntegrateOptions& options) {
    const double usable_range = options.usable_range_m / map.resolution_m();
    if (!(usable_range > 0.0 && usable_range <= kMaxRangeCells)) {
        throw InputError("scan: the usable range is " + std::to_string(usable_range) +
                         " cells, expected up to 8192");
    }
    return {usable_range, options.widest_gap_m / map.resolution_m(), options.margin_cells};
}

// The lowest and the highest cell of the tiles that the scan says something about.
struct ObservedBox {
    Cell low{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max()};
    Cell high{std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min()};

    void add(Cell tile) {
        low = {std::min(low.x, tile.x * kTileSide), std::min(low.y, tile.y * kTileSide)};
        high = {std::max(high.x, tile.x * kTileSide + kTileSide - 1),
                std::max(high.y, tile.y * kTileSide + kTileSide - 1)};
    }
};

// Adds without commit. Returns the observed box, low.x > high.x when nothing was observed.
ObservedBox add_scan(OccupancyMap& map, const Scan& scan, const IntegrateOptions& options) {
    const ScanCells cells =
        cells_of(scan, map.resolution_m(), sensor_in_cells(map, scan), sight_model(map, options));
    const Cell origin = cells.free.origin();
    ObservedBox box;
    const auto for_each_tile = [&](const auto& visit) {
        for (std::int32_t y = 0; y < cells.free.height() / kTileSide; ++y) {
            for (std::int32_t x = 0; x < cells.free.width() / kTileSide; ++x) {
                const std::uint64_t free = cells.free.tile_rows(x, y);
                const std::uint64_t hit = cells.hit.tile_rows(x, y);
                if ((free | hit) != 0) {
                    visit(Cell{origin.x / kTileSide + x, origin.y / kTileSide + y}, free, hit);
                }
            }
        }
    };
    for_each_tile([&](Cell tile, std::uint64_t, std::uint64_t) { box.add(tile); });
    if (box.low.x > box.high.x) {
        return box;
    }
    // Before the first write, so that a scan that leaves the limits changes nothing.
    map.reserve(box.low, box.high);
    for_each_tile([&](Cell tile, std::uint64_t free, std::uint64_t hit) {
        map.add_log_odds_in_tile(tile, free & ~hit, options.miss);
        map.add_log_odds_in_tile(tile, hit, options.hit);
    });
    return box;
}

}  // namespace

IntegrateOptions latest_scan_wins() {
    IntegrateOptions options;
    options.hit = kMaxLogOdds - kMinLogOdds;
    options.miss = kMinLogOdds - kMaxLogOdds;
    return options;
}

MapUpdate integrate_scan(OccupancyMap& map, const Scan& scan, const IntegrateOptions& options) {
    const ObservedBox box = add_scan(map, scan, options);
    MapUpdate update = map.commit();
    if (box.low.x <= box.high.x) {
        update.covering = map.block_around(box.low, box.high);
    }
    return update;
}

OccupancyMap map_from_scans(std::span<const Scan> scans, double resolution_m,
                            const IntegrateOptions& options, const ScanProgress& progress) {
    // The tree is brought up to date now and then, which keeps the map collapsed.
    constexpr std::size_t kScansPerCommit = 16;
    OccupancyMap map(resolution_m);
    for (std::size_t i = 0; i < scans.size(); ++i) {
        try {
            add_scan(map, scans[i], options);
        } catch (const InputError& error) {
            throw InputError("scan " + std::to_string(i) + ": " + error.what());
        }
        if ((i + 1) % kScansPerCommit == 0 || i + 1 == scans.size()) {
            map.commit();
        }
        if (progress) {
            progress(i + 1);
        }
    }
    return map;
}

}  // namespace quadcut
