// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/label_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace quadcut::draw {
namespace {

// Few sizes, so that a page looks set rather than stretched.
constexpr std::array<double, 8> kSizes = {30.0, 26.0, 22.0, 19.0, 16.5, 14.5, 13.0, 11.5};
constexpr double kAreaSize = 0.78;    // Of the name's.
constexpr double kLineGap = 0.55;     // Between name and area, of the name's size.
constexpr double kPadding = 0.35;     // Around the text, of the name's size.
constexpr double kEasyPadding = 1.0;  // The same where there is no need to be narrow.
/// How many sizes smaller the name may become to make space for the area.
constexpr std::size_t kStepsForArea = 2;
/// How many sizes larger the text must become to be turned.
constexpr std::size_t kStepsForTurn = 3;
/// Text that would be of the smallest sizes, from this on, is turned by a multiple of some degrees
/// where a room is slanted.
constexpr std::size_t kSmallSize = 5;
constexpr int kDegreesPerTurn = 15;

/// A block of text, its lines one below the other.
struct Block {
    double width = 0.0;
    double height = 0.0;
    double name_cap = 0.0;
};

/// How long the lines of a text are, in the font's own units.
struct TextLengths {
    int name = 0;
    int area = 0;
};

Block measure(const TextLengths& lengths, double size, bool with_area, const Typeface& typeface) {
    Block block;
    block.name_cap = typeface.cap_height(size);
    block.width = typeface.width(lengths.name, size);
    block.height = block.name_cap;
    if (with_area) {
        block.width = std::max(block.width, typeface.width(lengths.area, size * kAreaSize));
        block.height += size * kLineGap + typeface.cap_height(size * kAreaSize);
    }
    return block;
}

bool is_all_room(const Raster<std::uint16_t>& ground, std::uint32_t room, const Point& center,
                 double width, double height) {
    constexpr double kFarAway = 1e9;
    const bool near = std::abs(center.x) < kFarAway && std::abs(center.y) < kFarAway &&
                      width < kFarAway && height < kFarAway;
    if (!near) return false;
    const auto low_x = static_cast<std::int32_t>(std::floor(center.x - width / 2.0));
    const auto low_y = static_cast<std::int32_t>(std::floor(center.y - height / 2.0));
    const auto high_x = static_cast<std::int32_t>(std::ceil(center.x + width / 2.0)) - 1;
    const auto high_y = static_cast<std::int32_t>(std::ceil(center.y + height / 2.0)) - 1;
    if (!ground.contains({low_x, low_y}) || !ground.contains({high_x, high_y})) return false;
    for (std::int32_t y = low_y; y <= high_y; ++y) {
        const auto first =
            ground.values.begin() + static_cast<std::ptrdiff_t>(ground.offset({low_x, y}));
        if (!std::all_of(first, first + (high_x - low_x + 1),
                         [room](std::uint16_t cell) { return cell == room; })) {
            return false;
        }
    }
    return true;
}

/// The same for a rectangle that is turned.
bool is_all_room(const Raster<std::uint16_t>& ground, std::uint32_t room, const Point& center,
                 double width, double height, const TextAxes& axes) {
    const auto reach = [&](double along, double down) {
        return (std::abs(along) * width + std::abs(down) * height) / 2.0;
    };
    const double reach_x = reach(axes.along.x, axes.down.x);
    const double reach_y = reach(axes.along.y, axes.down.y);
    const Cell low{static_cast<std::int32_t>(std::floor(center.x - reach_x)),
                   static_cast<std::int32_t>(std::floor(center.y - reach_y))};
    const Cell high{static_cast<std::int32_t>(std::floor(center.x + reach_x)),
                    static_cast<std::int32_t>(std::floor(center.y + reach_y))};
    if (!ground.contains(low) || !ground.contains(high)) return false;
    // Most that do not fit end outside of the room.
    for (const double along : {-0.5 * width, 0.5 * width}) {
        for (const double down : {-0.5 * height, 0.5 * height}) {
            const Cell corner{static_cast<std::int32_t>(
                                  std::floor(center.x + along * axes.along.x + down * axes.down.x)),
                              static_cast<std::int32_t>(std::floor(center.y - along * axes.along.y -
                                                                   down * axes.down.y))};
            if (ground.at(corner) != room) return false;
        }
    }
    constexpr double kHalfCell = 0.5;
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            // Cells lie with y up.
            const double dx = x + kHalfCell - center.x;
            const double dy = center.y - (y + kHalfCell);
            const bool is_under =
                std::abs(dx * axes.along.x + dy * axes.along.y) <= width / 2.0 + kHalfCell &&
                std::abs(dx * axes.down.x + dy * axes.down.y) <= height / 2.0 + kHalfCell;
            if (is_under && ground.at({x, y}) != room) return false;
        }
    }
    return true;
}

/// Which of kSizes fits first; kSizes.size() if none.
struct Fit {
    std::size_t size = kSizes.size();
    Point center;
    bool with_area = false;
};

