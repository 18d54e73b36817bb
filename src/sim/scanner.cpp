// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/scanner.hpp"

#include <algorithm>
#include <cmath>

namespace quadcut::sim {
namespace {

GridMap open_glass(const World& world) {
    GridMap map = world.map;
    for (std::size_t i = 0; i < world.glass.values.size(); ++i) {
        if (world.glass.values[i] != 0) map.states.values[i] = CellState::unknown;
    }
    return map;
}

}  // namespace

Scanner::Scanner(const World& world, const ScannerOptions& options, Random random)
    : options_(options),
      random_(random),
      resolution_m_(world.map.resolution_m),
      origin_{world.map.map_from_image.x, world.map.map_from_image.y},
      glass_(world.glass),
      all_(world.map),
      without_glass_(open_glass(world)) {}

std::uint8_t Scanner::glass_at(const Point& p) const {
    const Cell cell{static_cast<std::int32_t>(std::floor((p.x - origin_.x) / resolution_m_)),
                    static_cast<std::int32_t>(std::floor((p.y - origin_.y) / resolution_m_))};
    return glass_.contains(cell) ? glass_.at(cell) : std::uint8_t{0};
}

// A beam passes all panes and legs or is returned by the first.
double Scanner::range_of(const Point& from, double angle) {
    const double most = options_.laser.max_range_m;
    const double range = all_.cast(from, angle, most);
    if (range >= most) return most;
    const double inside = range + 0.01 * resolution_m_;
    const std::uint8_t glass =
        glass_at({from.x + inside * std::cos(angle), from.y + inside * std::sin(angle)});
    if (glass == 0) return range;
    if (glass == World::kThin) {
        const bool is_met = random_.uniform() >= options_.passes;
        return is_met ? range : without_glass_.cast(from, angle, most);
    }
    const double slant = std::remainder(angle - (glass - 1) * M_PI / 180.0, M_PI);
    if (std::abs(slant) < options_.square_rad || random_.uniform() < options_.glints) return range;
    return without_glass_.cast(from, angle, most);
}

void Scanner::walk(const Pose& robot) {
    for (Person& person : people_) {
        person.at = {person.at.x + person.step.x, person.at.y + person.step.y};
        --person.num_scans;
    }
    people_.erase(std::remove_if(people_.begin(), people_.end(),
                                 [](const Person& person) { return person.num_scans <= 0; }),
                  people_.end());
    if (random_.uniform() >= options_.people) return;
    const double angle =
        robot.yaw_rad + random_.uniform(-0.5, 0.5) * options_.laser.field_of_view_rad;
    const double away = random_.uniform(0.7, 5.0);
    const Point from{robot.x, robot.y};
    const double heading = random_.uniform(-M_PI, M_PI);
    const double pace = random_.uniform() < 0.5 ? 0.02 : random_.uniform(0.1, 0.5);
    const auto num_scans = 1 + static_cast<int>(random_.below(12));
    if (all_.cast(from, angle, away + 0.3) < away + 0.3) return;
    people_.push_back({{from.x + away * std::cos(angle), from.y + away * std::sin(angle)},
                       {pace * std::cos(heading), pace * std::sin(heading)},
                       num_scans});
}

// Two legs a person.
void Scanner::stand_in_the_way(Scan& scan) const {
    constexpr double kLeg = 0.07;
    constexpr double kStride = 0.13;
    const Pose& pose = scan.world_from_sensor;
    for (const Person& person : people_) {
        for (const double side : {-kStride, kStride}) {
            const double dx = person.at.x + side - pose.x;
            const double dy = person.at.y + 0.5 * side - pose.y;
            const double away = std::hypot(dx, dy);
            if (away < 2.0 * kLeg) continue;
            const double middle = std::remainder(
                std::atan2(dy, dx) - pose.yaw_rad - scan.first_angle_rad, 2.0 * M_PI);
            const double half = std::asin(kLeg / away);
            const double first = std::ceil((middle - half) / scan.angle_step_rad);
            const double last = std::floor((middle + half) / scan.angle_step_rad);
            for (double i = std::max(0.0, first); i <= last; ++i) {
                const auto beam = static_cast<std::size_t>(i);
                if (beam >= scan.ranges_m.size()) break;
                scan.ranges_m[beam] =
                    std::min(scan.ranges_m[beam], static_cast<float>(away - kLeg));
            }
        }
    }
}

Scan Scanner::scan(const Pose& world_from_sensor) {
    const LaserOptions& laser = options_.laser;
    Scan scan;
    scan.world_from_sensor = world_from_sensor;
    scan.first_angle_rad = -0.5 * laser.field_of_view_rad;
    scan.angle_step_rad = laser.angle_step_rad;
    scan.max_range_m = laser.max_range_m;
    const int num_beams = laser.num_beams();
    scan.ranges_m.reserve(static_cast<std::size_t>(num_beams));
    for (int i = 0; i < num_beams; ++i) {
        const double angle =
            world_from_sensor.yaw_rad + scan.first_angle_rad + i * scan.angle_step_rad;
        const double range = range_of({world_from_sensor.x, world_from_sensor.y}, angle);
        const bool is_lost = random_.uniform() < laser.dropout;
        const double noisy = std::max(0.01, range + laser.range_noise_m * random_.normal());
        const bool is_none = is_lost || range >= laser.max_range_m;
        scan.ranges_m.push_back(static_cast<float>(is_none ? laser.max_range_m : noisy));
    }
    walk(world_from_sensor);
    stand_in_the_way(scan);
    return scan;
}

}  // namespace quadcut::sim
