// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "formats/format.hpp"
#include "io/authorship.hpp"
#include "io/number_text.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/map/line_walk.hpp"

namespace quadcut::formats {
namespace {

/// Its yaw within half a turn, as atan2 has it: a sum of angles may be anything.
Pose within_half_a_turn(Pose pose) {
    pose.yaw_rad = std::remainder(pose.yaw_rad, 2.0 * std::numbers::pi);
    return pose;
}

std::string line_of(const std::string& start, const Pose& pose) {
    std::string line = start;
    for (const double value : {pose.x, pose.y, pose.yaw_rad}) line += " " + io::exact(value);
    return line;
}

/// VERTEX_SE2 id x y yaw, then EDGE_SE2 from to x y yaw and the upper half of the information
/// matrix. Nothing but these: some readers take no comment.
std::string graph_of(std::vector<Pose> poses) {
    // First of all, so that a graph that is read again is the same.
    for (Pose& pose : poses) pose = within_half_a_turn(pose);
    std::string text;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        text += line_of("VERTEX_SE2 " + std::to_string(i), poses[i]) + "\n";
    }
    for (std::size_t i = 1; i < poses.size(); ++i) {
        text += line_of("EDGE_SE2 " + std::to_string(i - 1) + " " + std::to_string(i),
                        within_half_a_turn(compose(inverse(poses[i - 1]), poses[i]))) +
                " 1 0 0 1 0 1\n";
    }
    return text;
}

/// 0: in no room.
std::uint32_t zone_at(const Result& result, const Pose& pose) {
    const GridMap& map = result.map();
    const Raster<std::uint16_t>& labels = result.rooms().labels;
    const Point in_image = transform(inverse(map.map_from_image), {pose.x, pose.y});
    const Point at{in_image.x / map.resolution_m, in_image.y / map.resolution_m};
    // Written so that a pose may be anywhere.
    if (!(at.x >= 0.0 && at.y >= 0.0 && at.x < labels.width && at.y < labels.height)) return 0;
    const std::uint16_t label = labels.at(cell_of(at));
    return label == 0 ? 0 : result.rooms().zones.zone_of_room.at(label - std::size_t{1});
}

/// Each pose is in one: in that of the pose before, if it stands in none itself.
std::string zones_of(const Result& result) {
    std::vector<std::uint32_t> zones;
    for (const Pose& pose : result.info().poses) zones.push_back(zone_at(result, pose));
    const auto first =
        std::find_if(zones.begin(), zones.end(), [](std::uint32_t zone) { return zone != 0; });
    std::uint32_t last = first == zones.end() ? 0 : *first;
    std::string text = "# " + std::string(io::kAuthorComment) + ": vertex of submaps.g2o, zone\n";
    for (std::size_t i = 0; i < zones.size(); ++i) {
        if (zones[i] != 0) last = zones[i];
        text += std::to_string(i) + " " + std::to_string(last) + "\n";
    }
    return text;
}

std::vector<std::string> to_text(const Result& result) {
    if (result.rooms().zones.count == 0 || result.info().poses.empty()) {
        throw std::logic_error("poses with their zones, of a result without");
    }
    return {graph_of(result.info().poses), zones_of(result)};
}

}  // namespace

Format g2o_format() {
    return {"g2o-submaps",
            "poses with their zone, so that a SLAM back end can partition",
            Part::poses,
            {"submaps.g2o", "submaps.zones"},
            to_text};
}

}  // namespace quadcut::formats
