// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/bend.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace quadcut::sim {
namespace {

// The arc that a line through `middle` along x becomes.
struct Arc {
    Point middle;
    double radius_m = 100.0;

    [[nodiscard]] Point bend(const Point& p) const {
        const double angle = (p.x - middle.x) / radius_m;
        const double r = radius_m + (p.y - middle.y);
        return {middle.x + r * std::sin(angle), middle.y - radius_m + r * std::cos(angle)};
    }
    [[nodiscard]] Point straighten(const Point& p) const {
        // The centre lies below for a positive radius; both signs measure the angle from the arc.
        const double side = radius_m > 0.0 ? 1.0 : -1.0;
        const double dx = side * (p.x - middle.x);
        const double dy = side * (p.y - middle.y + radius_m);
        const double r = side * std::hypot(dx, dy);
        return {middle.x + radius_m * std::atan2(dx, dy), middle.y + r - radius_m};
    }
};

Polygon cut_edges(const Polygon& polygon) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& p = polygon[i];
        const Point& q = polygon[(i + 1) % polygon.size()];
        const int steps = 1 + static_cast<int>(distance(p, q));
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            result.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
    }
    return result;
}

Polygon bent(const Polygon& polygon, const Arc& arc) {
    Polygon result;
    for (const Point& p : cut_edges(polygon)) result.push_back(arc.bend(p));
    return result;
}

// Where each new cell comes from; the offset is -1 beyond the old ones.
struct Resampling {
    CellGrid grid;
    std::vector<std::ptrdiff_t> from;

    template <typename Value>
    [[nodiscard]] Raster<Value> of(const Raster<Value>& old) const {
        Raster<Value> result({0, 0}, grid.width, grid.height);
        for (std::size_t i = 0; i < from.size(); ++i) {
            if (from[i] >= 0) result.values[i] = old.values[static_cast<std::size_t>(from[i])];
        }
        return result;
    }
};

Resampling resampling_of(const GridMap& map, const Arc& arc) {
    const double r = map.resolution_m;
    const Rect old{map.map_from_image.x, map.map_from_image.y,
                   map.map_from_image.x + map.states.width * r,
                   map.map_from_image.y + map.states.height * r};
    Rect box = kNoRect;
    box.include(bent(to_polygon({}, old), arc));
    Resampling result;
    result.grid = {{std::floor(box.x0 / r) * r, std::floor(box.y0 / r) * r},
                   r,
                   static_cast<std::int32_t>(box.width() / r) + 2,
                   static_cast<std::int32_t>(box.height() / r) + 2};
    const CellGrid grid{{old.x0, old.y0}, r, map.states.width, map.states.height};
    for (std::int32_t y = 0; y < result.grid.height; ++y) {
        for (std::int32_t x = 0; x < result.grid.width; ++x) {
            const Cell cell = grid.cell(arc.straighten(result.grid.center({x, y})));
            result.from.push_back(
                grid.contains(cell) ? static_cast<std::ptrdiff_t>(map.states.offset(cell)) : -1);
        }
    }
    return result;
}

}  // namespace

Building bent(const Building& building, double radius_m) {
    const GridMap& map = building.map;
    const double width_m = map.states.width * map.resolution_m;
    const double height_m = map.states.height * map.resolution_m;
    if (!(std::abs(radius_m) >= 2.0 * height_m)) {
        throw std::logic_error("bent: the radius is at least twice the building's height");
    }
    const Arc arc{{map.map_from_image.x + 0.5 * width_m, map.map_from_image.y + 0.5 * height_m},
                  radius_m};
    const Resampling resampling = resampling_of(map, arc);
    Building result = building;
    const Point& origin = resampling.grid.origin;
    for (GridMap* drawn : {&result.map, &result.bare}) {
        drawn->states = resampling.of(drawn->states);
        drawn->map_from_image = {origin.x, origin.y, 0.0};
    }
    result.labels = resampling.of(building.labels);
    result.bare_labels = resampling.of(building.bare_labels);
    std::vector<std::size_t> num_cells(result.rooms.size() + 1, 0);
    for (const std::uint16_t room : result.bare_labels.values) ++num_cells[room];
    for (TrueRoom& room : result.rooms) {
        for (Polygon& floor : room.floor) floor = bent(floor, arc);
        room.area_m2 = static_cast<double>(num_cells[static_cast<std::size_t>(room.id)]) *
                       map.resolution_m * map.resolution_m;
    }
    for (TrueDoor& door : result.doors) {
        door.jamb_1 = arc.bend(door.jamb_1);
        door.jamb_2 = arc.bend(door.jamb_2);
        door.width_m = distance(door.jamb_1, door.jamb_2);
    }
    return result;
}

}  // namespace quadcut::sim
