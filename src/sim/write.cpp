// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/write.hpp"

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "io/authorship.hpp"
#include "io/label_image.hpp"
#include "io/map_writer.hpp"
#include "io/number_text.hpp"
#include "io/room_text.hpp"

namespace quadcut::sim {
namespace {

constexpr int kMicrometreDecimals = 6;
constexpr double kDegree = M_PI / 180.0;

void add(std::string& line, double value, int decimals = kMicrometreDecimals) {
    line += ' ';
    io::append_rounded(line, value, decimals);
}

void add_pose(std::string& line, const Pose& pose) {
    add(line, pose.x);
    add(line, pose.y);
    add(line, pose.yaw_rad);
}

void add_ranges(std::string& line, const Scan& scan) {
    add(line, static_cast<double>(scan.ranges_m.size()), 0);
    for (const float range : scan.ranges_m) {
        add(line, static_cast<double>(range), io::kMillimetreDecimals);
    }
}

// Whether FLASER's rules give back the angles of the scan: from -90 degrees on, 1 degree apart
// for 180 and 181 beams, half a degree for 360 and 361.
bool fits_flaser(const Scan& scan) {
    const std::size_t n = scan.ranges_m.size();
    const bool fine = n == 360 || n == 361;
    if (!fine && n != 180 && n != 181) return false;
    constexpr double kSame = 1e-6;
    return std::abs(scan.first_angle_rad + 90.0 * kDegree) < kSame &&
           std::abs(scan.angle_step_rad - (fine ? 0.5 : 1.0) * kDegree) < kSame;
}

void add_scan(std::string& log, const Scan& scan) {
    const double span = scan.angle_step_rad *
                        static_cast<double>(std::max<std::size_t>(1, scan.ranges_m.size()) - 1);
    if (fits_flaser(scan)) {
        log += "FLASER";
        add_ranges(log, scan);
    } else {
        // type, first angle, field of view, angle step, maximum range, accuracy, remission mode
        log += "ROBOTLASER1 0";
        constexpr int kAngleDecimals = 9;
        add(log, scan.first_angle_rad, kAngleDecimals);
        add(log, span, kAngleDecimals);
        add(log, scan.angle_step_rad, kAngleDecimals);
        add(log, scan.max_range_m, io::kMillimetreDecimals);
        log += " 0.01 0";
        add_ranges(log, scan);
        log += " 0";  // no remission values
    }
    // The laser's pose, then the robot's.
    add_pose(log, scan.world_from_sensor);
    add_pose(log, scan.world_from_sensor);
    // Two speeds and three distances of the safety system.
    if (!fits_flaser(scan)) log += " 0 0 0 0 0";
    add(log, scan.time_s);
    log += " quadcut";
    add(log, scan.time_s);
    log += '\n';
}

void add_point(io::JsonWriter& json, const Point& point) {
    json.begin_array().number(point.x).number(point.y).end_array();
}

void add_room(io::JsonWriter& json, const TrueRoom& room) {
    json.begin_object();
    json.key("id").integer(static_cast<std::uint64_t>(room.id));
    json.key("name").text(room.name);
    json.key("kind").text(io::to_text(room.kind));
    json.key("area_m2").number(room.area_m2);
    json.key("floor").begin_array();
    for (const Polygon& polygon : room.floor) {
        json.begin_array();
        for (const Point& point : polygon) add_point(json, point);
        json.end_array();
    }
    json.end_array().end_object();
}

void add_door(io::JsonWriter& json, const TrueDoor& door) {
    json.begin_object();
    json.key("a").integer(static_cast<std::uint64_t>(door.a));
    json.key("b").integer(static_cast<std::uint64_t>(door.b));
    json.key("jamb_1");
    add_point(json, door.jamb_1);
    json.key("jamb_2");
    add_point(json, door.jamb_2);
    json.key("width_m").number(door.width_m);
    json.key("is_open_passage").boolean(door.is_open_passage).end_object();
}

std::string comment_of(std::string_view what) {
    std::string line = "# ";
    line.append(io::kAuthorComment).append(": ").append(what);
    return line + "\n";
}

}  // namespace

std::string encode_carmen_log(std::span<const Scan> scans) {
    std::string log = comment_of("a simulated robot, as a CARMEN log");
    for (const Scan& scan : scans) add_scan(log, scan);
    return log;
}

std::string encode_true_poses(std::span<const Scan> scans, std::span<const Pose> poses) {
    if (scans.size() != poses.size()) {
        throw std::logic_error("encode_true_poses: expected one pose a scan");
    }
    std::string text = comment_of("time x y z qx qy qz qw");
    for (std::size_t i = 0; i < scans.size(); ++i) {
        io::append_rounded(text, scans[i].time_s, kMicrometreDecimals);
        add(text, poses[i].x);
        add(text, poses[i].y);
        text += " 0 0 0";
        constexpr int kQuaternionDecimals = 9;
        add(text, std::sin(0.5 * poses[i].yaw_rad), kQuaternionDecimals);
        add(text, std::cos(0.5 * poses[i].yaw_rad), kQuaternionDecimals);
        text += '\n';
    }
    return text;
}

void write_rooms_and_doors(io::JsonWriter& json, const Building& building) {
    json.key("rooms").begin_array(io::JsonLayout::lines);
    for (const TrueRoom& room : building.rooms) add_room(json, room);
    json.end_array();
    json.key("doors").begin_array(io::JsonLayout::lines);
    for (const TrueDoor& door : building.doors) add_door(json, door);
    json.end_array();
}

std::string encode_truth(const Building& building, const BuildingOptions& options) {
    io::JsonWriter json;
    json.begin_object(io::JsonLayout::lines);
    json.key("format_version").integer(1);
    json.key("options").begin_object();
    json.key("seed").integer(options.seed);
    json.key("num_rooms").integer(static_cast<std::uint64_t>(options.num_rooms));
    json.key("furniture").exact_number(options.furniture);
    json.key("resolution_m").exact_number(options.resolution_m);
    json.key("turned_wings").exact_number(options.turned_wings);
    json.key("yaw_rad").exact_number(options.yaw_rad);
    json.key("open_leaves").exact_number(options.open_leaves);
    if (options.clutter > 0.0) json.key("clutter").exact_number(options.clutter);
    if (options.openness > 0.0) json.key("openness").exact_number(options.openness);
    json.end_object();
    json.key("num_turned_wings").integer(static_cast<std::uint64_t>(building.num_turned_wings));
    write_rooms_and_doors(json, building);
    json.end_object();
    return json.finish();
}

std::vector<std::string> simulation_files() {
    return {"map.pgm", "map.yaml", "rooms.png", "truth.json", "robot.log", "true_poses.tum"};
}

void add_simulation(io::FileBatch& batch, const Building& building, const BuildingOptions& options,
                    const Exploration& exploration, const std::string& folder) {
    io::add_map(batch, building.map, folder);
    batch.add(folder + "rooms.png", io::encode_label_png(building.labels));
    batch.add(folder + "truth.json", encode_truth(building, options));
    if (exploration.scans.empty()) return;
    batch.add(folder + "robot.log", encode_carmen_log(exploration.scans));
    batch.add(folder + "true_poses.tum",
              encode_true_poses(exploration.scans, exploration.true_poses));
}

}  // namespace quadcut::sim
