// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/reality.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "quadcut/base/error.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/map/integrate.hpp"
#include "sim/bend.hpp"
#include "sim/counted_map.hpp"
#include "sim/scanner.hpp"
#include "sim/surveyed_truth.hpp"
#include "sim/world.hpp"

namespace quadcut::sim {
namespace {

constexpr double kDegree = M_PI / 180.0;

enum class Mapping { log_odds, counted, walls_unknown };

// How one building is kept, and how one robot sees it.
struct Site {
    BuildingOptions building;
    WorldOptions world;
    ScannerOptions scanner;
    RobotOptions robot;
    // 0: straight; else the radius of the arc in units of the building's size.
    double bend = 0.0;
    // Standard deviations of what SLAM leaves of the drift: it bends the map, slowly.
    double drift_m = 0.0;
    double drift_rad = 0.0;
    // The share of the rooms that the robot enters.
    double entered = 1.0;
    Mapping mapping = Mapping::log_odds;
    CountedMapOptions counted;
};

// Field of view and angle between beams, degrees, and range (which a float holds exactly): those of
// robots of twenty years.
struct LaserModel {
    double field_deg;
    double step_deg;
    double range_m;
};
constexpr std::array<LaserModel, 6> kLasers{{{180.0, 1.0, 16.0},
                                             {180.0, 1.0, 30.0},
                                             {180.0, 0.5, 30.0},
                                             {180.0, 0.5, 80.0},
                                             {240.0, 0.5, 5.5},
                                             {270.0, 0.5, 20.0}}};

// Zero as often as `none` says.
double some_or_none(Random& random, double none, double least, double most) {
    const double choice = random.uniform();
    const double value = random.uniform(least, most);
    return choice < none ? 0.0 : value;
}

Site draw_site(const RealityOptions& options) {
    Random random = Random(options.seed).fork(21);
    const double c = options.clutter;
    Site site;
    site.building.seed = options.seed;
    site.building.num_rooms = options.num_rooms;
    site.building.resolution_m = options.resolution_m;
    site.building.furniture = random.uniform(0.7, 1.0);
    site.building.clutter = c * random.uniform(0.6, 1.0);
    site.building.open_leaves = random.uniform(0.3, 0.9);
    site.building.openness = c * random.uniform(0.1, 0.9);
    site.building.yaw_rad = random.uniform() < 0.5 ? 0.0 : random.uniform(-0.8, 0.8);
    site.building.turned_wings = 0.4;
    site.world = {options.seed, c * some_or_none(random, 0.35, 0.05, 0.5),
                  c * random.uniform(0.0, 0.25), c * some_or_none(random, 0.35, 0.1, 0.6),
                  c * some_or_none(random, 0.5, 0.05, 0.4)};
    const LaserModel& laser = kLasers[random.below(kLasers.size())];
    site.scanner.laser = {laser.field_deg * kDegree, laser.step_deg * kDegree, laser.range_m,
                          random.uniform(0.005, 0.03), random.uniform(0.0, 0.05)};
    site.scanner.glints = random.uniform(0.0, 0.3);
    site.scanner.passes = c * random.uniform(0.0, 0.6);
    site.scanner.people = c * random.uniform(0.0, 0.2);
    site.robot.seed = options.seed;
    site.robot.laser.angle_step_rad = 45.0 * kDegree;
    site.robot.survey = RobotOptions::Survey::floor;
    site.robot.key_distance_m = random.uniform(0.2, 0.5);
    site.robot.survey_range_m = random.uniform(3.0, 6.0);
    site.robot.pose_noise_m = random.uniform(0.005, 0.005 + 0.02 * c);
    site.robot.pose_noise_rad = random.uniform(0.05, 0.05 + 0.2 * c) * kDegree;
    // Most SLAM systems are good.
    const double drift = c * std::pow(random.uniform(), 2.0);
    site.drift_m = 0.01 + 0.12 * drift;
    site.drift_rad = (0.05 + 0.9 * drift) * kDegree;
    // Some robots look into every room, some go by all of them.
    const double errand = random.uniform();
    const double passed_by = errand < 0.4   ? random.uniform(0.0, 0.15)
                             : errand < 0.8 ? random.uniform(0.2, 0.6)
                                            : random.uniform(0.7, 1.0);
    site.entered = 1.0 - c * passed_by;
    const double mapping = random.uniform();
    site.mapping = mapping < 0.6    ? Mapping::log_odds
                   : mapping < 0.88 ? Mapping::counted
                                    : Mapping::walls_unknown;
    site.counted.least_visits = static_cast<std::uint32_t>(1 + random.below(3));
    site.counted.free_below = random.uniform(0.03, 0.2);
    site.counted.occupied_above = random.uniform(0.3, 0.65);
    site.bend = c > 0.0 ? some_or_none(random, 0.7, 2.0, 5.0) : 0.0;
    if (random.uniform() < 0.5) site.bend = -site.bend;
    return site;
}

// An error that keeps most of itself from scan to scan.
class Drift {
public:
    Drift(const Site& site, Random random) : site_(site), random_(random) {}

