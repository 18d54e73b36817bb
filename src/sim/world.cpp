// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/world.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "quadcut/base/random.hpp"
#include "quadcut/map/flood.hpp"
#include "sim/shape.hpp"

namespace quadcut::sim {
namespace {

constexpr double kGroundM = 12.0;
constexpr double kThickestWallM = 0.45;

enum class Beyond { outside, inside };

// A piece of wall seen from one of its rooms: x along it, y out of the room.
struct Bay {
    Frame frame;
    double length = 0.0;
};

class WorldBuilder {
public:
    WorldBuilder(const Building& building, const WorldOptions& options)
        : building_(building), options_(options), random_(Random(options.seed).fork(11)) {}

    World build();

private:
    void lay_out_ground();
    void mark_legs();
    void shut_doors();
    void glaze();
    void glaze_wall(const Frame& wall, double length, const TrueRoom& room);
    void glaze_bay(const Bay& bay, double thickness);
    void furnish_ground();

    template <typename Value>
    static void fill(Raster<Value>& raster, const std::vector<Span>& spans, Value value) {
        for (const Span& span : spans) {
            for (std::int32_t i = 0; i < span.count; ++i) {
                raster.at({span.first.x + i, span.first.y}) = value;
            }
        }
    }
    void block(const Polygon& polygon) {
        fill(world_.map.states, rasterise(polygon, grid_), CellState::occupied);
    }
    [[nodiscard]] CellState state_at(const Point& p) const {
        const Cell cell = grid_.cell(p);
        return grid_.contains(cell) ? bare_.at(cell) : CellState::unknown;
    }
    [[nodiscard]] std::uint32_t label_at(const Point& p) const;
    [[nodiscard]] RoomKind kind_of(RoomId room) const {
        return building_.rooms[static_cast<std::size_t>(room) - 1].kind;
    }
    struct Section {
        double thickness = 0.0;
        Beyond beyond = Beyond::outside;
        std::uint32_t label = 0;
    };
    [[nodiscard]] std::optional<Section> section(const Frame& wall, double x) const;

