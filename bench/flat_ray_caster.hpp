// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "quadcut/map/line_walk.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut {

/// The plainest map there is: one byte a cell, each beam drawn by Bresenham's line. What scans are
/// compared with in time and memory.
class FlatRayCaster {
public:
    /// Room for all scans at once, so that it never grows.
    FlatRayCaster(std::span<const Scan> scans, double resolution_m, double usable_range_m)
        : resolution_m_(resolution_m), usable_range_m_(usable_range_m) {
        Box box;
        for (const Scan& scan : scans) {
            const Point at{scan.world_from_sensor.x, scan.world_from_sensor.y};
            for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
                if (says_something(scan, i)) box.include({cell(at), cell(at)});
                if (says_something(scan, i)) box.include({end_of(scan, i), end_of(scan, i)});
            }
        }
        if (!box.is_empty()) cells_ = Raster<std::int8_t>(box);
    }

    void add(const Scan& scan) {
        const Cell from = cell({scan.world_from_sensor.x, scan.world_from_sensor.y});
        for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
            if (!says_something(scan, i)) continue;
            const Cell to = end_of(scan, i);
            draw(from, to);
            change(to, 3);
        }
    }
    [[nodiscard]] std::size_t bytes() const { return cells_.values.size(); }
    /// Those whose log-odds are not 0. O(cells).
    [[nodiscard]] std::size_t num_known_cells() const {
        return cells_.values.size() -
               static_cast<std::size_t>(std::count(cells_.values.begin(), cells_.values.end(), 0));
    }

private:
    [[nodiscard]] Cell cell(const Point& at) const {
        return cell_of({at.x / resolution_m_, at.y / resolution_m_});
    }
    [[nodiscard]] bool says_something(const Scan& scan, std::size_t i) const {
        const float range = scan.ranges_m[i];
        return std::isfinite(range) && range > 0.0F &&
               static_cast<double>(range) < std::min(scan.max_range_m, usable_range_m_);
    }
    [[nodiscard]] Cell end_of(const Scan& scan, std::size_t i) const {
        const Pose& pose = scan.world_from_sensor;
        const double angle =
            pose.yaw_rad + scan.first_angle_rad + scan.angle_step_rad * static_cast<double>(i);
        return cell(along({pose.x, pose.y}, {std::cos(angle), std::sin(angle)},
                          static_cast<double>(scan.ranges_m[i])));
    }
    void change(Cell at, int by) {
        std::int8_t& value = cells_.at(at);
        value = static_cast<std::int8_t>(std::clamp(value + by, -4, 11));
    }
    void draw(Cell at, Cell to) {
        const std::int32_t dx = std::abs(to.x - at.x);
        const std::int32_t dy = -std::abs(to.y - at.y);
        const std::int32_t step_x = at.x < to.x ? 1 : -1;
        const std::int32_t step_y = at.y < to.y ? 1 : -1;
        std::int32_t error = dx + dy;
        while (at != to) {
            change(at, -1);
            const std::int32_t twice = 2 * error;
            if (twice >= dy) {
                error += dy;
                at.x += step_x;
            }
            if (twice <= dx) {
                error += dx;
                at.y += step_y;
            }
        }
    }

    double resolution_m_;
    double usable_range_m_;
    Raster<std::int8_t> cells_;
};

}  // namespace quadcut
