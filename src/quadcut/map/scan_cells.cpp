// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/scan_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace quadcut {
namespace {

// One beam in cells. reach: how far it was clear; 0 when it says nothing.
struct Beam {
    Point direction;
    double range = 0.0;
    double reach = 0.0;
    bool hits = false;
};

Point along(const Point& from, const Point& direction, double length) {
    return {from.x + direction.x * length, from.y + direction.y * length};
}

Cell cell_of(const Point& point) {
    return {static_cast<std::int32_t>(std::floor(point.x)),
            static_cast<std::int32_t>(std::floor(point.y))};
}

std::vector<Beam> beams_of(const Scan& scan, double resolution_m, double yaw_rad,
                           const SightModel& model) {
    std::vector<Beam> beams(scan.ranges_m.size());
    for (std::size_t i = 0; i < beams.size(); ++i) {
        const double range_m = scan.ranges_m[i];
        // Written so that NaN fails too.
        if (!(range_m > 0.0 && range_m < scan.max_range_m) || !std::isfinite(range_m)) {
            continue;
        }
        const double angle =
            yaw_rad + scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
        const double range = range_m / resolution_m;
        beams[i].direction = {std::cos(angle), std::sin(angle)};
        beams[i].range = std::min(range, model.usable_range);
        beams[i].reach = std::max(0.0, std::min(range - model.margin, model.usable_range));
        beams[i].hits = range <= model.usable_range;
    }
    return beams;
}

// How far the space between neighbouring beams was seen.
std::vector<double> reach_between(const std::vector<Beam>& beams, double angle_step_rad,
                                  const SightModel& model) {
    std::vector<double> reach(beams.size(), 0.0);
    const double limit = model.widest_gap / std::max(std::abs(angle_step_rad), 1e-9);
    for (std::size_t i = 0; i + 1 < beams.size(); ++i) {
        reach[i] = std::min({beams[i].reach, beams[i + 1].reach, limit});
    }
    return reach;
}

// Flips the first cell right of the edge in each row whose centre line it crosses.
void flip_edge(BitRaster& cells, Point a, Point b) {
    if (a.y > b.y) {
        std::swap(a, b);
    }
    const auto first = static_cast<std::int32_t>(std::ceil(a.y - 0.5));
    const auto end = static_cast<std::int32_t>(std::ceil(b.y - 0.5));
    const double slope = (b.x - a.x) / (b.y - a.y);
    for (std::int32_t y = first; y < end; ++y) {
        const double x = a.x + (y + 0.5 - a.y) * slope;
        cells.flip({static_cast<std::int32_t>(std::ceil(x - 0.5)), y});
    }
}

// Fills the star around the sensor that the spaces between beams first .. last - 1 make.
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

// Sets the cells that the straight line crosses (Amanatides and Woo 1987).
void set_line(BitRaster& cells, const Point& from, const Point& to) {
    Cell cell = cell_of(from);
    const Cell last = cell_of(to);
    const Point step{to.x - from.x, to.y - from.y};
    const Cell sign{step.x < 0 ? -1 : 1, step.y < 0 ? -1 : 1};
    // Along the line, 0 .. 1: to the next border between columns and rows, and between borders.
    const auto first_border = [](double start, double length, std::int32_t at, std::int32_t way) {
        return length == 0.0 ? 2.0 : ((way > 0 ? at + 1.0 : at) - start) / length;
    };
    Point next{first_border(from.x, step.x, cell.x, sign.x),
               first_border(from.y, step.y, cell.y, sign.y)};
    const Point every{step.x == 0.0 ? 2.0 : std::abs(1.0 / step.x),
                      step.y == 0.0 ? 2.0 : std::abs(1.0 / step.y)};
    int steps = std::abs(last.x - cell.x) + std::abs(last.y - cell.y);
    for (cells.set(cell); steps > 0; --steps) {
        if (next.x < next.y) {
            next.x += every.x;
            cell.x += sign.x;
        } else {
            next.y += every.y;
            cell.y += sign.y;
        }
        cells.set(cell);
    }
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

ScanCells cells_of(const Scan& scan, double resolution_m, const Pose& map_from_sensor,
                   const SightModel& model) {
    const Point sensor{map_from_sensor.x, map_from_sensor.y};
    const std::vector<Beam> beams = beams_of(scan, resolution_m, map_from_sensor.yaw_rad, model);
    const std::vector<double> reach = reach_between(beams, scan.angle_step_rad, model);
    const BitRaster empty = frame(sensor, beams);
    ScanCells cells{empty, empty};

    // A star that turns once around the sensor would cross itself if it turned further.
    const double step = std::max(std::abs(scan.angle_step_rad), 1e-9);
    const auto whole_turn =
        static_cast<std::size_t>(std::max(1.0, std::floor(2.0 * std::numbers::pi / step)));
    for (std::size_t first = 0; first + 1 < beams.size(); first += whole_turn) {
        BitRaster star = empty;
        fill_star(star, sensor, beams, reach, first,
                  std::min(first + whole_turn, beams.size() - 1));
        cells.free.add(star);
    }
    for (std::size_t i = 0; i < beams.size(); ++i) {
        const double seen = std::min(reach[i], i > 0 ? reach[i - 1] : 0.0);
        if (seen < beams[i].reach) {
            set_line(cells.free, along(sensor, beams[i].direction, seen),
                     along(sensor, beams[i].direction, beams[i].reach));
        }
        if (beams[i].hits) {
            cells.hit.set(cell_of(along(sensor, beams[i].direction, beams[i].range)));
        }
    }
    return cells;
}

}  // namespace quadcut
