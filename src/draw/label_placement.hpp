// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "draw/typeface.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut::draw {

/// How far text is turned from the rows of the page, degrees counterclockwise: what is turned
/// upwards is to be read from the right.
enum class TextDirection : std::int32_t { along_rows = 0, upwards = 90 };

/// Where text leads to, and where it leads on below a line of text; on the page, y down.
struct TextAxes {
    explicit TextAxes(TextDirection direction);
    Point along;
    Point down;
};

/// One line of text on the page. Pixels, y down.
struct TextLine {
    std::string text;
    double size = 0.0;
    /// The middle of its base line.
    Point anchor;
};

/// A thin line on the page from a place in a room to the number beside it.
struct Leader {
    Point from;
    Point to;
};

/// The text in a room: its name, and its area below if there is space for it; or its number, where
/// there is none for the name, or beside it.
struct RoomLabel {
    /// As the ground has it: 1 + the room's place.
    std::uint32_t room = 0;
    TextDirection direction = TextDirection::along_rows;
    TextLine name;
    std::optional<TextLine> area;
    std::optional<Leader> leader;
};

/// How cells become pixels: cell corner (x, y) is at (left + x * scale, bottom - y * scale).
struct PageScale {
    double left = 0.0;
    double bottom = 0.0;
    double pixels_per_cell = 1.0;

    [[nodiscard]] Point to_page(const Point& cells) const {
        return {left + cells.x * pixels_per_cell, bottom - cells.y * pixels_per_cell};
    }
};

struct LabelText {
    std::uint32_t room = 0;
    std::string name;
    std::string area;
    /// In cells: a point well inside of the room, and the middle of its area.
    Point label_point;
    Point centroid;
};

/// The largest of a few sizes at which the text lies within the cells of its room; upwards, or
/// along a slanted room, only where that allows clearly larger letters. Centred on the centroid,
/// where it looks best, unless the label point allows larger letters. Nothing if not even the
/// smallest fits. `unit` scales the sizes: 1 means 11.5 to 30 pixels. O(cells under the text).
[[nodiscard]] std::optional<RoomLabel> place_label(const LabelText& text,
                                                   const Raster<std::uint16_t>& ground,
                                                   const PageScale& scale, double unit,
                                                   const Typeface& typeface);

}  // namespace quadcut::draw
