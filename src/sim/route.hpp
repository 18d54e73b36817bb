// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut::sim {

/// Finds ways for a round robot over the free cells of a map, on a grid of about 0.1 m.
class RouteFinder {
public:
    RouteFinder(const GridMap& world, double radius_m);

    /// The way from `start` to the nearest place for which `is_goal` holds, where nearness counts
    /// way close to obstacles up to threefold, and setting out in another direction than the
    /// start's 0.6 m a radian. Empty when there is none. The first point is near the start, and the
    /// straight lines between the points keep the radius clear.
    [[nodiscard]] std::vector<Point> find(const Pose& start,
                                          const std::function<bool(const Point&)>& is_goal);

    /// Clearance of a point of the map, metres.
    [[nodiscard]] double clearance_at(const Point& p) const;
    [[nodiscard]] bool fits(const Point& p) const { return clearance_at(p) >= radius_m_; }

private:
    [[nodiscard]] Point point(std::size_t node) const;
    [[nodiscard]] std::int64_t nearest_node(const Point& p) const;
    [[nodiscard]] std::vector<Point> straighten(const std::vector<Point>& steps) const;
    [[nodiscard]] double line_clearance(const Point& a, const Point& b) const;

    double radius_m_;
    double resolution_m_;
    double step_m_;
    Point origin_;
    Raster<float> clearance_;
    std::int32_t width_ = 0;
    std::int32_t height_ = 0;
    // Price of a metre at a node; 0 where the robot does not fit.
    std::vector<float> price_;
    std::vector<float> cost_;
    std::vector<std::uint32_t> from_;
    std::vector<std::uint32_t> touched_;
};

}  // namespace quadcut::sim
