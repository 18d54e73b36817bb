// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/building.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "quadcut/base/error.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/map/flood.hpp"
#include "sim/furniture.hpp"
#include "sim/layout.hpp"
#include "sim/plan.hpp"

namespace quadcut::sim {
namespace {

// Unknown ground around the building.
constexpr double kMargin = 1.0;

// By RoomUse.
constexpr std::array kNames{"Corridor",     "Aisle",      "Hall",      "Office",  "Open office",
                            "Meeting room", "Laboratory", "Classroom", "Cubicle", "Washroom",
                            "Toilet",       "Storage",    "Kitchen",   "Lounge",  "Bedroom",
                            "Ward",         "Bathroom"};
static_assert(kNames.size() == static_cast<std::size_t>(RoomUse::bathroom) + 1);

RoomKind kind_of(RoomUse use) {
    switch (use) {
        case RoomUse::corridor:
        case RoomUse::aisle:
            return RoomKind::corridor;
        case RoomUse::hall:
            return RoomKind::hall;
        default:
            return RoomKind::room;
    }
}

// Floor and doorways of a room as polygons.
std::vector<Polygon> floor_of(const PlanRoom& room) {
    std::vector<Polygon> polygons = room.wedges;
    for (const FloorPart& part : room.parts) {
        polygons.push_back(to_polygon(part.frame, part.rect));
    }
    return polygons;
}

class Draughtsman {
public:
    Draughtsman(const Plan& plan, const BuildingOptions& options)
        : plan_(plan), options_(options) {}

    Building draw();

private:
    void lay_out_grid();
    void draw_walls();
    void draw_floors();
    void drop_islets();
    void draw_furniture();
    void draw_obstacle(const Obstacle& obstacle);
    void describe();

    template <typename Value>
    static void fill(Raster<Value>& raster, const std::vector<Span>& spans, Value value) {
        for (const Span& span : spans) {
            const auto first =
                raster.values.begin() + static_cast<std::ptrdiff_t>(raster.offset(span.first));
            std::fill(first, first + span.count, value);
        }
    }
    void fill_floor(const Polygon& polygon, std::size_t room) {
        const std::vector<Span> spans = rasterise(polygon, grid_);
        fill(building_.bare.states, spans, CellState::free);
        fill(building_.bare_labels, spans, static_cast<std::uint16_t>(room + 1));
    }