class Fitter {
public:
    Fitter(const LabelText& text, const Raster<std::uint16_t>& ground, const PageScale& scale,
           double unit, const Typeface& typeface)
        : text_(text),
          lengths_{typeface.length_units(text.name), typeface.length_units(text.area)},
          ground_(ground),
          scale_(scale),
          unit_(unit),
          typeface_(typeface) {}

    [[nodiscard]] Fit find(TextDirection direction) const {
        // Where letters have space to breathe, rather than where they just fit.
        const std::size_t middle = first_size(text_.centroid, direction, false, kEasyPadding);
        const std::size_t inner = first_size(text_.label_point, direction, false, kEasyPadding);
        const Fit at_middle = find_at(text_.centroid, direction);
        const Fit at_inner = find_at(text_.label_point, direction);
        if (middle == inner) return at_inner.size < at_middle.size ? at_inner : at_middle;
        return inner < middle ? at_inner : at_middle;
    }

    [[nodiscard]] RoomLabel label(const Fit& fit, TextDirection direction) const {
        const double size = kSizes.at(fit.size) * unit_;
        const Block block = measure(lengths_, size, fit.with_area, typeface_);
        const Point center = scale_.to_page(fit.center);
        // `down`: from the middle of the block to a base line, across the lines of text.
        const TextAxes axes(direction);
        const auto anchor = [&](double down) {
            return Point{center.x + down * axes.down.x, center.y + down * axes.down.y};
        };
        RoomLabel label;
        label.room = text_.room;
        label.direction = direction;
        label.name = {text_.name, size, anchor(block.name_cap - block.height / 2.0)};
        if (fit.with_area) {
            label.area = TextLine{text_.area, size * kAreaSize, anchor(block.height / 2.0)};
        }
        return label;
    }

private:
    [[nodiscard]] Fit find_at(const Point& center, TextDirection direction) const {
        const std::size_t alone = first_size(center, direction, false, kPadding);
        if (alone == kSizes.size() || text_.area.empty()) return {alone, center, false};
        const std::size_t with_area = first_size(center, direction, true, kPadding);
        const bool worth_it = with_area < kSizes.size() && with_area <= alone + kStepsForArea;
        return worth_it ? Fit{with_area, center, true} : Fit{alone, center, false};
    }

    [[nodiscard]] std::size_t first_size(const Point& center, TextDirection direction,
                                         bool with_area, double padding) const {
        std::size_t i = 0;
        while (i < kSizes.size() &&
               !fits(center, kSizes.at(i) * unit_, direction, with_area, padding)) {
            ++i;
        }
        return i;
    }

    [[nodiscard]] bool fits(const Point& center, double size, TextDirection direction,
                            bool with_area, double padding) const {
        const Block block = measure(lengths_, size, with_area, typeface_);
        double width = (block.width + 2.0 * padding * size) / scale_.pixels_per_cell;
        double height = (block.height + 2.0 * padding * size) / scale_.pixels_per_cell;
        if (direction != TextDirection::along_rows && direction != TextDirection::upwards) {
            return is_all_room(ground_, text_.room, center, width, height, TextAxes(direction));
        }
        if (direction == TextDirection::upwards) std::swap(width, height);
        return is_all_room(ground_, text_.room, center, width, height);
    }

    const LabelText& text_;
    TextLengths lengths_;
    const Raster<std::uint16_t>& ground_;
    const PageScale& scale_;
    double unit_;
    const Typeface& typeface_;
};

}  // namespace

TextAxes::TextAxes(TextDirection direction) {
    // Right angles are exact.
    if (direction == TextDirection::along_rows) {
        along = {1.0, 0.0};
        down = {0.0, 1.0};
    } else if (direction == TextDirection::upwards) {
        along = {0.0, -1.0};
        down = {1.0, 0.0};
    } else {
        const double angle = static_cast<double>(direction) * std::numbers::pi / 180.0;
        along = {std::cos(angle), -std::sin(angle)};
        down = {std::sin(angle), std::cos(angle)};
    }
}

std::optional<RoomLabel> place_label(const LabelText& text, const Raster<std::uint16_t>& ground,
                                     const PageScale& scale, double unit,
                                     const Typeface& typeface) {
    const Fitter fitter(text, ground, scale, unit, typeface);
    Fit best = fitter.find(TextDirection::along_rows);
    TextDirection direction = TextDirection::along_rows;
    const auto try_to_turn = [&](int degrees) {
        const auto turned = static_cast<TextDirection>(degrees);
        const Fit fit = fitter.find(turned);
        // What is turned already may become larger by any step.
        const std::size_t steps = direction == TextDirection::along_rows ? kStepsForTurn : 1;
        if (fit.size + steps > best.size) return;
        best = fit;
        direction = turned;
    };
    try_to_turn(static_cast<int>(TextDirection::upwards));
    if (direction == TextDirection::along_rows && best.size >= kSmallSize) {
        for (int degrees = kDegreesPerTurn; degrees < 90; degrees += kDegreesPerTurn) {
            try_to_turn(degrees);
            try_to_turn(-degrees);
        }
    }
    if (best.size == kSizes.size()) return std::nullopt;
    return fitter.label(best, direction);
}

}  // namespace quadcut::draw
