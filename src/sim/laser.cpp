// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/laser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quadcut/map/line_walk.hpp"

namespace quadcut::sim {
namespace {

// Two sweeps, each taking the least of the neighbours already done.
void chessboard_distance(Raster<std::uint8_t>& reach) {
    const auto relax = [&](Cell c, int dx, int dy) {
        const Cell next{c.x + dx, c.y + dy};
        if (!reach.contains(next)) return;
        std::uint8_t& value = reach.at(c);
        const std::uint8_t other = reach.at(next);
        if (other < value) value = static_cast<std::uint8_t>(std::min<int>(value, other + 1));
    };
    for (std::int32_t y = reach.origin.y; y < reach.origin.y + reach.height; ++y) {
        for (std::int32_t x = reach.origin.x; x < reach.origin.x + reach.width; ++x) {
            for (const int dx : {-1, 0, 1}) relax({x, y}, dx, -1);
            relax({x, y}, -1, 0);
        }
    }
    for (std::int32_t y = reach.origin.y + reach.height - 1; y >= reach.origin.y; --y) {
        for (std::int32_t x = reach.origin.x + reach.width - 1; x >= reach.origin.x; --x) {
            for (const int dx : {-1, 0, 1}) relax({x, y}, dx, 1);
            relax({x, y}, 1, 0);
        }
    }
}

// One axis of a ray, in cells.
struct Axis {
    double origin;
    double direction;
    double inverse;
    std::int32_t cell;

    Axis(double from, double along)
        : origin(from),
          direction(along),
          inverse(along != 0.0 ? 1.0 / along : std::numeric_limits<double>::infinity()),
          cell(floor_to_int(from)) {}

    // Where the ray leaves the square of cells within `margin` of its cell.
    [[nodiscard]] double exit(std::int32_t margin) const {
        if (direction > 0.0) return (cell + margin + 1 - origin) * inverse;
        if (direction < 0.0) return (cell - margin - origin) * inverse;
        return inverse;
    }
    void step_out(std::int32_t margin) { cell += direction > 0.0 ? margin + 1 : -margin - 1; }
    void follow(double t, std::int32_t margin) {
        cell = std::clamp(floor_to_int(origin + t * direction), cell - margin, cell + margin);
    }
};

}  // namespace

int LaserOptions::num_beams() const {
    return static_cast<int>(std::lround(field_of_view_rad / angle_step_rad)) + 1;
}

RayCaster::RayCaster(const GridMap& world)
    : resolution_m_(world.resolution_m),
      image_from_map_(inverse(world.map_from_image)),
      reach_(world.states.origin, world.states.width, world.states.height, 255) {
    for (std::size_t i = 0; i < reach_.values.size(); ++i) {
        if (world.states.values[i] == CellState::occupied) reach_.values[i] = 0;
    }
    chessboard_distance(reach_);
}

double RayCaster::cast(const Point& from, double angle_rad, double max_range_m) const {
    const Point p = transform(image_from_map_, from);
    const double angle = angle_rad + image_from_map_.yaw_rad;
    Axis x(p.x / resolution_m_, std::cos(angle));
    Axis y(p.y / resolution_m_, std::sin(angle));
    const double end = max_range_m / resolution_m_;
    double t = 0.0;
    while (t < end) {
        const Cell cell{x.cell, y.cell};
        if (!reach_.contains(cell)) return max_range_m;
        const std::uint8_t reach = reach_.at(cell);
        if (reach == 0) return t * resolution_m_;
        const std::int32_t margin = reach - 1;
        const double exit_x = x.exit(margin);
        const double exit_y = y.exit(margin);
        if (exit_x <= exit_y) {
            t = exit_x;
            x.step_out(margin);
            y.follow(t, margin);
        } else {
            t = exit_y;
            y.step_out(margin);
            x.follow(t, margin);
        }
    }
    return max_range_m;
}

Scan simulate_scan(const RayCaster& world, const Pose& world_from_sensor,
                   const LaserOptions& options, Random& random) {
    Scan scan;
    scan.world_from_sensor = world_from_sensor;
    scan.first_angle_rad = -0.5 * options.field_of_view_rad;
    scan.angle_step_rad = options.angle_step_rad;
    scan.max_range_m = options.max_range_m;
    const int num_beams = options.num_beams();
    scan.ranges_m.reserve(static_cast<std::size_t>(num_beams));
    const Point from{world_from_sensor.x, world_from_sensor.y};
    for (int i = 0; i < num_beams; ++i) {
        const double angle =
            world_from_sensor.yaw_rad + scan.first_angle_rad + i * options.angle_step_rad;
        double range = world.cast(from, angle, options.max_range_m);
        const bool is_lost = random.uniform() < options.dropout;
        if (is_lost) range = options.max_range_m;
        if (range < options.max_range_m) {
            constexpr double kLeastRange = 0.01;
            range = std::clamp(range + options.range_noise_m * random.normal(), kLeastRange,
                               options.max_range_m);
        }
        scan.ranges_m.push_back(static_cast<float>(range));
    }
    return scan;
}

}  // namespace quadcut::sim
