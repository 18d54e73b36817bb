// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/filmstrip.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "draw/canvas.hpp"
#include "draw/floor_plan.hpp"
#include "draw/render.hpp"
#include "draw/typeface.hpp"
#include "io/palette.hpp"
#include "io/room_colors.hpp"

namespace quadcut::draw {
namespace {

constexpr double kPageWidth = 2400.0;
constexpr double kGap = 24.0;
constexpr double kCaption = 44.0;
constexpr double kCaptionSize = 26.0;
constexpr io::Rgb kWayInk{0x2B, 0x6C, 0xB0};

/// The rectangle of the map frame that all moments lie in, metres.
struct Frame {
    Point low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    Point high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

    void include(const Point& point) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
};

Frame frame_of(std::span<const Moment> moments) {
    Frame frame;
    for (const Moment& moment : moments) {
        const Pose& corner = moment.map.map_from_image;
        frame.include({corner.x, corner.y});
        frame.include({corner.x + moment.map.states.width * moment.map.resolution_m,
                       corner.y + moment.map.states.height * moment.map.resolution_m});
    }
    return frame;
}

/// One picture of the strip: where it is on the page, and how large.
struct Panel {
    /// Its upper left corner.
    Point corner;
    double pixels_per_m = 1.0;
    Frame frame;

    [[nodiscard]] Point to_page(const Point& at) const {
        return {corner.x + (at.x - frame.low.x) * pixels_per_m,
                corner.y + (frame.high.y - at.y) * pixels_per_m};
    }
};

void draw_moment(Canvas& canvas, const Moment& moment, const Panel& panel,
                 const std::vector<io::Rgb>& colors, const Typeface& typeface) {
    if (!moment.map.states.values.empty()) {
        FloorPlan plan = lay_out_floor_plan(moment.map, moment.rooms, colors);
        plan.remove_text();
        const double factor =
            panel.pixels_per_m * moment.map.resolution_m / (2.0 * plan.pixels_per_half_cell);
        const Pose& corner = moment.map.map_from_image;
        const Point upper_left{corner.x + plan.frame.low.x * moment.map.resolution_m,
                               corner.y + (plan.frame.high.y + 1) * moment.map.resolution_m};
        const Point at = panel.to_page(upper_left);
        const Point shift{at.x - factor * plan.drawing_origin.x,
                          at.y - factor * plan.drawing_origin.y};
        draw_plan(canvas, placed(plan, factor, shift), typeface);
    }
    std::vector<Point> way;
    for (const Point& point : moment.way) way.push_back(panel.to_page(point));
    if (way.empty()) return;
    Shape line;
    line.add_line(way, 1.5);
    canvas.fill(std::move(line), kWayInk, 0.6);
    Shape robot;
    robot.add_disc(way.back(), 6.0);
    canvas.fill(std::move(robot), kWayInk);
}

}  // namespace

std::string render_filmstrip(std::span<const Moment> moments, std::size_t per_row) {
    const Typeface typeface;
    const Frame frame = frame_of(moments);
    const auto num_columns = static_cast<double>(per_row);
    const double width = (kPageWidth - (num_columns + 1.0) * kGap) / num_columns;
    // A tall map is drawn smaller, so that the page stays a page.
    const double pixels_per_m = std::min(width / std::max(frame.high.x - frame.low.x, 0.1),
                                         1.5 * width / std::max(frame.high.y - frame.low.y, 0.1));
    const double height = (frame.high.y - frame.low.y) * pixels_per_m;
    const std::size_t num_rows = (moments.size() + per_row - 1) / per_row;
    Canvas canvas(static_cast<std::int32_t>(kPageWidth),
                  static_cast<std::int32_t>(
                      std::ceil(static_cast<double>(num_rows) * (height + kCaption + kGap) + kGap)),
                  kPaper);
    std::map<RoomId, io::Rgb> colors_of_rooms;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const Moment& moment = moments[i];
        const std::size_t row = i / per_row;
        const Point corner{kGap + static_cast<double>(i % per_row) * (width + kGap),
                           kGap + static_cast<double>(row) * (height + kCaption + kGap)};
        const std::vector<io::Rgb> colors = io::room_colors(
            moment.rooms, io::find_near_rooms(moment.map, moment.rooms), colors_of_rooms);
        for (std::size_t room = 0; room < colors.size(); ++room) {
            colors_of_rooms[moment.rooms.rooms[room].id] = colors[room];
        }
        const TextLine caption{
            moment.caption, kCaptionSize, {corner.x + width / 2.0, corner.y + kCaptionSize}};
        draw_text(canvas, caption, TextDirection::along_rows, kTextInk, kPaper, typeface);
        draw_moment(canvas, moment, {{corner.x, corner.y + kCaption}, pixels_per_m, frame}, colors,
                    typeface);
    }
    return canvas.encode_png();
}

}  // namespace quadcut::draw
