// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/pair_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "bench/gallery/hatch.hpp"
#include "draw/label_placement.hpp"
#include "draw/render.hpp"
#include "io/room_colors.hpp"
#include "quadcut/map/clearance.hpp"

namespace quadcut::gallery {
namespace {

constexpr io::Rgb kErrorInk{0xC8, 0x10, 0x3C};
constexpr io::Rgb kErrorPaper{0xFF, 0xF6, 0xF5};

using Polygons = std::vector<std::vector<Point>>;

Polygons on_page(const draw::FloorPlan& plan, const draw::DrawnRoom& room) {
    Polygons polygons;
    for (const draw::DrawnRing& ring : room.rings) {
        std::vector<Point>& points = polygons.emplace_back();
        for (const io::HalfCell point : ring) points.push_back(plan.to_page(point));
    }
    return polygons;
}

/// The colours of both sides: of each match one, clear of what is next to it on either side.
struct PairColors {
    std::vector<io::Rgb> truth;
    std::vector<io::Rgb> result;
};

PairColors choose_colors(const Exhibit& exhibit) {
    const std::vector<eval::RoomMatch>& found = exhibit.comparison.found;
    PairColors colors{{exhibit.comparison.truth.size(), kErrorPaper},
                      {exhibit.comparison.predicted.size(), kErrorPaper}};
    std::vector<std::uint16_t> match_of_true(colors.truth.size() + 1);
    std::vector<std::uint16_t> match_of_predicted(colors.result.size() + 1);
    std::vector<RoomKind> kinds;
    for (const eval::RoomMatch& match : found) {
        kinds.push_back(exhibit.result.rooms.rooms[match.predicted - 1].kind);
        match_of_true[match.truth] = static_cast<std::uint16_t>(kinds.size());
        match_of_predicted[match.predicted] = static_cast<std::uint16_t>(kinds.size());
    }
    std::vector<io::RoomPair> pairs;
    const auto add_pairs = [&pairs](const Side& side, const std::vector<std::uint16_t>& match_of) {
        for (const io::RoomPair& pair : io::find_near_rooms(side.map, side.rooms)) {
            const auto [a, b] = std::minmax(match_of[pair.a], match_of[pair.b]);
            if (a > 0 && a != b) pairs.push_back({a, b, pair.closeness});
        }
    };
    add_pairs(exhibit.truth, match_of_true);
    add_pairs(exhibit.result, match_of_predicted);
    std::sort(pairs.begin(), pairs.end(), [](const io::RoomPair& x, const io::RoomPair& y) {
        return std::pair(x.a, x.b) < std::pair(y.a, y.b);
    });
    const auto same = [](const io::RoomPair& x, const io::RoomPair& y) {
        return x.a == y.a && x.b == y.b;
    };
    pairs.erase(std::unique(pairs.begin(), pairs.end(), same), pairs.end());
    const std::vector<io::Rgb> chosen = io::choose_room_colors(kinds, pairs);
    for (std::size_t i = 0; i < found.size(); ++i) {
        colors.truth[found[i].truth - 1] = chosen[i];
        colors.result[found[i].predicted - 1] = chosen[i];
    }
    return colors;
}

/// Where a word may stand: the middle of each region's area, and its innermost cell.
std::vector<draw::LabelText> place_words(const Side& side, const std::vector<std::string>& words) {
    const Raster<std::uint16_t>& labels = side.rooms.labels;
    std::vector<draw::LabelText> texts;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].empty()) continue;
        const auto room = static_cast<std::uint16_t>(i + 1);
        Raster<std::uint8_t> open(labels.origin, labels.width, labels.height);
        std::transform(labels.values.begin(), labels.values.end(), open.values.begin(),
                       [room](std::uint16_t label) { return label == room ? 1 : 0; });
        const Raster<float> depth = clearance_m(open, 1.0);
        const auto deepest = std::max_element(depth.values.begin(), depth.values.end());
        const Cell inner = labels.cell(static_cast<std::size_t>(deepest - depth.values.begin()));
        Point middle{0.0, 0.0};
        double num_cells = 0.0;
        for (std::size_t place = 0; place < open.values.size(); ++place) {
            if (open.values[place] == 0) continue;
            const Cell cell = labels.cell(place);
            middle = {middle.x + cell.x + 0.5, middle.y + cell.y + 0.5};
            num_cells += 1.0;
        }
        middle = {middle.x / num_cells, middle.y / num_cells};
        texts.push_back({room, words[i], "", {inner.x + 0.5, inner.y + 0.5}, middle});
    }
    return texts;
}

std::vector<std::string> words_for(const std::vector<Fate>& fates, std::string_view (*word)(Fate)) {
    std::vector<std::string> words;
    for (const Fate fate : fates) words.emplace_back(word(fate));
    return words;
}

}  // namespace

void draw_caption(draw::Canvas& canvas, const std::string& text, const Point& left, double size,
                  io::Rgb ink, const draw::Typeface& typeface) {
    const Point middle{left.x + typeface.width(text, size) / 2.0, left.y};
    draw::draw_text(canvas, {text, size, middle}, draw::TextDirection::along_rows, ink,
                    draw::kPaper, typeface);
}

