// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/world.hpp"

#include <algorithm>
#include <utility>

#include "eval/labels.hpp"
#include "io/carmen.hpp"
#include "io/file.hpp"
#include "io/label_image.hpp"
#include "io/map_server.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/segment/inside.hpp"
#include "sim/building.hpp"
#include "sim/robot.hpp"
#include "sim/workplace.hpp"

namespace quadcut::reproduce {
namespace {

constexpr const char* kCsailLog = "logs/mit_csail.log";
constexpr const char* kIntelLog = "logs/intel.log";
constexpr const char* kIntelMap = "logs/intel.gt.yaml";
constexpr const char* kIntelRooms = "logs/intel.gt_rooms.png";
constexpr const char* kLaboratoryLog = "logs/mit_csail_dense.log.gz";
constexpr const char* kLaboratoryRooms = "real/mit_csail_dense.rooms.png";
constexpr double kDegree = 3.14159265358979323846 / 180.0;

/// Lays the scans into a map.
void complete(World& world) {
    for (const Scan& scan : world.scans) {
        world.trajectory.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
    }
    world.map = map_from_scans(world.scans, kResolutionM).to_grid();
}

/// The robot of the paper, which looks as often as those of the sparse logs do.
sim::RobotOptions robot_options(std::uint64_t seed) {
    sim::RobotOptions options;
    options.seed = seed;
    options.laser.angle_step_rad = 0.5 * kDegree;
    options.key_distance_m = 0.8;
    options.key_turn_rad = 40.0 * kDegree;
    return options;
}

void explore(World& world, const GridMap& ground, const Pose& start, std::uint64_t seed) {
    world.scans = sim::explore(ground, start, robot_options(seed)).scans;
    complete(world);
}

void explore(World& world, const sim::Building& building, std::uint64_t seed) {
    explore(world, building.map, sim::start_pose(building), seed);
    world.truth_map = building.map;
    world.truth = Raster<std::uint32_t>(building.labels.origin, building.labels.width,
                                        building.labels.height);
    std::copy(building.labels.values.begin(), building.labels.values.end(),
              world.truth.values.begin());
}

World simulated(const std::string& name, const std::string& stands_for, int num_rooms,
                double furniture, std::uint64_t seed) {
    sim::BuildingOptions options;
    options.seed = seed;
    options.num_rooms = num_rooms;
    options.furniture = furniture;
    const sim::Building building = sim::generate_building(options);
    World world;
    world.name = name;
    explore(world, building, seed);
    world.origin = name + ": a simulated building of " + std::to_string(building.rooms.size()) +
                   " rooms and a simulated robot, " + std::to_string(world.scans.size()) +
                   " scans, in the place of " + stands_for;
    return world;
}

World from_log(const std::string& name, const std::filesystem::path& path) {
    World world;
    world.name = name;
    world.is_simulated = false;
    world.scans = io::read_carmen_log(path).scans;
    complete(world);
    world.origin = name + ": " + path.filename().string() + ", " +
                   std::to_string(world.scans.size()) + " scans of a real robot";
    return world;
}

void read_truth(World& world, const GridMap& map, const std::filesystem::path& image) {
    world.truth_map = map;
    world.truth = as_raster(io::read_label_image(image));
}

}  // namespace

void check_data(const std::filesystem::path& data) {
    for (const char* file :
         {kCsailLog, kIntelLog, kIntelMap, kIntelRooms, kLaboratoryLog, kLaboratoryRooms}) {
        if (std::filesystem::exists(data / file)) continue;
        throw InputError(io::display_name(data / file) +
                         ": does not exist: expected a folder with the data's logs and real maps");
    }
}

World workplace(std::uint64_t seed) {
    World world;
    world.name = "workplace";
    explore(world, sim::paper_workplace(kResolutionM), seed);
    world.origin =
        "workplace: five rooms on 16 x 10 m as in the paper's Fig 11, simulated, and a "
        "simulated robot, " +
        std::to_string(world.scans.size()) + " scans";
    return world;
}

World mit_csail(const std::optional<std::filesystem::path>& data, Size size, std::uint64_t seed) {
    if (data) return from_log("MIT-CSAIL", *data / kCsailLog);
    return simulated("building A", "MIT-CSAIL", size == Size::small ? 5 : 24, 0.5, seed);
}

World intel(const std::optional<std::filesystem::path>& data, Size size, std::uint64_t seed) {
    if (!data) {
        return simulated("building B", "the Intel lab", size == Size::small ? 6 : 24, 0.5,
                         seed + 1);
    }
    World world = from_log("Intel", *data / kIntelLog);
    read_truth(world, io::read_map(*data / kIntelMap).map, *data / kIntelRooms);
    return world;
}

World laboratory(const std::optional<std::filesystem::path>& data, Size size, std::uint64_t seed) {
    if (!data) {
        return simulated("laboratory", "the paper's laboratory", size == Size::small ? 4 : 9, 1.0,
                         seed + 2);
    }
    World world = from_log("laboratory", *data / kLaboratoryLog);
    world.is_void_judged = false;
    world.origin += ", all that it took: an open-plan laboratory with partitions and desks";
    read_truth(world, world.map, *data / kLaboratoryRooms);
    if (world.truth.width == world.map.states.width &&
        world.truth.height == world.map.states.height) {
        return world;
    }
    throw InputError(io::display_name(*data / kLaboratoryRooms) + ": expected " +
                     std::to_string(world.map.states.width) + " x " +
                     std::to_string(world.map.states.height) + " pixels, as the map of " +
                     kLaboratoryLog + " has");
}

}  // namespace quadcut::reproduce