    const Plan& plan_;
    const BuildingOptions& options_;
    CellGrid grid_;
    Building building_;
};

void Draughtsman::lay_out_grid() {
    Rect box = kNoRect;
    for (const PlanRoom& room : plan_.rooms) {
        for (const Polygon& polygon : floor_of(room)) box.include(polygon);
    }
    const double r = options_.resolution_m;
    box = grow(box, kMargin);
    grid_.resolution_m = r;
    grid_.origin = {std::floor(box.x0 / r) * r, std::floor(box.y0 / r) * r};
    grid_.width = static_cast<std::int32_t>(std::ceil((box.x1 - grid_.origin.x) / r));
    grid_.height = static_cast<std::int32_t>(std::ceil((box.y1 - grid_.origin.y) / r));
    building_.bare.resolution_m = r;
    building_.bare.map_from_image = {grid_.origin.x, grid_.origin.y, 0.0};
    building_.bare.states = Raster<CellState>({0, 0}, grid_.width, grid_.height);
    building_.bare_labels = Raster<std::uint16_t>({0, 0}, grid_.width, grid_.height);
}

// A band of wall around all floor; the floor is drawn over it.
void Draughtsman::draw_walls() {
    for (const PlanRoom& room : plan_.rooms) {
        for (const Polygon& polygon : floor_of(room)) {
            fill(building_.bare.states, rasterise(grow(polygon, room.wall_m), grid_),
                 CellState::occupied);
        }
    }
    for (const Shaft& shaft : plan_.shafts) {
        if (!shaft.drawn_free) continue;
        fill(building_.bare.states, rasterise(grow(shaft.outline, 0.12), grid_),
             CellState::occupied);
    }
}

void Draughtsman::draw_floors() {
    for (const Shaft& shaft : plan_.shafts) {
        if (shaft.drawn_free) {
            fill(building_.bare.states, rasterise(shaft.outline, grid_), CellState::free);
        }
    }
    for (std::size_t i = 0; i < plan_.rooms.size(); ++i) {
        for (const Polygon& polygon : floor_of(plan_.rooms[i])) fill_floor(polygon, i);
    }
    for (const PlanDoor& door : plan_.doors) {
        Rect low = door.opening;
        Rect high = door.opening;
        low.y1 = high.y0 = door.opening.center().y;
        fill_floor(to_polygon(door.frame, low), door.a);
        fill_floor(to_polygon(door.frame, high), door.b);
    }
    for (const Polygon& pillar : plan_.pillars) {
        const std::vector<Span> spans = rasterise(pillar, grid_);
        fill(building_.bare.states, spans, CellState::occupied);
        fill(building_.bare_labels, spans, std::uint16_t{0});
    }
}

// Single cells at the corners of turned floors may hang on by a corner only: they become wall.
void Draughtsman::drop_islets() {
    Raster<std::uint16_t>& labels = building_.bare_labels;
    std::vector<std::vector<std::size_t>> largest(plan_.rooms.size());
    std::vector<bool> seen(labels.values.size(), false);
    const auto drop = [&](const std::vector<std::size_t>& cells) {
        for (const std::size_t i : cells) {
            labels.values[i] = 0;
            building_.bare.states.values[i] = CellState::occupied;
        }
    };
    for (std::size_t start = 0; start < seen.size(); ++start) {
        const std::uint16_t label = labels.values[start];
        if (label == 0 || seen[start]) continue;
        std::vector<std::size_t> part =
            flood(labels, start, seen, Connectivity::four,
                  [&](std::size_t i) { return labels.values[i] == label; });
        std::vector<std::size_t>& best = largest[label - 1U];
        if (part.size() > best.size()) std::swap(part, best);
        drop(part);
    }
}

// A large box shows its outline: nobody sees what is inside.
void Draughtsman::draw_obstacle(const Obstacle& obstacle) {
    Raster<CellState>& states = building_.map.states;
    const std::vector<Span> spans = obstacle.box.empty()
                                        ? rasterise_disc(obstacle.center, obstacle.radius_m, grid_)
                                        : rasterise(obstacle.box, grid_);
    fill(states, spans, CellState::occupied);
    fill(building_.labels, spans, std::uint16_t{0});
    constexpr double kSkin = 0.1;
    if (obstacle.box.empty() || area(obstacle.box) < 0.1) return;
    const double short_side = std::min(distance(obstacle.box[0], obstacle.box[1]),
                                       distance(obstacle.box[1], obstacle.box[2]));
    if (short_side < 2.5 * kSkin) return;
    fill(states, rasterise(grow(obstacle.box, -kSkin), grid_), CellState::unknown);
}

void Draughtsman::draw_furniture() {
    building_.map = building_.bare;
    building_.labels = building_.bare_labels;
    const Random random = Random(options_.seed).fork(2);
    for (std::size_t room = 0; room < plan_.rooms.size(); ++room) {
        const std::vector<Obstacle> obstacles =
            furnish(plan_, room, {options_.furniture, options_.open_leaves, options_.clutter},
                    building_.bare_labels, grid_, random.fork(room));
        for (const Obstacle& obstacle : obstacles) draw_obstacle(obstacle);
    }
}

void Draughtsman::describe() {
    std::vector<std::size_t> num_cells(plan_.rooms.size() + 1, 0);
    for (const std::uint16_t label : building_.bare_labels.values) ++num_cells[label];
    std::map<std::string, int> count_of;
    const double cell_area = options_.resolution_m * options_.resolution_m;
    for (std::size_t i = 0; i < plan_.rooms.size(); ++i) {
        const PlanRoom& room = plan_.rooms[i];
        const std::string name = kNames[static_cast<std::size_t>(room.use)];
        building_.rooms.push_back({static_cast<RoomId>(i + 1),
                                   name + " " + std::to_string(++count_of[name]), kind_of(room.use),
                                   static_cast<double>(num_cells[i + 1]) * cell_area,
                                   floor_of(room), 0});
    }
    for (const PlanDoor& door : plan_.doors) {
        const double y = door.opening.center().y;
        building_.doors.push_back({static_cast<RoomId>(door.a + 1), static_cast<RoomId>(door.b + 1),
                                   door.frame.map({door.opening.x0, y}),
                                   door.frame.map({door.opening.x1, y}), door.opening.width(),
                                   door.is_open_passage});
    }
}

Building Draughtsman::draw() {
    lay_out_grid();
    draw_walls();
    draw_floors();
    drop_islets();
    draw_furniture();
    describe();
    return std::move(building_);
}

void check(bool is_good, const char* message) {
    if (!is_good) throw InputError(message);
}

}  // namespace

Building draw_building(const Plan& plan, const BuildingOptions& options) {
    if (plan.rooms.empty() || plan.rooms.size() >= std::numeric_limits<std::uint16_t>::max()) {
        throw std::logic_error("draw_building: a plan has 1 to 65534 rooms");
    }
    // Written so that NaN is refused as well.
    check(options.furniture >= 0.0 && options.furniture <= 1.0, "furniture: expected 0..1");
    check(options.resolution_m >= 0.02 && options.resolution_m <= 0.1,
          "resolution: expected 0.02..0.1 m");
    check(options.open_leaves >= 0.0 && options.open_leaves <= 1.0, "open_leaves: expected 0..1");
    check(options.clutter >= 0.0 && options.clutter <= 1.0, "clutter: expected 0..1");
    return Draughtsman(plan, options).draw();
}

Building generate_building(const BuildingOptions& options) {
    check(options.num_rooms >= 3 && options.num_rooms <= 1000, "rooms: expected 3..1000");
    check(options.turned_wings >= 0.0 && options.turned_wings <= 1.0,
          "turned_wings: expected 0..1");
    check(options.openness >= 0.0 && options.openness <= 1.0, "openness: expected 0..1");
    check(std::isfinite(options.yaw_rad), "yaw: expected a finite angle");
    check(options.num_wings >= 0 && options.num_wings <= 20, "wings: expected 0..20");
    const Layout layout = draw_layout({options.seed, options.num_rooms, options.turned_wings,
                                       options.num_wings, options.yaw_rad, options.openness});
    Building building = draw_building(layout.plan, options);
    for (std::size_t i = 0; i < building.rooms.size(); ++i) {
        building.rooms[i].wing = layout.wing_of_room[i];
    }
    building.num_turned_wings = layout.num_turned_wings;
    return building;
}

}  // namespace quadcut::sim