PairPicture::PairPicture(const Exhibit& exhibit) {
    const PairColors colors = choose_colors(exhibit);
    truth_ =
        make_pane(exhibit.truth, colors.truth, words_for(exhibit.comparison.truth, word_for_true));
    result_ = make_pane(exhibit.result, colors.result,
                        words_for(exhibit.comparison.predicted, word_for_predicted));
    frame_ = truth_.plan.frame;
    frame_.include(result_.plan.frame);
}

PairPicture::Pane PairPicture::make_pane(const Side& side, const std::vector<io::Rgb>& colors,
                                         const std::vector<std::string>& words) {
    Pane pane{draw::lay_out_floor_plan(side.map, side.rooms, colors), place_words(side, words), {}};
    pane.plan.remove_text();
    const Raster<std::uint16_t>& labels = side.rooms.labels;
    pane.ground = Raster<std::uint16_t>(labels.origin, labels.width, labels.height);
    std::copy(labels.values.begin(), labels.values.end(), pane.ground.values.begin());
    return pane;
}

double PairPicture::pixels_per_cell(double width, double height) const {
    return std::min((width - kGap) / 2.0 / frame_.width(), height / frame_.height());
}

double PairPicture::pane_width(double pixels_per_cell) const {
    return frame_.width() * pixels_per_cell;
}

double PairPicture::pane_height(double pixels_per_cell) const {
    return frame_.height() * pixels_per_cell;
}

draw::FloorPlan plan_in_frame(const draw::FloorPlan& plan, const Box& frame, const Point& origin,
                              double pixels_per_cell) {
    const double factor = pixels_per_cell / (2.0 * plan.pixels_per_half_cell);
    const Point corner{origin.x + (plan.frame.low.x - frame.low.x) * pixels_per_cell,
                       origin.y + (frame.high.y - plan.frame.high.y) * pixels_per_cell};
    draw::FloorPlan placed = draw::placed(
        plan, factor,
        {corner.x - factor * plan.drawing_origin.x, corner.y - factor * plan.drawing_origin.y});
    placed.border_width = 0.8;
    placed.door_width = 2.2;
    return placed;
}

void PairPicture::draw(draw::Canvas& canvas, const Point& origin, double pixels_per_cell,
                       const draw::Typeface& typeface) const {
    draw_truth(canvas, origin, pixels_per_cell, typeface);
    const Point right{origin.x + pane_width(pixels_per_cell) + kGap, origin.y};
    draw_result(canvas, right, pixels_per_cell, typeface);
}

void PairPicture::draw_truth(draw::Canvas& canvas, const Point& origin, double pixels_per_cell,
                             const draw::Typeface& typeface) const {
    const draw::FloorPlan plan = plan_in_frame(truth_.plan, frame_, origin, pixels_per_cell);
    draw::draw_plan(canvas, plan, typeface);
    draw_errors(canvas, truth_, plan, origin, pixels_per_cell, typeface);
}

void PairPicture::draw_result(draw::Canvas& canvas, const Point& origin, double pixels_per_cell,
                              const draw::Typeface& typeface) const {
    const draw::FloorPlan plan = plan_in_frame(result_.plan, frame_, origin, pixels_per_cell);
    draw::draw_plan(canvas, plan, typeface);

    constexpr double kTruthLine = 1.3;
    draw::Shape borders;
    const draw::FloorPlan truth = plan_in_frame(truth_.plan, frame_, origin, pixels_per_cell);
    for (const draw::DrawnRoom& room : truth.rooms) {
        for (const std::vector<Point>& polygon : on_page(truth, room)) {
            borders.add_closed_line(polygon, kTruthLine);
        }
    }
    canvas.fill(std::move(borders), draw::kWallInk);
    draw_errors(canvas, result_, plan, origin, pixels_per_cell, typeface);
}

void PairPicture::draw_errors(draw::Canvas& canvas, const Pane& pane, const draw::FloorPlan& plan,
                              const Point& origin, double pixels_per_cell,
                              const draw::Typeface& typeface) const {
    constexpr double kHatchSpacing = 9.0;
    constexpr double kHatchLine = 1.0;
    constexpr double kOutline = 2.4;
    const draw::PageScale scale{origin.x - frame_.low.x * pixels_per_cell,
                                origin.y + (frame_.high.y + 1) * pixels_per_cell, pixels_per_cell};
    for (const draw::LabelText& error : pane.errors) {
        const Polygons polygons = on_page(plan, plan.rooms[error.room - 1]);
        draw::Shape outline;
        for (const std::vector<Point>& polygon : polygons) {
            outline.add_closed_line(polygon, kOutline);
        }
        canvas.fill(hatch(polygons, kHatchSpacing, kHatchLine), kErrorInk, 0.7);
        canvas.fill(std::move(outline), kErrorInk);
    }
    for (const draw::LabelText& error : pane.errors) {
        const auto label = draw::place_label(error, pane.ground, scale, 1.0, typeface);
        if (!label) continue;
        draw::draw_text(canvas, label->name, label->direction, kErrorInk, draw::kPaper, typeface);
    }
}

}  // namespace quadcut::gallery
