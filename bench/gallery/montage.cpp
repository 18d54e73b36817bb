// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/montage.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "bench/gallery/entry_picture.hpp"
#include "draw/render.hpp"
#include "io/number_text.hpp"
#include "io/outline.hpp"
#include "reproduce/plan_within.hpp"

namespace quadcut::gallery {
namespace {

constexpr double kPageWidth = 1600.0;
constexpr double kMargin = 24.0;
constexpr double kColumnGap = 64.0;
constexpr double kRowGap = 40.0;
constexpr double kHeader = 58.0;
constexpr std::size_t kColumns = 2;

void fill_cells(draw::Canvas& canvas, const GridMap& map, const draw::FloorPlan& plan,
                CellState state, io::Rgb ink) {
    Raster<std::uint8_t> cells(map.states.origin, map.states.width, map.states.height);
    std::transform(map.states.values.begin(), map.states.values.end(), cells.values.begin(),
                   [state](CellState cell) { return std::uint8_t{cell == state}; });
    draw::Shape shape;
    for (const io::RegionOutline& region : io::trace_outlines(cells)) {
        for (const io::OutlineRing& ring : region.rings) {
            std::vector<Point> points;
            for (const Cell corner : io::corners_of(ring)) {
                points.push_back(plan.to_page(
                    {2 * (corner.x - plan.frame.low.x), 2 * (plan.frame.high.y + 1 - corner.y)}));
            }
            shape.add_polygon(points);
        }
    }
    canvas.fill(std::move(shape), ink);
}

}  // namespace

void Montage::add(const Exhibit& exhibit, const std::string& note) {
    const double pq_percent = 100.0 * exhibit.comparison.score.pq;
    items_.push_back({PairPicture(exhibit),
                      std::to_string(exhibit.comparison.truth.size()) + " rooms, " + note,
                      "PQ " + io::rounded(pq_percent, 1)});
}

void Montage::write(const std::filesystem::path& path) const {
    struct Place {
        Point origin;
        double scale = 1.0;
    };
    std::vector<Place> places;
    double y = kMargin;
    for (std::size_t i = 0; i < items_.size(); i += kColumns) {
        const std::size_t end = std::min(i + kColumns, items_.size());
        // All of a row are equally high, and fill it.
        double width_per_height = 0.0;
        double width = kPageWidth - 2.0 * kMargin + kColumnGap;
        for (std::size_t j = i; j < end; ++j) {
            const PairPicture& picture = items_[j].picture;
            width_per_height += 2.0 * picture.pane_width(1.0) / picture.pane_height(1.0);
            width -= PairPicture::kGap + kColumnGap;
        }
        const double height = width / width_per_height;
        double x = kMargin;
        for (std::size_t j = i; j < end; ++j) {
            const PairPicture& picture = items_[j].picture;
            const double scale = height / picture.pane_height(1.0);
            places.push_back({{x, y}, scale});
            x += 2.0 * picture.pane_width(scale) + PairPicture::kGap + kColumnGap;
        }
        y += kHeader + height + kRowGap;
    }
    draw::Canvas canvas(static_cast<std::int32_t>(kPageWidth),
                        static_cast<std::int32_t>(std::ceil(y - kRowGap + kMargin)), draw::kPaper);
    const draw::Typeface typeface;
    const io::Rgb soft = io::mixed(draw::kPaper, draw::kTextInk, 0.7);
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const Point& at = places[i].origin;
        draw_caption(canvas, items_[i].title, {at.x, at.y + 18.0}, 20.0, draw::kTextInk, typeface);
        draw_caption(canvas, items_[i].figure, {at.x, at.y + 42.0}, 17.0, soft, typeface);
        items_[i].picture.draw(canvas, {at.x, at.y + kHeader}, places[i].scale, typeface);
    }
    write_canvas(canvas, path);
}

void write_before_and_after(const Side& side, const std::filesystem::path& folder) {
    constexpr double kWidth = 900.0;
    constexpr double kHeight = 900.0;
    constexpr io::Rgb kUnknownGrey{205, 205, 205};
    constexpr io::Rgb kWhite{254, 254, 254};
    constexpr io::Rgb kBlack{0, 0, 0};
    const draw::FloorPlan plan = plan_within(side.map, side.rooms, kWidth, kHeight);
    draw::Canvas before(plan.page_width, plan.page_height, kUnknownGrey);
    fill_cells(before, side.map, plan, CellState::free, kWhite);
    fill_cells(before, side.map, plan, CellState::occupied, kBlack);
    write_canvas(before, folder / "before.png");
    draw::Canvas after(plan.page_width, plan.page_height, draw::kPaper);
    draw::draw_plan(after, plan, draw::Typeface());
    write_canvas(after, folder / "after.png");
}

}  // namespace quadcut::gallery
