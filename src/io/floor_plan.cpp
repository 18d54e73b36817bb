// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/floor_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "io/floor_cells.hpp"
#include "io/number_text.hpp"
#include "io/outline.hpp"
#include "io/room_places.hpp"
#include "io/room_text.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/segment/label_tally.hpp"

namespace quadcut::io {
namespace {

constexpr double kLongPage = 2400.0;
constexpr double kLongestPage = 8000.0;  // With the margins it is 8192 at most.
/// The page on which lines and letters have their nominal sizes.
constexpr double kNominalPage = 2000.0;

struct Layout {
    PageScale scale;
    /// Scales line widths and letters.
    double unit = 1.0;
};

/// Few rooms leave space for larger letters.
double letter_scale(std::size_t num_rooms) {
    constexpr double kManyRooms = 24.0;
    constexpr double kLargest = 1.5;
    const double rooms = std::max<double>(static_cast<double>(num_rooms), 1.0);
    return std::clamp(std::sqrt(std::sqrt(kManyRooms / rooms)), 1.0, kLargest);
}

/// Sets the page's size, and where cells come to lie on it.
Layout set_page(const Raster<std::uint16_t>& ground, FloorPlan& plan) {
    const double longest = std::max(ground.width, ground.height);
    const double pixels_per_cell = longest <= kLongPage ? std::floor(kLongPage / longest)
                                                        : std::min(1.0, kLongestPage / longest);
    const double width = std::ceil(ground.width * pixels_per_cell);
    const double height = std::ceil(ground.height * pixels_per_cell);
    Layout layout;
    layout.unit = std::sqrt(std::max(std::max(width, height), kNominalPage / 4.0) / kNominalPage);

    constexpr double kMargin = 24.0;
    constexpr double kFooter = 64.0;
    const double margin = std::round(kMargin * layout.unit);
    plan.page_width = static_cast<std::int32_t>(width + 2.0 * margin);
    plan.page_height =
        static_cast<std::int32_t>(height + margin + std::round(kFooter * layout.unit));
    plan.drawing_origin = {margin, margin};
    plan.pixels_per_half_cell = pixels_per_cell / 2.0;
    layout.scale = {margin - ground.origin.x * pixels_per_cell,
                    margin + (ground.origin.y + ground.height) * pixels_per_cell, pixels_per_cell};
    return layout;
}

/// From the map's half cells, y up, to the drawing's.
std::vector<DrawnRing> draw_rings(const RegionOutline& region, const Box& frame) {
    std::vector<DrawnRing> rings;
    for (const OutlineRing& outline : region.rings) {
        DrawnRing ring = smooth_ring(outline);
        for (HalfCell& point : ring) {
            point = {point.x - 2 * frame.low.x, 2 * (frame.high.y + 1) - point.y};
        }
        if (ring.size() > 2) rings.push_back(std::move(ring));
    }
    return rings;
}

void append(std::vector<DrawnRing>& to, std::vector<DrawnRing> rings) {
    std::move(rings.begin(), rings.end(), std::back_inserter(to));
}

void draw_cells(const FloorCells& cells, const Executor& executor, FloorPlan& plan) {
    for (const RegionOutline& region : trace_outlines(cells.ground, kWall, executor)) {
        std::vector<DrawnRing> rings = draw_rings(region, plan.frame);
        if (region.value == kLooseFree) {
            append(plan.loose_free, std::move(rings));
        } else if (region.value == kWallCore) {
            append(plan.wall_cores, std::move(rings));
        } else if (region.value == kWall) {
            append(plan.walls, std::move(rings));
        } else {
            append(plan.rooms[region.value - 1].rings, std::move(rings));
        }
    }
    for (const RegionOutline& region : trace_outlines(cells.furniture, kFurniture, executor)) {
        append(region.value == kFurniture ? plan.furniture : plan.furniture_insides,
               draw_rings(region, plan.frame));
    }
}

/// 1, 2 or 5 times a power of ten metres, about a fifth of the page.
ScaleBar set_scale_bar(const FloorPlan& plan, const Layout& layout, double resolution_m) {
    constexpr double kShareOfPage = 0.2;
    const double pixels_per_metre = layout.scale.pixels_per_cell / resolution_m;
    const double longest_m = kShareOfPage * plan.page_width / pixels_per_metre;
    const double decade = std::pow(10.0, std::floor(std::log10(longest_m)));
    double length_m = decade;
    for (const double factor : {2.0, 5.0}) {
        if (factor * decade <= longest_m) length_m = factor * decade;
    }
    ScaleBar bar;
    bar.length = length_m * pixels_per_metre;
    bar.height = std::round(5.0 * layout.unit);
    bar.text_size = 18.0 * layout.unit;
    bar.text = rounded(length_m) + " m";
    bar.origin = {plan.drawing_origin.x, plan.page_height - plan.drawing_origin.x};
    return bar;
}

/// A point of the map frame in cells.
class CellsFromMap {
public:
    explicit CellsFromMap(const GridMap& map)
        : image_from_map_(inverse(map.map_from_image)), resolution_m_(map.resolution_m) {}
    [[nodiscard]] Point operator()(const Point& point) const {
        const Point metres = transform(image_from_map_, point);
        return {metres.x / resolution_m_, metres.y / resolution_m_};
    }

private:
    Pose image_from_map_;
    double resolution_m_;
};

/// The rooms without what furniture stands on, and of each room the point farthest from all
/// obstacles, in cells.
struct BareFloor {
    Raster<std::uint16_t> ground;
    std::vector<Point> inner_points;
};

/// The cell farthest from all obstacles; of several, the first.
struct Innermost {
    float clearance = 0.0F;
    std::size_t place = 0;
};

BareFloor clear_floor(const FloorCells& cells, std::size_t num_rooms, const Executor& executor) {
    BareFloor floor{cells.ground, std::vector<Point>(num_rooms)};
    Raster<std::uint8_t> open(cells.ground.origin, cells.ground.width, cells.ground.height);
    constexpr std::size_t kCells = std::size_t{1} << 16U;
    parallel_for(executor, open.values.size(), kCells, [&](std::size_t first, std::size_t last) {
        std::uint16_t* const ground = floor.ground.values.data();
        std::uint8_t* const is_open = open.values.data();
        const std::uint8_t* const furniture = cells.furniture.values.data();
        for (std::size_t i = first; i < last; ++i) {
            const bool is_bare = ground[i] < kFirstNonRoom && furniture[i] == 0;
            ground[i] = is_bare ? ground[i] : std::uint16_t{0};
            is_open[i] = std::uint8_t{ground[i] != 0};
        }
    });
    const Raster<float> clearance = clearance_m(open, 1.0, executor);
    const std::vector<Innermost> most = tally_by_label<Innermost>(
        floor.ground, executor,
        [&](Innermost& innermost, const LabelRun& run) {
            const float* const begin = clearance.values.data() + run.offset;
            const float here = largest(begin, run.num_cells, innermost.clearance);
            if (here <= innermost.clearance) return;
            const auto place = std::find(begin, begin + run.num_cells, here) - begin;
            innermost = {here, run.offset + static_cast<std::size_t>(place)};
        },
        [](Innermost& into, const Innermost& other) {
            if (other.clearance > into.clearance) into = other;
        });
    for (std::size_t room = 1; room < most.size() && room <= num_rooms; ++room) {
        if (most[room].clearance == 0.0F) continue;
        const Cell cell = open.cell(most[room].place);
        floor.inner_points[room - 1] = {cell.x + 0.5, cell.y + 0.5};
    }
    return floor;
}

/// Beside the furniture where that does not make letters much smaller, on it where it does.
void place_labels(const FloorCells& cells, const std::vector<Room>& rooms,
                  const CellsFromMap& cells_from_map, const Layout& layout,
                  const Executor& executor, FloorPlan& plan) {
    constexpr double kWorthIt = 0.75;
    const Typeface typeface;
    // Of larger maps, a page shows no furniture that letters could stand on.
    constexpr std::size_t kMostCells = std::size_t{1} << 25U;
    std::optional<BareFloor> bare;
    if (cells.ground.values.size() <= kMostCells) bare = clear_floor(cells, rooms.size(), executor);
    const double unit = layout.unit * letter_scale(rooms.size());
    std::vector<std::optional<RoomLabel>> labels(rooms.size());
    const auto place = [&](std::size_t i) {
        LabelText text{static_cast<std::uint32_t>(i + 1), plan.rooms[i].name, plan.rooms[i].area,
                       cells_from_map(rooms[i].label_point), cells_from_map(rooms[i].centroid)};
        labels[i] = place_label(text, cells.ground, layout.scale, unit, typeface);
        if (!labels[i] || !bare) return;
        text.label_point = bare->inner_points[i];
        auto beside = place_label(text, bare->ground, layout.scale, unit, typeface);
        const bool worth_it = beside && beside->name.size >= kWorthIt * labels[i]->name.size &&
                              (beside->area || !labels[i]->area);
        if (worth_it) labels[i] = std::move(beside);
    };
    parallel_for(executor, rooms.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) place(i);
    });
    for (std::optional<RoomLabel>& label : labels) {
        if (label) plan.labels.push_back(std::move(*label));
    }
}

}  // namespace