    Pose draw() {
        constexpr double kKeep = 0.99;
        const double fresh = std::sqrt(1.0 - kKeep * kKeep);
        error_.x = kKeep * error_.x + fresh * site_.drift_m * random_.normal();
        error_.y = kKeep * error_.y + fresh * site_.drift_m * random_.normal();
        error_.yaw_rad = kKeep * error_.yaw_rad + fresh * site_.drift_rad * random_.normal();
        return error_;
    }

private:
    const Site& site_;
    Random random_;
    Pose error_;
};

// The room of each cell of the world.
Raster<std::uint16_t> labels_of(const World& world, const Building& building) {
    const Raster<CellState>& states = world.map.states;
    const Raster<std::uint16_t>& labels = building.bare_labels;
    Raster<std::uint16_t> result(states.origin, states.width, states.height);
    const auto shift_x = static_cast<std::int32_t>(std::lround(
        (building.map.map_from_image.x - world.map.map_from_image.x) / world.map.resolution_m));
    const auto shift_y = static_cast<std::int32_t>(std::lround(
        (building.map.map_from_image.y - world.map.map_from_image.y) / world.map.resolution_m));
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const Cell cell = labels.cell(i);
        result.at({cell.x + shift_x, cell.y + shift_y}) = labels.values[i];
    }
    return result;
}

// Rooms that the robot leaves out.
std::vector<bool> left_out(const Building& building, double entered, Random random) {
    std::vector<bool> result(building.rooms.size() + 1, false);
    for (const TrueRoom& room : building.rooms) {
        const double share = room.kind == RoomKind::room ? entered : 0.5 + 0.5 * entered;
        result[static_cast<std::size_t>(room.id)] = random.uniform() >= share;
    }
    return result;
}

Exploration drive(const World& world, const Building& building, const Site& site) {
    const Raster<std::uint16_t> labels = labels_of(world, building);
    const Random random = Random(site.robot.seed).fork(22);
    const std::vector<bool> omitted = left_out(building, site.entered, random.fork(0));
    const Raster<CellState>& states = world.map.states;
    Raster<std::uint8_t> passed_by(states.origin, states.width, states.height);
    Raster<std::uint8_t> ways = passed_by;
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        const std::uint16_t room = labels.values[i];
        passed_by.values[i] = omitted[room] ? 1 : 0;
        const bool is_way = room != 0 && building.rooms[room - 1U].kind == RoomKind::corridor;
        ways.values[i] = is_way && states.values[i] == CellState::free ? 1 : 0;
    }
    Explorer explorer(world.map, widest_place(ways, world.map), site.robot, std::move(passed_by));
    Scanner scanner(world, site.scanner, random.fork(1));
    Drift drift(site, random.fork(2));
    Exploration exploration;
    while (std::optional<KeyScan> key = explorer.next()) {
        Scan scan = scanner.scan(key->true_pose);
        scan.time_s = key->scan.time_s;
        const Pose error = drift.draw();
        const Pose& pose = key->scan.world_from_sensor;
        scan.world_from_sensor = {pose.x + error.x, pose.y + error.y,
                                  std::remainder(pose.yaw_rad + error.yaw_rad, 2.0 * M_PI)};
        exploration.scans.push_back(std::move(scan));
        exploration.true_poses.push_back(key->true_pose);
    }
    return exploration;
}

// Some programs save only what they are sure is free.
void forget_walls(GridMap& map) {
    const Raster<CellState> before = map.states;
    for (std::size_t i = 0; i < before.values.size(); ++i) {
        if (before.values[i] != CellState::occupied) continue;
        const Cell cell = before.cell(i);
        for_each_cell({{cell.x - 1, cell.y - 1}, {cell.x + 1, cell.y + 1}}, [&](const Cell& near) {
            if (map.states.contains(near)) map.states.at(near) = CellState::unknown;
        });
    }
}

GridMap map_of(const std::vector<Scan>& scans, const Site& site) {
    const double resolution_m = site.building.resolution_m;
    if (site.mapping == Mapping::counted) return counted_map(scans, resolution_m, site.counted);
    GridMap map = map_from_scans(scans, resolution_m).to_grid();
    if (site.mapping == Mapping::walls_unknown) forget_walls(map);
    return map;
}

double size_of(const Building& building) {
    const Raster<CellState>& states = building.map.states;
    return std::max(0.6 * states.width, 1.0 * states.height) * building.map.resolution_m;
}

}  // namespace

RealMap scan_as_robots_do(const RealityOptions& options) {
    // Written so that NaN is refused as well.
    if (!(options.clutter >= 0.0 && options.clutter <= 1.0)) {
        throw InputError("clutter: expected 0..1");
    }
    const Site site = draw_site(options);
    RealMap real;
    real.building_options = site.building;
    real.building = generate_building(site.building);
    if (site.bend != 0.0) real.building = bent(real.building, site.bend * size_of(real.building));
    real.exploration = drive(draw_world(real.building, site.world), real.building, site);
    real.map = map_of(real.exploration.scans, site);
    real.truth = surveyed_truth(real.building, real.exploration, real.map);
    for (const Scan& scan : real.exploration.scans) {
        real.trajectory.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
    }
    return real;
}

}  // namespace quadcut::sim
