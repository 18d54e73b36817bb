// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/simulated_robot.hpp"

#include <utility>

#include "sim/reality.hpp"

namespace quadcut {

std::vector<OptionField> simulation_fields(SimulationChoice& choice) {
    return {
        {"seed", "", 0, 1e15, "another building for each seed", "", &choice.seed},
        {"rooms", "", 3, 1000, "rooms, corridors and halls together, about", "", &choice.num_rooms},
        {"furniture", "", 0.0, 1.0, "0: empty, 1: full", "", &choice.furniture},
        {"clutter", "", 0.0, 1.0,
         "above 0: as robots find buildings, glass, people and rooms passed by; furniture by the "
         "seed",
         "", &choice.clutter}};
}

Simulation simulate(const SimulationChoice& choice, Progress& progress) {
    Simulation simulation;
    if (choice.clutter > 0.0) {
        progress.begin("building and robot");
        sim::RealMap real = sim::scan_as_robots_do(
            {choice.seed, static_cast<int>(choice.num_rooms), 0.05, choice.clutter});
        return {real.building_options, std::move(real.building), std::move(real.exploration)};
    }
    simulation.options.seed = choice.seed;
    simulation.options.num_rooms = static_cast<int>(choice.num_rooms);
    simulation.options.furniture = choice.furniture;
    progress.begin("building");
    simulation.building = sim::generate_building(simulation.options);

    progress.begin("robot");
    sim::RobotOptions robot;
    robot.seed = choice.seed;
    sim::Explorer explorer(simulation.building.map, sim::start_pose(simulation.building), robot);
    while (std::optional<sim::KeyScan> key = explorer.next()) {
        simulation.exploration.scans.push_back(std::move(key->scan));
        simulation.exploration.true_poses.push_back(key->true_pose);
    }
    return simulation;
}

}  // namespace quadcut
