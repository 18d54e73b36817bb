// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "draw/label_placement.hpp"
#include "draw/legend.hpp"
#include "io/palette.hpp"
#include "io/smooth_outline.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::draw {

/// A closed line of the drawing, in half cells from its upper left corner, y DOWN.
using DrawnRing = std::vector<io::HalfCell>;

struct DrawnRoom {
    RoomId id{};
    io::Rgb color;
    std::vector<DrawnRing> rings;
    /// What is said of it where there is space, or on pointing at it.
    std::string name;
    std::string area;
    std::string kind;
};

struct DrawnDoor {
    /// Pixels.
    Point from;
    Point to;
    std::string description;
};

struct ScaleBar {
    /// Pixels: the left end of its lower edge.
    Point origin;
    double length = 0.0;
    double height = 0.0;
    double text_size = 0.0;
    /// What it measures: "5 m".
    std::string text;

    /// A bar with a tick at either end, in one line around.
    [[nodiscard]] std::array<Point, 8> outline() const;
    /// Where the text begins, on its base line.
    [[nodiscard]] Point text_left() const;
};

/// A floor plan, ready to be drawn: where everything is on a page of pixels, and what it looks
/// like. The PNG and the SVG are two ways of putting the same plan down.
struct FloorPlan {
    std::int32_t page_width = 0;
    std::int32_t page_height = 0;
    /// Where the upper left corner of the drawing is on the page, and the size of half a cell.
    Point drawing_origin;
    double pixels_per_half_cell = 1.0;
    /// The cells that are drawn, of the map's.
    Box frame;
    /// Line widths on this page, pixels.
    double border_width = 1.0;
    double door_width = 1.0;
    double leader_width = 1.0;

    std::vector<DrawnRoom> rooms;
    std::vector<DrawnRing> loose_free;
    std::vector<DrawnRing> wall_cores;
    std::vector<DrawnRing> walls;
    std::vector<DrawnRing> furniture;
    std::vector<DrawnRing> furniture_insides;
    std::vector<DrawnDoor> doors;
    std::vector<RoomLabel> labels;
    /// Beside the map, what is said of rooms that have only their number in it; below it, what
    /// stands for furniture and for a door, where there are any.
    std::vector<LegendLine> legend;
    ScaleBar scale_bar;

    /// Leaves the rooms as they are, and nothing to read.
    void remove_text();

    [[nodiscard]] Point to_page(io::HalfCell point) const {
        return {drawing_origin.x + pixels_per_half_cell * point.x,
                drawing_origin.y + pixels_per_half_cell * point.y};
    }
};

// The inks.
inline constexpr io::Rgb kPaper{0xFD, 0xFD, 0xFB};
inline constexpr io::Rgb kLooseFreeInk{0xF1, 0xF1, 0xEE};
inline constexpr io::Rgb kWallInk{0x2D, 0x36, 0x42};
inline constexpr io::Rgb kWallCoreInk{0x7E, 0x87, 0x92};
inline constexpr io::Rgb kFurnitureInk{0x8F, 0x99, 0xA5};
inline constexpr io::Rgb kTextInk{0x2D, 0x36, 0x42};
inline constexpr io::Rgb kDoorInk{0xC4, 0x5E, 0x3D};
inline constexpr io::Rgb kFurnitureInsideInk{0xC6, 0xCB, 0xD0};
/// A room's border: this much of the wall's ink on its colour; likewise the text of its area.
inline constexpr double kBorderShare = 0.35;
inline constexpr double kAreaTextShare = 0.75;
/// What is a zone's in its rooms' colours, which are those of kZoneInks, in turns.
inline constexpr double kZoneShare = 0.5;
/// Of the paper in the colour of what was only glimpsed.
inline constexpr double kPaleShare = 0.65;
inline constexpr std::array<io::Rgb, 10> kZoneInks{{{0x5B, 0x8F, 0xD6},
                                                    {0xF0, 0xA0, 0x4B},
                                                    {0x7D, 0xBF, 0x6A},
                                                    {0xC9, 0x7B, 0xC4},
                                                    {0xE0, 0x6C, 0x6C},
                                                    {0x4F, 0xB8, 0xB0},
                                                    {0xD9, 0xC2, 0x4A},
                                                    {0x9A, 0x86, 0xD6},
                                                    {0xA8, 0x8A, 0x66},
                                                    {0x8F, 0xA3, 0xB5}}};
/// The dot at the end of a line to a number, of the line's width.
inline constexpr double kLeaderDot = 2.0;
/// The white around a door, of the door's width.
inline constexpr double kCasing = 1.8;
/// The room's colour around letters, of their size; it shows where furniture is below them.
inline constexpr double kHalo = 0.22;
inline constexpr double kHaloOpacity = 0.8;

/// Lays out the plan of the rooms (colors[i] is the colour of rooms[i]). The page is an integer
/// number of pixels a cell, the most with which it is at most 2400 pixels long; larger maps one,
/// or so much less that it is at most 8192 long; the legend is beside that. Every room has its name
/// or its number. O(cells).
/// @pre segmentation.labels and map.states cover the same rectangle, which is not empty.
[[nodiscard]] FloorPlan lay_out_floor_plan(const GridMap& map, const Segmentation& segmentation,
                                           std::span<const io::Rgb> colors,
                                           const Executor& executor = {});

/// The plan `factor` times as large, and then moved by `shift` pixels: for pages that hold several.
/// Its page becomes what it needs from its own upper left corner.
[[nodiscard]] FloorPlan placed(FloorPlan plan, double factor, const Point& shift);

}  // namespace quadcut::draw
