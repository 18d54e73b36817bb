// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/surveyed_truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "quadcut/map/flood.hpp"

namespace quadcut::sim {
namespace {

constexpr double kLeastSeenM2 = 1.5;
constexpr double kLeastSeenShare = 0.1;

Cell cell_of(const Point& in_image, double resolution_m) {
    return {static_cast<std::int32_t>(std::floor(in_image.x / resolution_m)),
            static_cast<std::int32_t>(std::floor(in_image.y / resolution_m))};
}

// One more than the scan that was taken nearest to each cell, by steps over free cells; 0 where
// there is no way.
Raster<std::uint32_t> nearest_scans(const Exploration& exploration, const GridMap& map) {
    Raster<std::uint32_t> nearest(map.states.origin, map.states.width, map.states.height);
    const Pose image_from_map = inverse(map.map_from_image);
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < exploration.scans.size(); ++i) {
        const Pose& pose = exploration.scans[i].world_from_sensor;
        const Cell cell = cell_of(transform(image_from_map, {pose.x, pose.y}), map.resolution_m);
        if (!nearest.contains(cell) || nearest.at(cell) != 0) continue;
        nearest.at(cell) = static_cast<std::uint32_t>(i + 1);
        front.push_back(nearest.offset(cell));
    }
    for (std::size_t i = 0; i < front.size(); ++i) {
        for (const std::size_t next : Neighbours(nearest, front[i], Connectivity::eight)) {
            if (nearest.values[next] != 0 || map.states.values[next] != CellState::free) continue;
            nearest.values[next] = nearest.values[front[i]];
            front.push_back(next);
        }
    }
    return nearest;
}

void forget_glimpses(Raster<std::uint32_t>& truth, const Building& building, double cell_m2) {
    std::vector<std::size_t> num_seen(building.rooms.size() + 1, 0);
    for (const std::uint32_t room : truth.values) ++num_seen[room];
    for (std::uint32_t& room : truth.values) {
        if (room == 0) continue;
        const double area_m2 = building.rooms[room - 1].area_m2;
        const double least_m2 =
            std::min(area_m2, std::max(kLeastSeenM2, kLeastSeenShare * area_m2));
        if (static_cast<double>(num_seen[room]) * cell_m2 < least_m2) room = 0;
    }
}

}  // namespace

Raster<std::uint32_t> surveyed_truth(const Building& building, const Exploration& exploration,
                                     const GridMap& map) {
    const Raster<std::uint32_t> nearest = nearest_scans(exploration, map);
    std::vector<Pose> building_from_image;
    const Pose building_from_world = inverse(building.bare.map_from_image);
    for (std::size_t i = 0; i < exploration.scans.size(); ++i) {
        const Pose true_from_reported =
            compose(exploration.true_poses[i], inverse(exploration.scans[i].world_from_sensor));
        building_from_image.push_back(
            compose(building_from_world, compose(true_from_reported, map.map_from_image)));
    }
    Raster<std::uint32_t> truth(map.states.origin, map.states.width, map.states.height);
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        if (map.states.values[i] != CellState::free || nearest.values[i] == 0) continue;
        const Cell cell = truth.cell(i);
        const Point center{(cell.x + 0.5) * map.resolution_m, (cell.y + 0.5) * map.resolution_m};
        const Cell there = cell_of(transform(building_from_image[nearest.values[i] - 1], center),
                                   building.bare.resolution_m);
        if (building.bare_labels.contains(there)) truth.values[i] = building.bare_labels.at(there);
    }
    forget_glimpses(truth, building, map.resolution_m * map.resolution_m);
    return truth;
}

}  // namespace quadcut::sim
