// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/floor_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "draw/floor_cells.hpp"
#include "draw/lettering.hpp"
#include "io/number_text.hpp"
#include "io/outline.hpp"
#include "io/room_places.hpp"
#include "io/room_text.hpp"

namespace quadcut::draw {
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
std::vector<DrawnRing> draw_rings(const io::RegionOutline& region, const Box& frame) {
    std::vector<DrawnRing> rings;
    for (const io::OutlineRing& outline : region.rings) {
        DrawnRing ring = io::smooth_ring(outline);
        for (io::HalfCell& point : ring) {
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
    for (const io::RegionOutline& region : io::trace_outlines(cells.ground, kWall, executor)) {
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
    for (const io::RegionOutline& region :
         io::trace_outlines(cells.furniture, kFurniture, executor)) {
        append(region.value == kFurniture ? plan.furniture : plan.furniture_insides,
               draw_rings(region, plan.frame));
    }
}

io::Rgb ink_of_zone(std::uint32_t zone) { return kZoneInks[(zone - 1) % kZoneInks.size()]; }

/// With zones, in the tint of its zone; glimpses are pale.
DrawnRoom describe_room(const Segmentation& segmentation, std::size_t place, io::Rgb color) {
    const Room& room = segmentation.rooms[place];
    std::string kind(io::to_text(room.kind));
    if (segmentation.zones.count != 0) {
        const std::uint32_t zone = segmentation.zones.zone_of_room[place];
        color = io::mixed(color, ink_of_zone(zone), kZoneShare);
        kind += ", zone " + std::to_string(zone);
    }
    if (room.seen == Seen::glimpse) {
        color = io::mixed(color, kPaper, kPaleShare);
        kind = "glimpse";
    }
    return {room.id, color, {}, io::name_of(room), io::area_text(room.area_m2), std::move(kind)};
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
    bar.text = io::rounded(length_m) + " m";
    bar.origin = {plan.drawing_origin.x, plan.page_height - plan.drawing_origin.x};
    return bar;
}

/// What is to be said of each room, and where.
std::vector<RoomWords> words_for(const std::vector<Room>& rooms, const FloorPlan& plan,
                                 const CellsFromMap& cells_from_map) {
    std::vector<RoomWords> words;
    for (std::size_t i = 0; i < rooms.size(); ++i) {
        words.push_back({plan.rooms[i].name, plan.rooms[i].area, std::to_string(index(rooms[i].id)),
                         cells_from_map(rooms[i].label_point), cells_from_map(rooms[i].centroid)});
    }
    return words;
}

constexpr double kLegendSize = 16.0;
constexpr double kLeastLegendSize = 11.0;

/// "7: Kitchen, 8.3 m²"; a default name has the number already.
std::string words_of(const DrawnRoom& room, const std::string& number) {
    const std::string words = room.name + ", " + room.area;
    return room.name.ends_with(" " + number) ? words : number + ": " + words;
}

/// Beside the map: the rooms that have only their numbers in it. The page becomes wider, and beside
/// a map that is long and low higher, too.
void add_room_legend(const Layout& layout, FloorPlan& plan) {
    const double size = std::max(kLegendSize * layout.unit, kLeastLegendSize);
    std::vector<LegendLine> lines;
    std::vector<const RoomLabel*> labels;
    for (const RoomLabel& label : plan.labels) {
        if (label.name.text != plan.rooms[label.room - 1].name) labels.push_back(&label);
    }
    std::sort(labels.begin(), labels.end(),
              [](const RoomLabel* p, const RoomLabel* q) { return p->room < q->room; });
    for (const RoomLabel* label : labels) {
        const DrawnRoom& room = plan.rooms[label->room - 1];
        lines.push_back({room.color,
                         io::mixed(room.color, kWallInk, kBorderShare),
                         words_of(room, label->name.text),
                         {},
                         size});
    }
    if (lines.empty()) return;
    const double margin = plan.drawing_origin.x;
    const Point corner{static_cast<double>(plan.page_width), margin};
    const LegendBlock block =
        set_in_columns(lines, corner, plan.page_height - 2.0 * margin, Typeface());
    plan.page_width += static_cast<std::int32_t>(std::ceil(block.width + margin));
    plan.page_height = std::max(plan.page_height,
                                static_cast<std::int32_t>(std::ceil(block.height + 2.0 * margin)));
    std::move(lines.begin(), lines.end(), std::back_inserter(plan.legend));
}

/// Beside the scale bar: what is drawn that has no name.
void add_key(FloorPlan& plan, std::uint32_t num_zones) {
    const Typeface typeface;
    const ScaleBar& bar = plan.scale_bar;
    Point left{bar.text_left().x + typeface.width(bar.text, bar.text_size), bar.origin.y};
    const auto add = [&](io::Rgb ink, io::Rgb border_ink, std::string text) {
        left.x += 2.0 * bar.text_size;
        LegendLine line{ink, border_ink, std::move(text), left, bar.text_size};
        left.x += width_of(line, typeface);
        plan.legend.push_back(std::move(line));
    };
    if (!plan.furniture.empty() || !plan.furniture_insides.empty()) {
        add(kFurnitureInsideInk, kFurnitureInk, "furniture");
    }
    if (!plan.doors.empty()) add(kDoorInk, kPaper, "door");
    for (std::uint32_t zone = 1; zone <= num_zones; ++zone) {
        const io::Rgb ink = io::mixed(kPaper, ink_of_zone(zone), kZoneShare);
        add(ink, io::mixed(ink, kWallInk, kBorderShare), "zone " + std::to_string(zone));
    }
    const double margin = plan.drawing_origin.x;
    plan.page_width =
        std::max(plan.page_width, static_cast<std::int32_t>(std::ceil(left.x + margin)));
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
                             std::span<const io::Rgb> colors, const Executor& executor) {
    const FloorCells cells = sort_floor_cells(map, segmentation.labels, executor);
    FloorPlan plan;
    const Layout layout = set_page(cells.ground, plan);
    plan.frame = cells.ground.box();
    plan.border_width = 1.6 * layout.unit;
    plan.door_width = 5.0 * layout.unit;
    plan.leader_width = 1.4 * layout.unit;
    for (std::size_t i = 0; i < segmentation.rooms.size(); ++i) {
        plan.rooms.push_back(describe_room(segmentation, i, colors[i]));
    }
    draw_cells(cells, executor, plan);

    const CellsFromMap cells_from_map(map);
    const std::map<RoomId, std::size_t> places = io::room_places(segmentation.rooms);
    for (const Door& door : segmentation.doors) {
        plan.doors.push_back({layout.scale.to_page(cells_from_map(door.jamb_1)),
                              layout.scale.to_page(cells_from_map(door.jamb_2)),
                              "Door between " + plan.rooms[places.at(door.a)].name + " and " +
                                  plan.rooms[places.at(door.b)].name + ", " +
                                  io::rounded(door.width_m, 2) + " m"});
    }
    plan.labels = place_labels(cells, words_for(segmentation.rooms, plan, cells_from_map),
                               {layout.scale, layout.unit, static_cast<double>(plan.page_width),
                                static_cast<double>(plan.page_height)},
                               executor);
    plan.scale_bar = set_scale_bar(plan, layout, map.resolution_m);
    add_room_legend(layout, plan);
    // Of more zones than inks each has its number where it is pointed at.
    const std::uint32_t num_zones = segmentation.zones.count;
    add_key(plan, num_zones <= kZoneInks.size() ? num_zones : 0);
    return plan;
}

void FloorPlan::remove_text() {
    labels.clear();
    legend.clear();
    scale_bar.length = 0.0;
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
    plan.leader_width *= factor;
    for (DrawnDoor& door : plan.doors) {
        place(door.from);
        place(door.to);
    }
    for (RoomLabel& label : plan.labels) {
        place_text(label.name);
        if (label.area) place_text(*label.area);
        if (!label.leader) continue;
        place(label.leader->from);
        place(label.leader->to);
    }
    for (LegendLine& line : plan.legend) {
        place(line.left);
        line.size *= factor;
    }
    place(plan.scale_bar.origin);
    plan.scale_bar.length *= factor;
    plan.scale_bar.height *= factor;
    plan.scale_bar.text_size *= factor;
    return plan;
}

}  // namespace quadcut::draw
