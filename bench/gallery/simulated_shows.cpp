// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/gallery/entry_picture.hpp"
#include "bench/gallery/montage.hpp"
#include "bench/gallery/shows.hpp"
#include "eval/labels.hpp"
#include "quadcut/base/option_field.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "sim/building.hpp"
#include "sim/robot.hpp"

namespace quadcut::gallery {
namespace {

namespace fs = std::filesystem;

constexpr double kLogResolution = 0.05;

enum class Survey : std::uint8_t { drawn, scanned };

struct Choice {
    const char* note;
    std::uint64_t seed;
    int num_rooms;
    double furniture;
    double turned_wings;
    double yaw_rad;
    Survey survey;
};

/// Of every kind one, chosen by their outlines. The door model was trained on none of them.
constexpr std::array<Choice, 6> kChoices = {{
    {"empty", 307, 12, 0.0, 0.5, 0.0, Survey::drawn},
    {"furnished", 313, 24, 0.5, 0.5, 0.0, Survey::drawn},
    {"furnished, turned", 303, 24, 0.5, 0.0, 0.35, Survey::drawn},
    {"furnished, mapped from scans", 304, 24, 0.5, 0.5, 0.0, Survey::scanned},
    {"full of furniture, turned wings", 309, 40, 1.0, 1.0, 0.0, Survey::drawn},
    {"full of furniture, turned wings", 315, 60, 1.0, 1.0, 0.1, Survey::drawn},
}};

sim::Building build(const Choice& choice) {
    sim::BuildingOptions options;
    options.seed = choice.seed;
    options.num_rooms = choice.num_rooms;
    options.furniture = choice.furniture;
    options.turned_wings = choice.turned_wings;
    options.yaw_rad = choice.yaw_rad;
    return sim::generate_building(options);
}

/// What a robot sees of a building, cut into rooms.
Side explored(const sim::Building& building, std::uint64_t seed) {
    sim::RobotOptions robot;
    robot.seed = seed;
    const sim::Exploration exploration =
        sim::explore(building.map, sim::start_pose(building), robot);
    std::vector<Point> trajectory;
    for (const Scan& scan : exploration.scans) {
        trajectory.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
    }
    Side side;
    side.map = map_from_scans(exploration.scans, kLogResolution).to_grid();
    side.rooms = segment(side.map, {}, {}, trajectory);
    return side;
}

Exhibit exhibit_of(const Choice& choice) {
    const sim::Building building = build(choice);
    const io::LabelImage truth = as_label_image(building.labels);
    const std::string name = "seed " + std::to_string(choice.seed) + ", " +
                             std::to_string(building.rooms.size()) + " rooms";
    if (choice.survey == Survey::drawn) {
        return make_exhibit(name, building.map, truth, building.map, segment(building.map));
    }
    const Side robot = explored(building, choice.seed);
    const Side result = resampled(building.map, robot.map, robot.rooms);
    return make_exhibit(name, building.map, truth, result.map, result.rooms);
}

}  // namespace

Section show_simulated(const fs::path& output) {
    Section section{"Simulated buildings", {}};
    Montage montage;
    for (const Choice& choice : kChoices) {
        const Exhibit exhibit = exhibit_of(choice);
        const std::string image = "simulated/seed_" + std::to_string(choice.seed) + ".png";
        section.entries.push_back(write_pair(exhibit, choice.note, output, image));
        montage.add(exhibit, choice.note);
    }
    montage.write(output / "pictures/gallery.png");

    // What ./run demo shows: the defaults of `quadcut demo`.
    constexpr std::uint64_t kDemoSeed = 1;
    sim::BuildingOptions options;
    options.seed = kDemoSeed;
    const Side demo = explored(sim::generate_building(options), kDemoSeed);
    write_before_and_after(demo, output / "pictures");
    return section;
}

}  // namespace quadcut::gallery
