// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/svg.hpp"

#include <array>
#include <charconv>
#include <span>
#include <string_view>
#include <vector>

#include "io/authorship.hpp"
#include "io/format_version.hpp"
#include "io/markup.hpp"
#include "io/number_text.hpp"

namespace quadcut::draw {
namespace {

constexpr int kPixelDecimals = 1;

void append_integer(std::string& text, std::int32_t value) {
    std::array<char, 12> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), end.ptr);
}

/// The shortest way to write a closed line: steps from point to point.
void append_ring(std::string& path, const DrawnRing& ring) {
    path += 'M';
    append_integer(path, ring.front().x);
    path += ' ';
    append_integer(path, ring.front().y);
    char command = 'M';
    for (std::size_t i = 1; i < ring.size(); ++i) {
        const std::int32_t dx = ring[i].x - ring[i - 1].x;
        const std::int32_t dy = ring[i].y - ring[i - 1].y;
        const char next = dy == 0 ? 'h' : dx == 0 ? 'v' : 'l';
        // A command that repeats is left out; a minus sign needs no space before it.
        if (next != command) {
            path += next;
        } else if ((next == 'v' ? dy : dx) >= 0) {
            path += ' ';
        }
        command = next;
        if (next != 'v') append_integer(path, dx);
        if (next == 'l' && dy >= 0) path += ' ';
        if (next != 'h') append_integer(path, dy);
    }
    path += 'z';
}

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}

std::string attribute(std::string_view name, double pixels) {
    return attribute(name, io::rounded(pixels, kPixelDecimals));
}

std::string path_of(const std::vector<DrawnRing>& rings) {
    std::string path;
    for (const DrawnRing& ring : rings) append_ring(path, ring);
    return attribute("d", path);
}

void append_layer(std::string& svg, std::string_view id, const std::vector<DrawnRing>& rings,
                  io::Rgb ink) {
    if (rings.empty()) return;
    svg += "<path" + attribute("id", id) + attribute("fill", io::to_hex(ink)) + path_of(rings) +
           "/>\n";
}

void append_rooms(std::string& svg, const FloorPlan& plan) {
    svg +=
        "<g id=\"rooms\"" +
        attribute("stroke-width", io::rounded(plan.border_width / plan.pixels_per_half_cell, 2)) +
        " stroke-linejoin=\"round\">\n";
    for (const DrawnRoom& room : plan.rooms) {
        if (room.rings.empty()) continue;
        svg += "<path" + attribute("id", "room-" + std::to_string(index(room.id))) +
               attribute("fill", io::to_hex(room.color)) +
               attribute("stroke", io::to_hex(io::mixed(room.color, kWallInk, kBorderShare))) +
               path_of(room.rings) + "><title>" + io::escaped(room.name) + "\n" + room.area + ", " +
               room.kind + "</title></path>\n";
    }
    svg += "</g>\n";
}

void append_doors(std::string& svg, const FloorPlan& plan) {
    if (plan.doors.empty()) return;
    const auto line = [](const DrawnDoor& door) {
        return attribute("x1", door.from.x) + attribute("y1", door.from.y) +
               attribute("x2", door.to.x) + attribute("y2", door.to.y);
    };
    svg += "<g id=\"door-casings\" stroke-linecap=\"round\"" +
           attribute("stroke", io::to_hex(kPaper)) +
           attribute("stroke-width", kCasing * plan.door_width) + ">\n";
    for (const DrawnDoor& door : plan.doors) svg += "<line" + line(door) + "/>\n";
    svg += "</g>\n<g id=\"doors\" stroke-linecap=\"round\"" +
           attribute("stroke", io::to_hex(kDoorInk)) + attribute("stroke-width", plan.door_width) +
           ">\n";
    for (std::size_t i = 0; i < plan.doors.size(); ++i) {
        svg += "<line" + attribute("id", "door-" + std::to_string(i + 1)) + line(plan.doors[i]) +
               "><title>" + io::escaped(plan.doors[i].description) + "</title></line>\n";
    }
    svg += "</g>\n";
}

void append_text(std::string& svg, const TextLine& line, TextDirection direction,
                 std::string_view style) {
    svg += "<text" + attribute("x", line.anchor.x) + attribute("y", line.anchor.y) +
           attribute("font-size", line.size) + std::string(style);
    if (direction != TextDirection::along_rows) {
        svg += attribute("transform", "rotate(" + std::to_string(-static_cast<int>(direction)) +
                                          " " + io::rounded(line.anchor.x, kPixelDecimals) + " " +
                                          io::rounded(line.anchor.y, kPixelDecimals) + ")");
    }
    svg += ">" + io::escaped(line.text) + "</text>\n";
}

