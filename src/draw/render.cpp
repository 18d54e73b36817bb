// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/render.hpp"

#include <array>
#include <utility>
#include <vector>

#include "draw/canvas.hpp"
#include "draw/typeface.hpp"

namespace quadcut::draw {
namespace {

std::vector<Point> to_page(const FloorPlan& plan, const DrawnRing& ring) {
    std::vector<Point> points;
    points.reserve(ring.size());
    for (const io::HalfCell point : ring) points.push_back(plan.to_page(point));
    return points;
}

void fill_rings(Canvas& canvas, const FloorPlan& plan, const std::vector<DrawnRing>& rings,
                io::Rgb ink) {
    Shape shape;
    for (const DrawnRing& ring : rings) shape.add_polygon(to_page(plan, ring));
    canvas.fill(std::move(shape), ink);
}

void draw_room(Canvas& canvas, const FloorPlan& plan, const DrawnRoom& room) {
    fill_rings(canvas, plan, room.rings, room.color);
    Shape border;
    for (const DrawnRing& ring : room.rings) {
        border.add_closed_line(to_page(plan, ring), plan.border_width);
    }
    canvas.fill(std::move(border), io::mixed(room.color, kWallInk, kBorderShare));
}

void draw_doors(Canvas& canvas, const FloorPlan& plan) {
    Shape casing;
    Shape doors;
    for (const DrawnDoor& door : plan.doors) {
        const std::array<Point, 2> line = {door.from, door.to};
        casing.add_line(line, plan.door_width * kCasing);
        doors.add_line(line, plan.door_width);
    }
    canvas.fill(std::move(casing), kPaper);
    canvas.fill(std::move(doors), kDoorInk);
}

/// The letters of a line of text whose middle is at its anchor.
std::vector<std::vector<Point>> set_text(const TextLine& line, TextDirection direction,
                                         const Typeface& typeface) {
    const double half = typeface.width(line.text, line.size) / 2.0;
    std::vector<std::vector<Point>> outlines = typeface.outlines(line.text, line.size);
    const TextAxes axes(direction);
    for (std::vector<Point>& outline : outlines) {
        for (Point& point : outline) {
            const double along = point.x - half;
            point = {line.anchor.x + along * axes.along.x + point.y * axes.down.x,
                     line.anchor.y + along * axes.along.y + point.y * axes.down.y};
        }
    }
    return outlines;
}

void draw_labels(Canvas& canvas, const FloorPlan& plan, const Typeface& typeface) {
    Shape leaders;
    for (const RoomLabel& label : plan.labels) {
        if (!label.leader) continue;
        const std::array<Point, 2> line = {label.leader->from, label.leader->to};
        leaders.add_line(line, plan.leader_width);
        leaders.add_disc(label.leader->from, kLeaderDot * plan.leader_width);
    }
    canvas.fill(std::move(leaders), kTextInk);
    for (const RoomLabel& label : plan.labels) {
        const io::Rgb room = label.leader ? kPaper : plan.rooms[label.room - 1].color;
        draw_text(canvas, label.name, label.direction, kTextInk, room, typeface);
        if (label.area) {
            draw_text(canvas, *label.area, label.direction,
                      io::mixed(room, kTextInk, kAreaTextShare), room, typeface);
        }
    }
}

/// The text of a line that begins at a point.
void draw_text_from(Canvas& canvas, const std::string& text, double size, const Point& left,
                    const Typeface& typeface) {
    const double half = typeface.width(text, size) / 2.0;
    draw_text(canvas, {text, size, {left.x + half, left.y}}, TextDirection::along_rows, kTextInk,
              kPaper, typeface);
}

void draw_scale_bar(Canvas& canvas, const ScaleBar& bar, const Typeface& typeface) {
    Shape shape;
    shape.add_polygon(bar.outline());
    canvas.fill(std::move(shape), kTextInk);
    draw_text_from(canvas, bar.text, bar.text_size, bar.text_left(), typeface);
}

void draw_legend(Canvas& canvas, const std::vector<LegendLine>& legend, const Typeface& typeface) {
    for (const LegendLine& line : legend) {
        Shape fill;
        Shape border;
        fill.add_polygon(line.swatch());
        border.add_closed_line(line.swatch(), kSwatchBorder * line.size);
        canvas.fill(std::move(fill), line.ink);
        canvas.fill(std::move(border), line.border_ink);
        draw_text_from(canvas, line.text, line.size, line.text_left(), typeface);
    }
}

}  // namespace

void draw_text(Canvas& canvas, const TextLine& line, TextDirection direction, io::Rgb ink,
               io::Rgb halo, const Typeface& typeface) {
    Shape around;
    Shape letters;
    for (const std::vector<Point>& outline : set_text(line, direction, typeface)) {
        around.add_closed_line(outline, kHalo * line.size);
        letters.add_polygon(outline);
    }
    canvas.fill(std::move(around), halo, kHaloOpacity);
    canvas.fill(std::move(letters), ink);
}

void draw_plan(Canvas& canvas, const FloorPlan& plan, const Typeface& typeface) {
    fill_rings(canvas, plan, plan.loose_free, kLooseFreeInk);
    for (const DrawnRoom& room : plan.rooms) draw_room(canvas, plan, room);
    fill_rings(canvas, plan, plan.wall_cores, kWallCoreInk);
    fill_rings(canvas, plan, plan.furniture_insides, kFurnitureInsideInk);
    fill_rings(canvas, plan, plan.furniture, kFurnitureInk);
    fill_rings(canvas, plan, plan.walls, kWallInk);
    draw_doors(canvas, plan);
    draw_labels(canvas, plan, typeface);
    draw_legend(canvas, plan.legend, typeface);
    if (plan.scale_bar.length > 0.0) draw_scale_bar(canvas, plan.scale_bar, typeface);
}

std::string render_png(const FloorPlan& plan, const Executor& executor) {
    Canvas canvas(plan.page_width, plan.page_height, kPaper);
    draw_plan(canvas, plan, Typeface());
    return canvas.encode_png(executor);
}

}  // namespace quadcut::draw
