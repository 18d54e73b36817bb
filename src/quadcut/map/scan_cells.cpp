// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/scan_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "quadcut/base/error.hpp"
#include "quadcut/map/line_walk.hpp"

namespace quadcut {
namespace {

// Flips the first cell right of the edge in each row whose centre line it crosses.
void flip_edge(BitRaster& cells, Point a, Point b) {
    if (a.y > b.y) std::swap(a, b);
    const std::int32_t first = ceil_to_int(a.y - 0.5);
    const std::int32_t end = ceil_to_int(b.y - 0.5);
    const double slope = (b.x - a.x) / (b.y - a.y);
    for (std::int32_t y = first; y < end; ++y) {
        const double x = a.x + (y + 0.5 - a.y) * slope;
        cells.flip({ceil_to_int(x - 0.5), y});
    }
}

// Fills the star around the sensor that the spaces between beams first .. last make; `reach` is
// how far each of these spaces was seen.
void fill_star(BitRaster& cells, const Point& sensor, const std::vector<Beam>& beams,
               const std::vector<double>& reach, std::size_t first, std::size_t last) {
    Point at = sensor;
    const auto go_to = [&](const Point& next) {
        flip_edge(cells, at, next);
        at = next;
    };
    for (std::size_t i = first; i < last; ++i) {
        go_to(along(sensor, beams[i].direction, reach[i]));
        go_to(along(sensor, beams[i + 1].direction, reach[i]));
    }
    go_to(sensor);
    cells.accumulate_parity();
}

BitRaster frame(const Point& sensor, const std::vector<Beam>& beams) {
    Point low = sensor;
    Point high = sensor;
    for (const Beam& beam : beams) {
        const Point end = along(sensor, beam.direction, beam.range);
        low = {std::min(low.x, end.x), std::min(low.y, end.y)};
        high = {std::max(high.x, end.x), std::max(high.y, end.y)};
    }
    return {cell_of(low), cell_of(high)};
}

}  // namespace

std::vector<Beam> beams_of(const Scan& scan, double sensor_yaw_rad, double resolution_m,
                           const IntegrateOptions& options) {
    const double longest = options.usable_range_m / resolution_m;
    if (!(longest > 0.0 && longest <= kMaxRangeCells)) {
        throw InputError("scan: the usable range is " + std::to_string(longest) +
                         " cells, expected 1 to 8192");
    }
    std::vector<Beam> beams(scan.ranges_m.size());
    const double step = std::abs(scan.angle_step_rad);
    const double usable =
        std::min(longest, options.widest_gap_m / resolution_m / std::max(step, 1e-9));
    for (std::size_t i = 0; i < beams.size(); ++i) {
        const double range_m = scan.ranges_m[i];
        // Written so that NaN fails too.
        if (!(range_m > 0.0 && range_m < scan.max_range_m) || !std::isfinite(range_m)) continue;
        const double angle =
            sensor_yaw_rad + scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
        const double range = range_m / resolution_m;
        beams[i] = {{std::cos(angle), std::sin(angle)},
                    std::min(range, usable),
                    std::clamp(range - options.margin_cells, 0.0, usable),
                    range <= usable};
    }
    return beams;
}

ScanCells cells_of(const std::vector<Beam>& beams, const Point& sensor, double angle_step_rad) {
    std::vector<double> reach(beams.size(), 0.0);
    for (std::size_t i = 0; i + 1 < beams.size(); ++i) {
        reach[i] = std::min(beams[i].reach, beams[i + 1].reach);
    }
    const BitRaster empty = frame(sensor, beams);
    ScanCells cells{empty, empty};

    // A star that turns once around the sensor would cross itself if it turned further.
    const double num_in_turn = 2.0 * std::numbers::pi / std::max(std::abs(angle_step_rad), 1e-9);
    const auto whole_turn = static_cast<std::size_t>(std::max(1.0, std::floor(num_in_turn)));
    if (beams.size() > 1) {
        fill_star(cells.free, sensor, beams, reach, 0, std::min(whole_turn, beams.size() - 1));
    }
    for (std::size_t first = whole_turn; first + 1 < beams.size(); first += whole_turn) {
        BitRaster star = empty;
        fill_star(star, sensor, beams, reach, first,
                  std::min(first + whole_turn, beams.size() - 1));
        cells.free.add(star);
    }
    for (std::size_t i = 0; i < beams.size(); ++i) {
        const double seen = std::min(reach[i], i > 0 ? reach[i - 1] : 0.0);
        if (seen < beams[i].reach) {
            walk_line(along(sensor, beams[i].direction, seen),
                      along(sensor, beams[i].direction, beams[i].reach), [&](Cell cell, double) {
                          cells.free.set(cell);
                          return true;
                      });
        }
        if (beams[i].hits) {
            cells.hit.set(cell_of(along(sensor, beams[i].direction, beams[i].range)));
        }
    }
    return cells;
}

}  // namespace quadcut
