// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/counted_map.hpp"

#include <algorithm>
#include <cmath>

#include "sim/shape.hpp"

namespace quadcut::sim {
namespace {

struct Count {
    std::uint32_t visits = 0;
    std::uint32_t hits = 0;
};

template <typename Visit>
void for_each_beam(const Scan& scan, const Visit& visit) {
    const Pose& pose = scan.world_from_sensor;
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
        const auto range = static_cast<double>(scan.ranges_m[i]);
        if (!(range > 0.0) || range >= scan.max_range_m) continue;
        const double angle =
            pose.yaw_rad + scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
        visit(Point{pose.x, pose.y}, Point{std::cos(angle), std::sin(angle)}, range);
    }
}

}  // namespace

GridMap counted_map(std::span<const Scan> scans, double resolution_m,
                    const CountedMapOptions& options) {
    Rect box = kNoRect;
    for (const Scan& scan : scans) {
        for_each_beam(scan, [&](const Point& from, const Point& u, double range) {
            box.include({from, {from.x + range * u.x, from.y + range * u.y}});
        });
    }
    GridMap map;
    map.resolution_m = resolution_m;
    map.map_from_image = {std::floor(box.x0 / resolution_m) * resolution_m,
                          std::floor(box.y0 / resolution_m) * resolution_m, 0.0};
    const auto cells = [&](double length) {
        return static_cast<std::int32_t>(length / resolution_m) + 2;
    };
    Raster<Count> counts({0, 0}, cells(box.width()), cells(box.height()));
    for (const Scan& scan : scans) {
        for_each_beam(scan, [&](const Point& from, const Point& u, double range) {
            const double x = (from.x - map.map_from_image.x) / resolution_m;
            const double y = (from.y - map.map_from_image.y) / resolution_m;
            const auto cell_at = [&](double t) {
                return Cell{static_cast<std::int32_t>(x + t * u.x),
                            static_cast<std::int32_t>(y + t * u.y)};
            };
            const double steps = std::max(std::abs(u.x), std::abs(u.y));
            const Cell end = cell_at(range / resolution_m);
            for (double t = 0.0; t < range / resolution_m; t += 1.0 / steps) {
                const Cell cell = cell_at(t);
                if (!(cell == end)) ++counts.at(cell).visits;
            }
            ++counts.at(end).visits;
            ++counts.at(end).hits;
        });
    }
    map.states = Raster<CellState>({0, 0}, counts.width, counts.height);
    for (std::size_t i = 0; i < counts.values.size(); ++i) {
        const Count& count = counts.values[i];
        if (count.visits < std::max(options.least_visits, 1U)) continue;
        const double share = static_cast<double>(count.hits) / count.visits;
        if (share < options.free_below) map.states.values[i] = CellState::free;
        if (share > options.occupied_above) map.states.values[i] = CellState::occupied;
    }
    return map;
}

}  // namespace quadcut::sim