void append_leaders(std::string& svg, const FloorPlan& plan) {
    std::string leaders;
    for (const RoomLabel& label : plan.labels) {
        if (!label.leader) continue;
        const auto& [from, to] = *label.leader;
        leaders += "<line" + attribute("x1", from.x) + attribute("y1", from.y) +
                   attribute("x2", to.x) + attribute("y2", to.y) + "/>\n<circle" +
                   attribute("cx", from.x) + attribute("cy", from.y) +
                   attribute("r", kLeaderDot * plan.leader_width) + " stroke=\"none\"/>\n";
    }
    if (leaders.empty()) return;
    svg += "<g id=\"leaders\" pointer-events=\"none\"" + attribute("fill", io::to_hex(kTextInk)) +
           attribute("stroke", io::to_hex(kTextInk)) +
           attribute("stroke-width", plan.leader_width) + ">\n" + leaders + "</g>\n";
}

void append_labels(std::string& svg, const FloorPlan& plan) {
    // Pointing at a name points at its room.
    svg +=
        "<g id=\"labels\" text-anchor=\"middle\" pointer-events=\"none\" paint-order=\"stroke\" "
        "stroke-linejoin=\"round\" stroke-opacity=\"" +
        io::rounded(kHaloOpacity) + "\"" + attribute("fill", io::to_hex(kTextInk)) + ">\n";
    for (const RoomLabel& label : plan.labels) {
        const io::Rgb room = label.leader ? kPaper : plan.rooms[label.room - 1].color;
        const auto halo = [&](const TextLine& line) {
            return attribute("stroke", io::to_hex(room)) +
                   attribute("stroke-width", kHalo * line.size);
        };
        append_text(svg, label.name, label.direction, halo(label.name));
        if (!label.area) continue;
        append_text(svg, *label.area, label.direction,
                    halo(*label.area) +
                        attribute("fill", io::to_hex(io::mixed(room, kTextInk, kAreaTextShare))));
    }
    svg += "</g>\n";
}

std::string path_of(std::span<const Point> points) {
    std::string path;
    for (const Point& point : points) {
        path += (path.empty() ? "M" : "L") + io::rounded(point.x, kPixelDecimals) + " " +
                io::rounded(point.y, kPixelDecimals);
    }
    return attribute("d", path + "z");
}

void append_legend(std::string& svg, const std::vector<LegendLine>& legend) {
    if (legend.empty()) return;
    svg += "<g id=\"legend\"" + attribute("fill", io::to_hex(kTextInk)) + ">\n";
    for (const LegendLine& line : legend) {
        svg += "<path" + path_of(line.swatch()) + attribute("fill", io::to_hex(line.ink)) +
               attribute("stroke", io::to_hex(line.border_ink)) +
               attribute("stroke-width", kSwatchBorder * line.size) + "/><text" +
               attribute("x", line.text_left().x) + attribute("y", line.text_left().y) +
               attribute("font-size", line.size) + ">" + io::escaped(line.text) + "</text>\n";
    }
    svg += "</g>\n";
}

void append_scale_bar(std::string& svg, const ScaleBar& bar) {
    svg += "<g id=\"scale-bar\"" + attribute("fill", io::to_hex(kTextInk)) + ">\n<path" +
           path_of(bar.outline()) + "/>\n<text" + attribute("x", bar.text_left().x) +
           attribute("y", bar.text_left().y) + attribute("font-size", bar.text_size) + ">" +
           bar.text + "</text>\n</g>\n";
}

}  // namespace

std::string render_svg(const FloorPlan& plan) {
    const std::string size =
        std::to_string(plan.page_width) + " " + std::to_string(plan.page_height);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\"" +
                      attribute("width", plan.page_width) + attribute("height", plan.page_height) +
                      attribute("data-format-version", std::to_string(io::kFormatVersion)) +
                      " font-family=\"DejaVu Sans, Verdana, Helvetica, Arial, sans-serif\">\n<!-- ";
    svg.append(io::kAuthorComment).append(" -->\n");
    svg += "<rect width=\"100%\" height=\"100%\"" + attribute("fill", io::to_hex(kPaper)) + "/>\n";
    svg += "<g id=\"plan\" fill-rule=\"evenodd\"" +
           attribute("transform", "translate(" + io::rounded(plan.drawing_origin.x) + " " +
                                      io::rounded(plan.drawing_origin.y) + ") scale(" +
                                      io::exact(plan.pixels_per_half_cell) + ")") +
           ">\n";
    append_layer(svg, "free", plan.loose_free, kLooseFreeInk);
    append_rooms(svg, plan);
    append_layer(svg, "thin-unknown", plan.wall_cores, kWallCoreInk);
    append_layer(svg, "furniture-insides", plan.furniture_insides, kFurnitureInsideInk);
    append_layer(svg, "furniture", plan.furniture, kFurnitureInk);
    append_layer(svg, "walls", plan.walls, kWallInk);
    svg += "</g>\n";
    append_doors(svg, plan);
    append_leaders(svg, plan);
    append_labels(svg, plan);
    append_legend(svg, plan.legend);
    append_scale_bar(svg, plan.scale_bar);
    return svg + "</svg>\n";
}

}  // namespace quadcut::draw
