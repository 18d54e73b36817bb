// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/integrate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "quadcut/base/error.hpp"
#include "quadcut/base/option_field.hpp"
#include "quadcut/map/line_walk.hpp"
#include "quadcut/map/scan_cells.hpp"

namespace quadcut {
namespace {

constexpr double kMaxAngle = 1e6;

// The sensor in the map, in cells.
Pose sensor_in_cells(const OccupancyMap& map, const Scan& scan) {
    const Pose& pose = scan.world_from_sensor;
    // Written so that NaN fails too.
    for (const double angle : {pose.yaw_rad, scan.first_angle_rad, scan.angle_step_rad}) {
        if (!(std::abs(angle) <= kMaxAngle)) {
            throw InputError("scan: an angle is " + std::to_string(angle) +
                             " rad, expected a number within a million");
        }
    }
    // Throws when the position is not finite or too far away.
    static_cast<void>(map.cell_at({pose.x, pose.y}));
    const Pose map_from_sensor = compose(inverse(map.world_from_map()), pose);
    return {map_from_sensor.x / map.resolution_m(), map_from_sensor.y / map.resolution_m(),
            map_from_sensor.yaw_rad};
}

// How far along the line, 0 .. 1, the first wall stands that the map is sure of; nothing if none.
std::optional<double> first_sure_wall(const OccupancyMap& map, const Point& from, const Point& to,
                                      int sure) {
    std::optional<double> wall;
    const Point way{to.x - from.x, to.y - from.y};
    const auto search = [&](double begin, double end) {
        walk_line(along(from, way, begin), along(from, way, end), [&](Cell cell, double t) {
            if (map.log_odds(cell) >= sure) wall = begin + t * (end - begin);
            return !wall;
        });
    };
    // Tile by tile first: most of a beam's way leads through blocks that are plainly free.
    double stretch = 2.0;  // where the stretch that is not began; beyond the end: nowhere
    walk_line({from.x / kTileSide, from.y / kTileSide}, {to.x / kTileSide, to.y / kTileSide},
              [&](Cell tile, double t) {
                  if (map.shared_log_odds(tile) >= sure) {
                      stretch = std::min(stretch, t);
                  } else if (stretch < 1.0) {
                      search(stretch, std::min(t, 1.0));
                      stretch = 2.0;
                  }
                  return !wall;
              });
    if (!wall && stretch < 1.0) search(stretch, 1.0);
    return wall;
}

// Ends beams before the walls that the map is sure of.
void stop_at_walls(std::vector<Beam>& beams, const OccupancyMap& map, const Point& sensor,
                   const IntegrateOptions& options) {
    const double first = options.trusted_range_m / map.resolution_m();
    const double tolerance = options.wall_tolerance_m / map.resolution_m();
    for (Beam& beam : beams) {
        const double last = beam.range - tolerance;
        if (last <= first) continue;
        if (const auto t = first_sure_wall(map, along(sensor, beam.direction, first),
                                           along(sensor, beam.direction, last), options.sure)) {
            const double distance = first + *t * (last - first);
            beam.reach = std::clamp(distance - options.margin_cells, 0.0, beam.reach);
            beam.hits = false;
        }
    }
}

bool is_near(Cell tile, const Point& sensor, double range) {
    const double x = (tile.x + 0.5) * kTileSide - sensor.x;
    const double y = (tile.y + 0.5) * kTileSide - sensor.y;
    return range > 0.0 && x * x + y * y < range * range;
}

// Around the lower left cells of the tiles.
Box box_of(std::span<const TileEvidence> evidence) {
    Box box;
    for (const TileEvidence& one : evidence) {
        box.include({first_cell_of(one.tile), first_cell_of(one.tile)});
    }
    return box;
}

}  // namespace

void add_fields(IntegrateOptions& options, std::vector<OptionField>& fields) {
    constexpr double kWholeRange = kMaxLogOdds - kMinLogOdds;
    fields.push_back({"scan.max_range", "m", 0.1, 1000.0,
                      "longer readings clear that far and hit nothing", "",
                      &options.usable_range_m});
    fields.push_back({"scan.widest_gap", "m", 0.001, 100.0,
                      "beams clear no further than where they are this far apart", "",
                      &options.widest_gap_m});
    fields.push_back({"scan.margin", "cells", 0.0, 100.0,
                      "how far before its end point a beam stops to clear", "",
                      &options.margin_cells});
    fields.push_back({"scan.trusted_range", "m", 0.0, 1000.0,
                      "up to here, a scan is believed against sure walls", "",
                      &options.trusted_range_m});
    fields.push_back({"scan.wall_tolerance", "m", 0.0, 100.0,
                      "an end point so far behind a sure wall still is the wall", "",
                      &options.wall_tolerance_m});
    fields.push_back({"scan.sure", "", 1, kMaxLogOdds + 1,
                      "log-odds from which on the map is sure of a wall", "", &options.sure});
    fields.push_back({"scan.hit", "", 1, kWholeRange,
                      "added to the log-odds of a cell with an end point", "", &options.hit});
    fields.push_back({"scan.miss", "", -kWholeRange, -1,
                      "added to the log-odds where a scan saw free space", "eq. (10)",
                      &options.miss});
}

IntegrateOptions latest_scan_wins(IntegrateOptions options) {
    options.sure = kMaxLogOdds + 1;
    options.hit = kMaxLogOdds - kMinLogOdds;
    options.miss = kMinLogOdds - kMaxLogOdds;
    return options;
}

float longest_reading_m(const Scan& scan) {
    float longest = 0.0F;
    for (const float range : scan.ranges_m) {
        if (std::isfinite(range) && range < scan.max_range_m) longest = std::max(longest, range);
    }
    return longest;
}

Box cells_in_reach(const OccupancyMap& map, const Scan& scan, const IntegrateOptions& options) {
    const Pose sensor = sensor_in_cells(map, scan);
    const double range_m = longest_reading_m(scan);
    if (!(range_m > 0.0)) return {};
    const double reach = std::min(range_m, options.usable_range_m) / map.resolution_m();
    const auto cells = static_cast<std::int32_t>(std::ceil(std::min(reach, kMaxRangeCells))) + 1;
    const Cell at = cell_of({sensor.x, sensor.y});
    return cells_of_tiles(
        {tile_of({at.x - cells, at.y - cells}), tile_of({at.x + cells, at.y + cells})});
}

std::vector<TileEvidence> evidence_of(const OccupancyMap& map, const Scan& scan,
                                      const IntegrateOptions& options) {
    const Pose pose = sensor_in_cells(map, scan);
    const Point sensor{pose.x, pose.y};
    std::vector<Beam> beams = beams_of(scan, pose.yaw_rad, map.resolution_m(), options);
    stop_at_walls(beams, map, sensor, options);
    // Eq. (10): the leaves in the sensor's range and in sight are those of these cells.
    const ScanCells cells = cells_of(beams, sensor, scan.angle_step_rad);

    const Cell origin = cells.free.origin();
    const double trusted_range = options.trusted_range_m / map.resolution_m();
    std::vector<TileEvidence> evidence;
    for (std::int32_t y = 0; y < cells.free.height() / kTileSide; ++y) {
        for (std::int32_t x = 0; x < cells.free.width() / kTileSide; ++x) {
            const Cell tile{origin.x / kTileSide + x, origin.y / kTileSide + y};
            const std::uint64_t hit = cells.hit.tile_rows(x, y);
            std::uint64_t miss = cells.free.tile_rows(x, y) & ~hit;
            if (miss != 0 && !map.is_uniform_tile(tile) && !is_near(tile, sensor, trusted_range)) {
                miss &= ~rows_at_least(map.tile(tile), std::max(1, options.sure));
            }
            if ((miss | hit) != 0) {
                evidence.push_back({tile, miss, hit});
            }
        }
    }
    return evidence;
}

void add_evidence(OccupancyMap& map, std::span<const TileEvidence> evidence,
                  const IntegrateOptions& options) {
    if (evidence.empty()) return;
    // Before the first write, so that a scan that passes the limits changes nothing.
    const Box box = box_of(evidence);
    map.reserve(box.low, box.high);
    for (const TileEvidence& one : evidence) {
        // Most of what a scan sees is a block that is as free as can be.
        if (one.hit == 0 && map.shared_log_odds(one.tile) == kMinLogOdds) continue;
        map.set_tile(one.tile, bounded_sums(map.tile(one.tile), one.hit, options.hit, one.miss,
                                            options.miss));
    }
}

MapUpdate integrate_scan(OccupancyMap& map, const Scan& scan, const IntegrateOptions& options) {
    const std::vector<TileEvidence> evidence = evidence_of(map, scan, options);
    add_evidence(map, evidence, options);
    MapUpdate update = map.commit();
    const Box box = box_of(evidence);
    if (!box.is_empty()) update.covering = map.block_around(box.low, box.high);
    update.observed.reserve(evidence.size());
    update.observed_free.reserve(evidence.size());
    for (const TileEvidence& one : evidence) {
        update.observed.push_back(one.tile);
        update.observed_free.push_back(one.miss);
    }
    return update;
}

OccupancyMap map_from_scans(const NextScan& next, double resolution_m,
                            const IntegrateOptions& options, const ScanProgress& progress) {
    // The tree is brought up to date now and then, which keeps the map collapsed.
    constexpr std::size_t kScansPerCommit = 16;
    OccupancyMap map(resolution_m);
    std::size_t num_done = 0;
    while (const std::optional<Scan> scan = next()) {
        try {
            add_evidence(map, evidence_of(map, *scan, options), options);
        } catch (const InputError& error) {
            throw InputError("scan " + std::to_string(num_done) + ": " + error.what());
        }
        if (++num_done % kScansPerCommit == 0) map.commit();
        if (progress) progress(num_done);
    }
    map.commit();
    map.shrink_to_fit();
    return map;
}

OccupancyMap map_from_scans(std::span<const Scan> scans, double resolution_m,
                            const IntegrateOptions& options, const ScanProgress& progress) {
    const auto next = [scans]() mutable {
        std::optional<Scan> scan;
        if (!scans.empty()) {
            scan = scans.front();
            scans = scans.subspan(1);
        }
        return scan;
    };
    return map_from_scans(next, resolution_m, options, progress);
}

}  // namespace quadcut