    const Building& building_;
    const WorldOptions& options_;
    Random random_;
    World world_;
    // Of the whole ground, without furniture.
    Raster<CellState> bare_;
    CellGrid grid_;
    std::int32_t margin_ = 0;
};

void WorldBuilder::lay_out_ground() {
    const GridMap& map = building_.map;
    margin_ = static_cast<std::int32_t>(std::lround(kGroundM / map.resolution_m));
    const double shift = margin_ * map.resolution_m;
    grid_ = {{map.map_from_image.x - shift, map.map_from_image.y - shift},
             map.resolution_m,
             map.states.width + 2 * margin_,
             map.states.height + 2 * margin_};
    world_.map.resolution_m = map.resolution_m;
    world_.map.map_from_image = {grid_.origin.x, grid_.origin.y, 0.0};
    world_.map.states = Raster<CellState>({0, 0}, grid_.width, grid_.height);
    world_.glass = Raster<std::uint8_t>({0, 0}, grid_.width, grid_.height);
    bare_ = world_.map.states;
    for (std::int32_t y = 0; y < map.states.height; ++y) {
        const std::size_t from = map.states.offset({0, y});
        const std::size_t to = bare_.offset({margin_, y + margin_});
        const auto copy = [&](const Raster<CellState>& source, Raster<CellState>& target) {
            std::copy_n(source.values.begin() + static_cast<std::ptrdiff_t>(from), source.width,
                        target.values.begin() + static_cast<std::ptrdiff_t>(to));
        };
        copy(map.states, world_.map.states);
        copy(building_.bare.states, bare_);
    }
}

std::uint32_t WorldBuilder::label_at(const Point& p) const {
    const Cell cell = grid_.cell(p);
    const Cell in_building{cell.x - margin_, cell.y - margin_};
    const Raster<std::uint16_t>& labels = building_.bare_labels;
    return labels.contains(in_building) ? labels.at(in_building) : 0U;
}

// What stands on the floor alone and is no larger than a few cells.
void WorldBuilder::mark_legs() {
    constexpr double kLegM2 = 0.011;
    const double cell_m2 = grid_.resolution_m * grid_.resolution_m;
    const Raster<CellState>& states = world_.map.states;
    const auto is_furniture = [&](std::size_t i) {
        return states.values[i] == CellState::occupied && bare_.values[i] == CellState::free;
    };
    std::vector<bool> seen(states.values.size(), false);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (seen[i] || !is_furniture(i)) continue;
        const std::vector<std::size_t> thing =
            flood(states, i, seen, Connectivity::eight, is_furniture);
        if (static_cast<double>(thing.size()) * cell_m2 > kLegM2) continue;
        for (const std::size_t cell : thing) world_.glass.values[cell] = World::kThin;
    }
}

void WorldBuilder::shut_doors() {
    for (const TrueDoor& door : building_.doors) {
        const double choice = random_.uniform();
        const double turn = random_.uniform(0.2, 1.1) * (random_.uniform() < 0.5 ? 1.0 : -1.0);
        const bool hinge_first = random_.uniform() < 0.5;
        // Fire doors are held open by magnets.
        const bool is_fire_door =
            kind_of(door.a) == RoomKind::corridor && kind_of(door.b) == RoomKind::corridor;
        const bool is_open = choice >= options_.closed_doors + options_.doors_ajar;
        if (door.is_open_passage || is_fire_door || is_open) continue;
        const Point from = hinge_first ? door.jamb_1 : door.jamb_2;
        const Point to = hinge_first ? door.jamb_2 : door.jamb_1;
        const double angle = std::atan2(to.y - from.y, to.x - from.x) +
                             (choice < options_.closed_doors ? 0.0 : turn);
        const Point u{std::cos(angle), std::sin(angle)};
        const double half = std::max(0.03, 0.6 * grid_.resolution_m);
        block(to_polygon({from, u, {-u.y, u.x}}, {0.0, -half, distance(from, to), half}));
    }
}

// What lies behind a place of a wall; nothing where there is no wall of the usual kind.
std::optional<WorldBuilder::Section> WorldBuilder::section(const Frame& wall, double x) const {
    const double step = 0.4 * grid_.resolution_m;
    double y = step;
    // The floor may end a cell behind its edge, and stop short of it.
    while (y < 1.5 * grid_.resolution_m && state_at(wall.map({x, y})) == CellState::free) y += step;
    if (state_at(wall.map({x, y})) != CellState::occupied) return std::nullopt;
    while (y < kThickestWallM && state_at(wall.map({x, y})) == CellState::occupied) y += step;
    if (y >= kThickestWallM) return std::nullopt;
    const std::uint32_t label = label_at(wall.map({x, y + step}));
    if (label != 0) return Section{y, Beyond::inside, label};
    if (state_at(wall.map({x, y + step})) != CellState::unknown) return std::nullopt;
    return Section{y, Beyond::outside, 0};
}

// One line of glass cells in place of the wall.
void WorldBuilder::glaze_bay(const Bay& bay, double thickness) {
    const double r = grid_.resolution_m;
    const Polygon wall = to_polygon(bay.frame, {0.0, -0.5 * r, bay.length, thickness + 0.5 * r});
    for (const Span& span : rasterise(wall, grid_)) {
        for (std::int32_t i = 0; i < span.count; ++i) {
            const Cell cell{span.first.x + i, span.first.y};
            if (bare_.at(cell) == CellState::occupied) {
                world_.map.states.at(cell) = CellState::unknown;
            }
        }
    }
    const double middle = 0.5 * thickness;
    const std::vector<Span> pane = rasterise(
        to_polygon(bay.frame, {0.0, middle - 0.7 * r, bay.length, middle + 0.7 * r}), grid_);
    fill(world_.map.states, pane, CellState::occupied);
    const double degrees = std::atan2(bay.frame.v.y, bay.frame.v.x) * 180.0 / M_PI;
    const auto normal = static_cast<int>(std::lround(degrees + 360.0)) % 180;
    fill(world_.glass, pane, static_cast<std::uint8_t>(normal + 1));
}

void WorldBuilder::glaze_wall(const Frame& wall, double length, const TrueRoom& room) {
    const std::optional<Section> middle = section(wall, 0.5 * length);
    const double outer = random_.uniform();
    const double inner = random_.uniform();
    const double mullion = random_.uniform(0.06, 0.4);
    const double pitch = random_.uniform(0.9, 2.2);
    const double coverage = random_.uniform(0.4, 1.0);
    if (!middle || length < 1.2) return;
    const bool is_way = room.kind != RoomKind::room;
    if (middle->beyond == Beyond::outside ? outer >= options_.windows
                                          : !is_way || inner >= options_.glass_walls) {
        return;
    }
    for (double x = 0.15; x + pitch < length; x += pitch) {
        const double end = x + pitch - mullion;
        if (random_.uniform() > coverage || end - x < 0.3) continue;
        const std::optional<Section> first = section(wall, x + 0.05);
        const std::optional<Section> last = section(wall, end - 0.05);
        if (!first || !last || first->beyond != middle->beyond || last->beyond != middle->beyond) {
            continue;
        }
        glaze_bay({wall.at({x, 0.0}), end - x}, std::max(first->thickness, last->thickness));
    }
}

void WorldBuilder::glaze() {
    for (const TrueRoom& room : building_.rooms) {
        for (const Polygon& floor : room.floor) {
            double twice_area = 0.0;
            for (std::size_t i = 0; i < floor.size(); ++i) {
                const Point& p = floor[i];
                const Point& q = floor[(i + 1) % floor.size()];
                twice_area += p.x * q.y - q.x * p.y;
            }
            const double side = twice_area > 0.0 ? 1.0 : -1.0;
            for (std::size_t i = 0; i < floor.size(); ++i) {
                const Point& p = floor[i];
                const Point& q = floor[(i + 1) % floor.size()];
                const double length = distance(p, q);
                if (length < 1.0) continue;
                const Point u{(q.x - p.x) / length, (q.y - p.y) / length};
                glaze_wall({p, u, {side * u.y, -side * u.x}}, length, room);
            }
        }
    }
}

// Trees, cars, hedges and facades, where nothing is near.
void WorldBuilder::furnish_ground() {
    const double width = grid_.width * grid_.resolution_m;
    const double height = grid_.height * grid_.resolution_m;
    const auto is_clear = [&](const Polygon& polygon) {
        const std::vector<Span> spans = rasterise(grow(polygon, 0.8), grid_);
        return std::all_of(spans.begin(), spans.end(), [&](const Span& span) {
            for (std::int32_t i = 0; i < span.count; ++i) {
                const Cell cell{span.first.x + i, span.first.y};
                if (bare_.at(cell) != CellState::unknown) return false;
            }
            return true;
        });
    };
    const auto num_things = static_cast<int>((width + height) * random_.uniform(0.1, 0.9));
    for (int i = 0; i < num_things; ++i) {
        const Point at{grid_.origin.x + random_.uniform(0.0, width),
                       grid_.origin.y + random_.uniform(0.0, height)};
        const double choice = random_.uniform();
        const double angle = random_.uniform(0.0, M_PI);
        const Point u{std::cos(angle), std::sin(angle)};
        const double length = choice < 0.6   ? random_.uniform(0.15, 0.7)
                              : choice < 0.8 ? random_.uniform(1.5, 4.5)
                                             : random_.uniform(5.0, 15.0);
        const double depth = choice < 0.6 ? length : choice < 0.8 ? 1.7 : 0.2;
        const Polygon box = to_polygon({at, u, {-u.y, u.x}}, {0.0, 0.0, length, depth});
        if (is_clear(box)) block(box);
    }
}

World WorldBuilder::build() {
    lay_out_ground();
    mark_legs();
    shut_doors();
    glaze();
    furnish_ground();
    return std::move(world_);
}

}  // namespace

World draw_world(const Building& building, const WorldOptions& options) {
    return WorldBuilder(building, options).build();
}

}  // namespace quadcut::sim