std::array<Point, 8> ScaleBar::outline() const {
    const double right = origin.x + length;
    const double top = origin.y - height;
    const double tick_top = origin.y - 2.0 * height;
    const double tick = height / 3.0;
    return {{{origin.x, origin.y},
             {right, origin.y},
             {right, tick_top},
             {right - tick, tick_top},
             {right - tick, top},
             {origin.x + tick, top},
             {origin.x + tick, tick_top},
             {origin.x, tick_top}}};
}

Point ScaleBar::text_left() const { return {origin.x + length + 0.6 * text_size, origin.y}; }

FloorPlan lay_out_floor_plan(const GridMap& map, const Segmentation& segmentation,
                             std::span<const Rgb> colors, const Executor& executor) {
    const FloorCells cells = sort_floor_cells(map, segmentation.labels, executor);
    FloorPlan plan;
    const Layout layout = set_page(cells.ground, plan);
    plan.frame = cells.ground.box();
    plan.border_width = 1.6 * layout.unit;
    plan.door_width = 5.0 * layout.unit;
    for (std::size_t i = 0; i < segmentation.rooms.size(); ++i) {
        const Room& room = segmentation.rooms[i];
        plan.rooms.push_back({room.id,
                              colors[i],
                              {},
                              name_of(room),
                              area_text(room.area_m2),
                              std::string(to_text(room.kind))});
    }
    draw_cells(cells, executor, plan);

    const CellsFromMap cells_from_map(map);
    const std::map<RoomId, std::size_t> places = room_places(segmentation.rooms);
    for (const Door& door : segmentation.doors) {
        plan.doors.push_back({layout.scale.to_page(cells_from_map(door.jamb_1)),
                              layout.scale.to_page(cells_from_map(door.jamb_2)),
                              "Door between " + plan.rooms[places.at(door.a)].name + " and " +
                                  plan.rooms[places.at(door.b)].name + ", " +
                                  rounded(door.width_m, 2) + " m"});
    }
    place_labels(cells, segmentation.rooms, cells_from_map, layout, executor, plan);
    plan.scale_bar = set_scale_bar(plan, layout, map.resolution_m);
    return plan;
}

FloorPlan placed(FloorPlan plan, double factor, const Point& shift) {
    const auto place = [&](Point& point) {
        point = {point.x * factor + shift.x, point.y * factor + shift.y};
    };
    const auto place_text = [&](TextLine& line) {
        line.size *= factor;
        place(line.anchor);
    };
    plan.page_width = static_cast<std::int32_t>(std::ceil(plan.page_width * factor));
    plan.page_height = static_cast<std::int32_t>(std::ceil(plan.page_height * factor));
    place(plan.drawing_origin);
    plan.pixels_per_half_cell *= factor;
    plan.border_width *= factor;
    plan.door_width *= factor;
    for (DrawnDoor& door : plan.doors) {
        place(door.from);
        place(door.to);
    }
    for (RoomLabel& label : plan.labels) {
        place_text(label.name);
        if (label.area) place_text(*label.area);
    }
    place(plan.scale_bar.origin);
    plan.scale_bar.length *= factor;
    plan.scale_bar.height *= factor;
    plan.scale_bar.text_size *= factor;
    return plan;
}

}  // namespace quadcut::io
