// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "eval/labels.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/raster.hpp"
#include "sim/building.hpp"
#include "sim/robot.hpp"

namespace quadcut {

inline constexpr std::array<double, 3> kFurniture{0.0, 0.5, 1.0};
/// Furniture, direction, way of mapping: each building is one combination.
inline constexpr std::size_t kNumCombinations = 12;
/// The door model is trained on the seeds 1000 to 1599 (measure_doors --buildings 600): these are
/// other buildings.
inline constexpr std::uint64_t kFirstSeed = 5001;

/// A simulated building and the way it is mapped.
struct BuildingCase {
    std::uint64_t seed = kFirstSeed;
    int num_rooms = 8;
    double furniture = 0.0;
    bool is_turned = false;
    bool is_scanned = false;
};

/// The cases cycle through the combinations, and through 8 to 60 rooms.
inline BuildingCase building_case(std::size_t i) {
    BuildingCase chosen;
    chosen.seed = kFirstSeed + i;
    chosen.num_rooms = 8 + static_cast<int>(i * 37 % 53);
    chosen.furniture = kFurniture[i % 3];
    chosen.is_turned = i / 3 % 2 == 1;
    chosen.is_scanned = i / 6 % 2 == 1;
    return chosen;
}

inline std::string name_of(const BuildingCase& chosen) {
    std::string name = "furniture " + std::to_string(chosen.furniture).substr(0, 3);
    name += chosen.is_turned ? ", turned, " : ", straight, ";
    return name + (chosen.is_scanned ? "scanned" : "perfect");
}

/// A building as it is mapped, and its true rooms at the cells of that map.
struct MappedBuilding {
    sim::Building building;
    GridMap map;
    /// Where the robot says that it has been; empty for a perfect map.
    std::vector<Point> trajectory;
    /// 0 where the map is not free.
    Raster<std::uint32_t> truth;
};

/// The true rooms at the free cells of another map of the building.
inline Raster<std::uint32_t> truth_at(const sim::Building& building, const GridMap& map) {
    return labels_at(building.map, building.labels, map);
}

inline sim::Building building_of(const BuildingCase& chosen) {
    sim::BuildingOptions options;
    options.seed = chosen.seed;
    options.num_rooms = chosen.num_rooms;
    options.furniture = chosen.furniture;
    options.yaw_rad = chosen.is_turned ? 0.3 : 0.0;
    options.turned_wings = chosen.is_turned ? 0.5 : 0.0;
    return sim::generate_building(options);
}

inline std::vector<Scan> scans_of(const BuildingCase& chosen, const sim::Building& building) {
    sim::RobotOptions robot;
    robot.seed = chosen.seed;
    return sim::explore(building.map, sim::start_pose(building), robot).scans;
}

inline MappedBuilding map_building(const BuildingCase& chosen) {
    MappedBuilding mapped;
    mapped.building = building_of(chosen);
    mapped.map = mapped.building.map;
    if (chosen.is_scanned) {
        const std::vector<Scan> scans = scans_of(chosen, mapped.building);
        mapped.map = map_from_scans(scans, mapped.building.map.resolution_m).to_grid();
        for (const Scan& scan : scans) {
            mapped.trajectory.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
        }
    }
    mapped.truth = truth_at(mapped.building, mapped.map);
    return mapped;
}

}  // namespace quadcut
