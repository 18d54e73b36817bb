// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/route.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

#include "quadcut/map/clearance.hpp"

namespace quadcut::sim {
namespace {

// The robot likes to keep this far from obstacles where it can.
constexpr double kComfort = 0.5;
// What a turn at the start costs, metres a radian.
constexpr double kTurnPrice = 0.6;
constexpr float kFar = std::numeric_limits<float>::infinity();

Raster<float> clearance_of(const GridMap& world) {
    Raster<std::uint8_t> open({0, 0}, world.states.width, world.states.height);
    for (std::size_t i = 0; i < open.values.size(); ++i) {
        open.values[i] = world.states.values[i] == CellState::free ? 1 : 0;
    }
    return clearance_m(open, world.resolution_m);
}

}  // namespace

RouteFinder::RouteFinder(const GridMap& world, double radius_m)
    : radius_m_(radius_m),
      resolution_m_(world.resolution_m),
      origin_{world.map_from_image.x + world.states.origin.x * world.resolution_m,
              world.map_from_image.y + world.states.origin.y * world.resolution_m},
      clearance_(clearance_of(world)) {
    if (world.map_from_image.yaw_rad != 0.0) {
        throw std::logic_error("RouteFinder: the map must not be turned");
    }
    const int factor = std::max(1, static_cast<int>(std::lround(0.1 / resolution_m_)));
    step_m_ = factor * resolution_m_;
    width_ = clearance_.width / factor;
    height_ = clearance_.height / factor;
    const auto size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    price_.assign(size, 0.0F);
    cost_.assign(size, kFar);
    from_.assign(size, 0);
    for (std::size_t i = 0; i < size; ++i) {
        const double clearance = clearance_at(point(i));
        if (clearance < radius_m_) continue;
        const double lack = std::max(0.0, kComfort - clearance) / kComfort;
        price_[i] = static_cast<float>(1.0 + 2.0 * lack);
    }
}

Point RouteFinder::point(std::size_t node) const {
    const auto x = node % static_cast<std::size_t>(width_);
    const auto y = node / static_cast<std::size_t>(width_);
    return {origin_.x + (static_cast<double>(x) + 0.5) * step_m_,
            origin_.y + (static_cast<double>(y) + 0.5) * step_m_};
}

double RouteFinder::clearance_at(const Point& p) const {
    const Cell cell{static_cast<std::int32_t>(std::floor((p.x - origin_.x) / resolution_m_)),
                    static_cast<std::int32_t>(std::floor((p.y - origin_.y) / resolution_m_))};
    return clearance_.contains(cell) ? static_cast<double>(clearance_.at(cell)) : 0.0;
}

std::int64_t RouteFinder::nearest_node(const Point& p) const {
    const auto x = static_cast<std::int32_t>(std::floor((p.x - origin_.x) / step_m_));
    const auto y = static_cast<std::int32_t>(std::floor((p.y - origin_.y) / step_m_));
    std::int64_t best = -1;
    double best_distance = std::numeric_limits<double>::infinity();
    for (std::int32_t j = y - 3; j <= y + 3; ++j) {
        for (std::int32_t i = x - 3; i <= x + 3; ++i) {
            if (i < 0 || j < 0 || i >= width_ || j >= height_) continue;
            const auto node = static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(i);
            const double d = distance(point(node), p);
            if (price_[node] == 0.0F || d >= best_distance) continue;
            if (line_clearance(p, point(node)) < radius_m_ - resolution_m_) continue;
            best = static_cast<std::int64_t>(node);
            best_distance = d;
        }
    }
    return best;
}

double RouteFinder::line_clearance(const Point& a, const Point& b) const {
    const int steps = 1 + static_cast<int>(distance(a, b) / (0.5 * resolution_m_));
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        least = std::min(least, clearance_at({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
    }
    return least;
}

std::vector<Point> RouteFinder::straighten(const std::vector<Point>& steps) const {
    std::vector<Point> way{steps.front()};
    std::size_t i = 0;
    while (i + 1 < steps.size()) {
        // A straight line replaces steps as long as it does not come nearer to anything.
        std::size_t last = i + 1;
        double least = std::min({clearance_at(steps[i]), clearance_at(steps[last]), kComfort});
        for (std::size_t j = i + 2; j < std::min(steps.size(), i + 60); ++j) {
            least = std::min(least, clearance_at(steps[j]));
            if (line_clearance(steps[i], steps[j]) >= least - 0.02 &&
                line_clearance(steps[i], steps[j]) >= radius_m_) {
                last = j;
            }
        }
        way.push_back(steps[last]);
        i = last;
    }
    return way;
}

std::vector<Point> RouteFinder::find(const Pose& start,
                                     const std::function<bool(const Point&)>& is_goal) {
    const std::int64_t first = nearest_node({start.x, start.y});
    if (first < 0) return {};
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto reach = [&](std::uint32_t node, float cost, std::uint32_t from) {
        if (cost >= cost_[node]) return;
        if (cost_[node] == kFar) touched_.push_back(node);
        cost_[node] = cost;
        from_[node] = from;
        queue.push({cost, node});
    };
    reach(static_cast<std::uint32_t>(first), 0.0F, static_cast<std::uint32_t>(first));
    std::vector<Point> steps;
    while (!queue.empty()) {
        const auto [cost, node] = queue.top();
        queue.pop();
        if (cost > cost_[node]) continue;
        if (is_goal(point(node))) {
            for (std::uint32_t n = node;; n = from_[n]) {
                steps.push_back(point(n));
                if (n == from_[n]) break;
            }
            std::reverse(steps.begin(), steps.end());
            break;
        }
        const auto x = static_cast<std::int32_t>(node) % width_;
        const auto y = static_cast<std::int32_t>(node) / width_;
        for (int k = 0; k < 9; ++k) {
            const int dx = k % 3 - 1;
            const int dy = k / 3 - 1;
            const std::int32_t i = x + dx;
            const std::int32_t j = y + dy;
            if (k == 4 || i < 0 || j < 0 || i >= width_ || j >= height_) continue;
            const auto next = static_cast<std::uint32_t>(j * width_ + i);
            if (price_[next] == 0.0F) continue;
            const float length = k % 2 == 0 ? 1.41421356F : 1.0F;
            float turn = 0.0F;
            if (static_cast<std::int64_t>(node) == first) {
                const double way = std::atan2(dy, dx);
                turn = static_cast<float>(
                    kTurnPrice * std::abs(std::remainder(way - start.yaw_rad, 2.0 * M_PI)) /
                    step_m_);
            }
            reach(next, cost + turn + length * 0.5F * (price_[node] + price_[next]), node);
        }
    }
    for (const std::uint32_t node : touched_) cost_[node] = kFar;
    touched_.clear();
    return steps.empty() ? steps : straighten(steps);
}

}  // namespace quadcut::sim
