// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/robot.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "quadcut/map/clearance.hpp"
#include "sim/route.hpp"

namespace quadcut::sim {
namespace {

// What the robot looks for: so much floor it has not seen, m2, within kLookAround of a place. In
// the first round a place to stand on, in the second one corners that it can only look into. It
// goes there until next to nothing is left.
constexpr double kLookAround = 0.45;
constexpr double kLeastPlace = 0.5;
constexpr double kLeastCorner = 0.25;
constexpr double kContent = 0.02;

double wrapped(double angle) { return std::remainder(angle, 2.0 * M_PI); }

// Errors of the reported poses: each keeps a part of the one before (AR(1)), so that the
// standard deviation stays what it is.
class PoseNoise {
public:
    PoseNoise(const RobotOptions& options, Random random) : options_(options), random_(random) {}

    Pose draw() {
        const double keep = is_first_ ? 0.0 : options_.pose_correlation;
        const double fresh = std::sqrt(1.0 - keep * keep);
        is_first_ = false;
        const auto blend = [&](double old, double sigma) {
            return keep * old + fresh * sigma * random_.normal();
        };
        error_.x = blend(error_.x, options_.pose_noise_m);
        error_.y = blend(error_.y, options_.pose_noise_m);
        error_.yaw_rad = blend(error_.yaw_rad, options_.pose_noise_rad);
        return error_;
    }

private:
    RobotOptions options_;
    Random random_;
    Pose error_;
    bool is_first_ = true;
};

}  // namespace

class Explorer::Drive {
public:
    Drive(const GridMap& world, const Pose& start, const RobotOptions& options,
          Raster<std::uint8_t> seen)
        : options_(options),
          caster_(world),
          routes_(world, options.radius_m),
          noise_(options, Random(options.seed).fork(1)),
          laser_random_(Random(options.seed).fork(2)),
          resolution_m_(world.resolution_m),
          origin_{world.map_from_image.x, world.map_from_image.y},
          pose_(start),
          states_(world.states),
          seen_(std::move(seen)) {
        if (!routes_.fits({start.x, start.y})) {
            throw std::logic_error("Explorer: the robot does not fit at its start");
        }
    }

    std::optional<KeyScan> next();

private:
    [[nodiscard]] Cell cell(const Point& p) const {
        return {static_cast<std::int32_t>(std::floor((p.x - origin_.x) / resolution_m_)),
                static_cast<std::int32_t>(std::floor((p.y - origin_.y) / resolution_m_))};
    }
    [[nodiscard]] bool is_unseen_floor(const Point& p) const {
        const Cell c = cell(p);
        return states_.contains(c) && states_.at(c) == CellState::free && seen_.at(c) == 0;
    }
    [[nodiscard]] double unseen_around(const Point& p) const;
    void mark_around(const Point& p, double radius);
    void mark_seen();
    bool plan();
    bool tick();
    KeyScan take_scan();

