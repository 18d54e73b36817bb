// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/column.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadcut::sim {
namespace {

// How often a building has columns, along corridors and in rooms.
constexpr double kInCorridors = 0.35;
constexpr double kInRooms = 0.4;

class ColumnBuilder {
public:
    ColumnBuilder(Plan& plan, Random& random) : plan_(plan), random_(random) {
        for (const PlanDoor& door : plan.doors) {
            Rect zone = door.opening;
            zone = {zone.x0 - 0.25, zone.y0 - 0.8, zone.x1 + 0.25, zone.y1 + 0.8};
            doors_.push_back(to_polygon(door.frame, zone));
        }
    }

    void line_corridors();
    void line_rooms();

private:
    // Whether the wall behind a column is whole, and no door is near.
    [[nodiscard]] bool is_wall(const Polygon& column, const Polygon& behind,
                               const PlanRoom& room) const;
    void add(const PlanRoom& room, const Frame& wall, double x, double width, double depth);

    Plan& plan_;
    Random& random_;
    std::vector<Polygon> doors_;
};

bool ColumnBuilder::is_wall(const Polygon& column, const Polygon& behind,
                            const PlanRoom& room) const {
    for (const Polygon& door : doors_) {
        if (overlap(column, door)) return false;
    }
    for (const FloorPart& part : room.parts) {
        if (overlap(behind, to_polygon(part.frame, part.rect))) return false;
    }
    return std::none_of(room.wedges.begin(), room.wedges.end(),
                        [&](const Polygon& wedge) { return overlap(behind, wedge); });
}

// `wall`: x along the wall, y into the room.
void ColumnBuilder::add(const PlanRoom& room, const Frame& wall, double x, double width,
                        double depth) {
    const Polygon column = to_polygon(wall, {x - 0.5 * width, -0.05, x + 0.5 * width, depth});
    const Polygon behind = to_polygon(wall, {x - width, -0.1, x + width, -0.01});
    if (is_wall(column, behind, room)) plan_.pillars.push_back(column);
}

void ColumnBuilder::line_corridors() {
    const double pitch = random_.uniform(3.5, 6.0);
    const double width = random_.uniform(0.25, 0.5);
    const double depth = random_.uniform(0.1, 0.25);
    const bool both_sides = random_.uniform() < 0.6;
    for (const PlanRoom& room : plan_.rooms) {
        if (room.use != RoomUse::corridor) continue;
        for (const FloorPart& part : room.parts) {
            const Rect& r = part.rect;
            const bool along_x = r.width() >= r.height();
            const double length = std::max(r.width(), r.height());
            const double across = std::min(r.width(), r.height());
            const double reach = std::min(depth, across * (both_sides ? 0.125 : 0.25));
            const Frame f = along_x ? part.frame : part.frame.swapped();
            const Point low = along_x ? Point{r.x0, r.y0} : Point{r.y0, r.x0};
            const Frame near = f.at(low);
            const Frame at_far_side = f.at({low.x, low.y + across});
            const Frame far{at_far_side.origin, f.u, {-f.v.x, -f.v.y}};
            for (double x = 0.5 * pitch; x + 0.5 * pitch <= length; x += pitch) {
                add(room, near, x, width, reach);
                if (both_sides) add(room, far, x, width, reach);
            }
        }
    }
}

void ColumnBuilder::line_rooms() {
    const double pitch = random_.uniform(2.8, 4.5);
    const double width = random_.uniform(0.25, 0.5);
    const double depth = random_.uniform(0.12, 0.35);
    for (const PlanRoom& room : plan_.rooms) {
        const FloorPart& part = room.parts.front();
        const Rect& r = part.rect;
        const bool is_small = r.area() < 12.0 || r.width() < pitch;
        const bool is_way = room.use == RoomUse::corridor || room.use == RoomUse::aisle;
        if (is_way || is_small || room.use == RoomUse::cubicle) continue;
        const Frame top{
            part.frame.map({r.x0, r.y1}), part.frame.u, {-part.frame.v.x, -part.frame.v.y}};
        const auto bays = static_cast<int>(std::lround(r.width() / pitch));
        for (int i = 1; i < bays; ++i) add(room, top, r.width() * i / bays, width, depth);
    }
}

}  // namespace

void add_columns(Plan& plan, Random random) {
    ColumnBuilder builder(plan, random);
    if (random.uniform() < kInCorridors) builder.line_corridors();
    if (random.uniform() < kInRooms) builder.line_rooms();
}

}  // namespace quadcut::sim
