// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "formats/results.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "draw/floor_plan.hpp"
#include "draw/render.hpp"
#include "draw/svg.hpp"
#include "io/geojson.hpp"
#include "io/graph_json.hpp"
#include "io/image.hpp"
#include "io/room_colors.hpp"
#include "io/room_places.hpp"
#include "io/rooms_yaml.hpp"
#include "quadcut/base/parallel.hpp"

namespace quadcut::formats {
namespace {

void check_map(const GridMap& map) {
    if (map.states.width <= 0 || map.states.height <= 0) {
        throw std::logic_error("a map without cells cannot be written");
    }
}

Raster<std::uint16_t> on_map(const GridMap& map, const Raster<std::uint16_t>& from) {
    Raster<std::uint16_t> to(map.states.origin, map.states.width, map.states.height);
    const Box box = to.box().intersected(from.box());
    if (box.is_empty()) return to;
    for (std::int32_t y = box.low.y; y <= box.high.y; ++y) {
        std::copy_n(&from.values[from.offset({box.low.x, y})], box.width(),
                    &to.values[to.offset({box.low.x, y})]);
    }
    return to;
}

/// The segmentation with labels for exactly the cells of the map.
Segmentation on_map(const GridMap& map, const Segmentation& segmentation) {
    Segmentation result;
    result.labels = on_map(map, segmentation.labels);
    result.rooms = segmentation.rooms;
    result.doors = segmentation.doors;
    result.next_id = segmentation.next_id;
    result.report = segmentation.report;
    result.hierarchy.levels = segmentation.hierarchy.levels;
    if (!result.hierarchy.levels.empty()) {
        result.hierarchy.finest = on_map(map, segmentation.hierarchy.finest);
    }
    return result;
}

void check_rooms(const Segmentation& segmentation) {
    const std::vector<Room>& rooms = segmentation.rooms;
    const auto& labels = segmentation.labels.values;
    const auto most = std::max_element(labels.begin(), labels.end());
    const std::map<RoomId, std::size_t> places = io::room_places(rooms);
    bool valid = most == labels.end() || *most <= rooms.size();
    valid = valid && places.size() == rooms.size() && !places.contains(RoomId{});
    valid = valid && (rooms.empty() || index(places.rbegin()->first) <= kMaxRoomId);
    for (const Door& door : segmentation.doors) {
        valid = valid && places.contains(door.a) && places.contains(door.b);
    }
    if (!valid) throw std::logic_error("labels or doors name rooms that are not there");
}

/// Of each cell, the id of its room, as an image turned upright.
std::string encode_ids(const Segmentation& segmentation, const Executor& executor) {
    std::vector<std::uint16_t> id_of{0};
    for (const Room& room : segmentation.rooms) {
        id_of.push_back(static_cast<std::uint16_t>(index(room.id)));
    }
    const Raster<std::uint16_t>& labels = segmentation.labels;
    const auto fill_row = [&](std::int32_t y, std::span<std::uint16_t> samples) {
        const std::size_t begin =
            labels.offset({labels.origin.x, labels.origin.y + labels.height - 1 - y});
        for (std::size_t x = 0; x < samples.size(); ++x) {
            samples[x] = id_of[labels.values[begin + x]];
        }
    };
    return io::encode_png({labels.width, labels.height, 1, 65535}, fill_row, executor);
}

/// A file and how to make its bytes.
struct Task {
    std::string name;
    std::function<std::string()> make;
};

/// Makes all files, as many at a time as there are threads, and adds them to the batch in order.
void add_files(io::FileBatch& batch, const std::vector<Task>& tasks, const Executor& executor) {
    std::vector<std::string> contents(tasks.size());
    parallel_for(executor, tasks.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) contents[i] = tasks[i].make();
    });
    for (std::size_t i = 0; i < tasks.size(); ++i) batch.add(tasks[i].name, contents[i]);
}

}  // namespace

std::vector<std::string> result_files() {
    return {"rooms_color.png", "rooms.svg",  "rooms.png",  "rooms.yaml",
            "rooms.geojson",   "graph.json", "report.json"};
}

void write_results(const std::filesystem::path& folder, const GridMap& map,
                   const Segmentation& segmentation, const io::RunInfo& info) {
    io::FileBatch batch(folder);
    add_results(batch, map, segmentation, info);
    batch.commit();
}

void add_rooms(io::FileBatch& batch, const GridMap& map, const Segmentation& segmentation,
               const io::RunInfo& info) {
    check_map(map);
    const Raster<std::uint16_t>& labels = segmentation.labels;
    const bool covers_map = labels.origin == map.states.origin &&
                            labels.width == map.states.width && labels.height == map.states.height;
    if (!covers_map) return add_rooms(batch, map, on_map(map, segmentation), info);
    check_rooms(segmentation);

    const std::vector<io::RoomPair> near_rooms = io::find_near_rooms(map, segmentation);
    const std::vector<io::Rgb> colors =
        io::room_colors(segmentation, near_rooms, info.previous_colors);
    io::MapKeys keys = info.map_keys;
    keys.image = "rooms.png";
    const Executor executor{info.num_threads};
    draw::FloorPlan plan;
    const auto draw = [&] {
        plan = draw::lay_out_floor_plan(map, segmentation, colors, executor);
        return draw::render_png(plan, executor);
    };
    // The picture first: it takes longest, and leaves threads to the others where it cannot use
    // them itself.
    const std::vector<Task> tasks = {
        {"rooms_color.png", draw},
        {"rooms.geojson",
         [&] { return io::to_geojson(map, segmentation, near_rooms, colors, info.regions); }},
        {"rooms.png", [&] { return encode_ids(segmentation, executor); }},
        {"rooms.yaml", [&] { return io::to_rooms_yaml(map, keys, segmentation, colors); }},
        {"graph.json", [&] { return io::to_graph_json(segmentation); }},
    };
    add_files(batch, tasks, executor);
    batch.add("rooms.svg", draw::render_svg(plan));
}

void add_results(io::FileBatch& batch, const GridMap& map, const Segmentation& segmentation,
                 const io::RunInfo& info) {
    const auto start = std::chrono::steady_clock::now();
    add_rooms(batch, map, segmentation, info);
    std::vector<std::pair<std::string, double>> stages_ms = segmentation.report.stages_ms;
    const auto now = std::chrono::steady_clock::now();
    stages_ms.emplace_back("write", std::chrono::duration<double, std::milli>(now - start).count());
    batch.add("report.json", io::to_report_json(map, segmentation, info, stages_ms));
}

}  // namespace quadcut::formats