    RobotOptions options_;
    RayCaster caster_;
    RouteFinder routes_;
    PoseNoise noise_;
    Random laser_random_;
    double resolution_m_;
    Point origin_;
    Pose pose_;
    Raster<CellState> states_;
    Raster<std::uint8_t> seen_;
    std::vector<Point> way_;
    std::size_t next_point_ = 0;
    // First all places that the robot can stand on, then what it can only look at.
    bool only_corners_left_ = false;
    std::optional<Pose> last_key_;
    std::int64_t num_ticks_ = 0;
};

// Floor around a place that has not been seen, m2.
double Explorer::Drive::unseen_around(const Point& p) const {
    const Cell c = cell(p);
    const auto reach = static_cast<std::int32_t>(kLookAround / resolution_m_);
    int count = 0;
    for (std::int32_t y = c.y - reach; y <= c.y + reach; ++y) {
        for (std::int32_t x = c.x - reach; x <= c.x + reach; ++x) {
            const Cell n{x, y};
            if (states_.contains(n) && states_.at(n) == CellState::free && seen_.at(n) == 0) {
                ++count;
            }
        }
    }
    return count * resolution_m_ * resolution_m_;
}

void Explorer::Drive::mark_around(const Point& p, double radius) {
    const Cell c = cell(p);
    const auto reach = static_cast<std::int32_t>(radius / resolution_m_);
    for (std::int32_t y = c.y - reach; y <= c.y + reach; ++y) {
        for (std::int32_t x = c.x - reach; x <= c.x + reach; ++x) {
            if (seen_.contains({x, y})) seen_.at({x, y}) = 1;
        }
    }
}

// All around: what lies behind the robot is seen when it comes or goes.
void Explorer::Drive::mark_seen() {
    // Rays a cell apart at the survey range.
    const auto num_rays =
        static_cast<int>(std::ceil(2.0 * M_PI * options_.survey_range_m / resolution_m_));
    const double x = (pose_.x - origin_.x) / resolution_m_;
    const double y = (pose_.y - origin_.y) / resolution_m_;
    for (int i = 0; i < num_rays; ++i) {
        const double angle = 2.0 * M_PI * i / num_rays;
        const double range =
            caster_.cast({pose_.x, pose_.y}, angle, options_.survey_range_m) / resolution_m_;
        const double dx = std::cos(angle);
        const double dy = std::sin(angle);
        for (double t = 0.0; t < range; t += 0.9) {
            const Cell c{static_cast<std::int32_t>(std::floor(x + t * dx)),
                         static_cast<std::int32_t>(std::floor(y + t * dy))};
            if (seen_.contains(c)) seen_.at(c) = 1;
        }
    }
    mark_around({pose_.x, pose_.y}, options_.radius_m);
}

// A way to the nearest thing to be seen; false when there is none.
bool Explorer::Drive::plan() {
    next_point_ = 0;
    if (!only_corners_left_) {
        way_ = routes_.find(pose_, [&](const Point& p) {
            return is_unseen_floor(p) && unseen_around(p) >= kLeastPlace;
        });
        if (!way_.empty()) return true;
        only_corners_left_ = true;
    }
    if (options_.survey == RobotOptions::Survey::floor) return false;
    way_ = routes_.find(pose_, [&](const Point& p) { return unseen_around(p) >= kLeastCorner; });
    return !way_.empty();
}

// One period of the laser; false when there is nothing left to do.
bool Explorer::Drive::tick() {
    if (next_point_ >= way_.size()) {
        // At the goal: what could not be seen from here is given up.
        if (!way_.empty()) {
            mark_around(way_.back(), kLookAround);
        }
        if (!plan()) return false;
    }
    const double dt = 1.0 / options_.scan_rate_hz;
    ++num_ticks_;
    const Point goal = way_[next_point_];
    const double left = std::hypot(goal.x - pose_.x, goal.y - pose_.y);
    if (left < 1e-6) {
        ++next_point_;
        return true;
    }
    const double wanted = std::atan2(goal.y - pose_.y, goal.x - pose_.x);
    const double error = wrapped(wanted - pose_.yaw_rad);
    const double most = options_.turn_rate_radps * dt;
    pose_.yaw_rad = wrapped(pose_.yaw_rad + std::clamp(error, -most, most));
    // Sharp turns on the spot; the way itself is always straight to the next point.
    constexpr double kSharp = 0.35;
    if (std::abs(error) > kSharp) return true;
    const double drive = std::min(left, options_.speed_mps * dt);
    pose_.x += drive / left * (goal.x - pose_.x);
    pose_.y += drive / left * (goal.y - pose_.y);
    if (drive >= left) ++next_point_;
    return true;
}

KeyScan Explorer::Drive::take_scan() {
    KeyScan key{simulate_scan(caster_, pose_, options_.laser, laser_random_), pose_};
    key.scan.time_s = static_cast<double>(num_ticks_) / options_.scan_rate_hz;
    mark_seen();
    const Pose error = noise_.draw();
    key.scan.world_from_sensor = {pose_.x + error.x, pose_.y + error.y,
                                  wrapped(pose_.yaw_rad + error.yaw_rad)};
    last_key_ = pose_;
    // Whatever was to be seen may have been seen by now.
    if (!way_.empty() && next_point_ < way_.size()) {
        const Point& goal = way_.back();
        if (unseen_around(goal) < kContent) {
            way_.clear();
            next_point_ = 0;
        }
    }
    return key;
}

std::optional<KeyScan> Explorer::Drive::next() {
    if (!last_key_) return take_scan();
    while (tick()) {
        const double way = std::hypot(pose_.x - last_key_->x, pose_.y - last_key_->y);
        const double turn = std::abs(wrapped(pose_.yaw_rad - last_key_->yaw_rad));
        if (way >= options_.key_distance_m || turn >= options_.key_turn_rad) return take_scan();
    }
    return std::nullopt;
}

Explorer::Explorer(const GridMap& world, const Pose& start, const RobotOptions& options)
    : Explorer(world, start, options,
               {world.states.origin, world.states.width, world.states.height}) {}
Explorer::Explorer(const GridMap& world, const Pose& start, const RobotOptions& options,
                   Raster<std::uint8_t> passed_by)
    : drive_(std::make_unique<Drive>(world, start, options, std::move(passed_by))) {}
Explorer::~Explorer() = default;
Explorer::Explorer(Explorer&&) noexcept = default;
Explorer& Explorer::operator=(Explorer&&) noexcept = default;

std::optional<KeyScan> Explorer::next() { return drive_->next(); }

Pose widest_place(const Raster<std::uint8_t>& open, const GridMap& map) {
    const Raster<float> clearance = clearance_m(open, map.resolution_m);
    const auto widest = std::max_element(clearance.values.begin(), clearance.values.end());
    const Cell cell = clearance.cell(static_cast<std::size_t>(widest - clearance.values.begin()));
    const Point at = transform(
        map.map_from_image, {(cell.x + 0.5) * map.resolution_m, (cell.y + 0.5) * map.resolution_m});
    return {at.x, at.y, 0.0};
}

Pose start_pose(const Building& building) {
    std::uint16_t wanted = 1;
    for (const TrueRoom& room : building.rooms) {
        if (room.kind == RoomKind::corridor) {
            wanted = static_cast<std::uint16_t>(room.id);
            break;
        }
    }
    const Raster<std::uint16_t>& labels = building.labels;
    Raster<std::uint8_t> open(labels.origin, labels.width, labels.height);
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        open.values[i] = labels.values[i] == wanted ? 1 : 0;
    }
    return widest_place(open, building.map);
}

Exploration explore(const GridMap& world, const Pose& start, const RobotOptions& options) {
    Explorer explorer(world, start, options);
    Exploration exploration;
    while (std::optional<KeyScan> key = explorer.next()) {
        exploration.scans.push_back(std::move(key->scan));
        exploration.true_poses.push_back(key->true_pose);
    }
    return exploration;
}

}  // namespace quadcut::sim
