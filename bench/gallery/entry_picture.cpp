// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/entry_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "bench/gallery/pair_picture.hpp"
#include "draw/render.hpp"
#include "io/file.hpp"
#include "reproduce/plan_within.hpp"

namespace quadcut::gallery {
namespace {

constexpr double kMargin = 24.0;

}  // namespace

Entry write_pair(const Exhibit& exhibit, const std::string& note,
                 const std::filesystem::path& output, const std::string& image) {
    constexpr double kWidth = 2400.0;
    constexpr double kHeight = 1300.0;
    // Long buildings need more to be legible.
    constexpr double kLongWidth = 4000.0;
    constexpr double kLongHeight = 700.0;
    constexpr double kLeastWidth = 1100.0;  // So that the caption has space.
    constexpr double kHeader = 92.0;
    constexpr double kNameSize = 30.0;
    constexpr double kTextSize = 20.0;
    const PairPicture picture(exhibit);
    const double scale = std::max(picture.pixels_per_cell(kWidth, kHeight),
                                  picture.pixels_per_cell(kLongWidth, kLongHeight));
    const double pane = picture.pane_width(scale);
    const double width = std::max(2.0 * pane + PairPicture::kGap, kLeastWidth) + 2.0 * kMargin;
    const double height = picture.pane_height(scale) + kHeader + kMargin;
    draw::Canvas canvas(static_cast<std::int32_t>(std::ceil(width)),
                        static_cast<std::int32_t>(std::ceil(height)), draw::kPaper);
    const draw::Typeface typeface;
    const io::Rgb soft = io::mixed(draw::kPaper, draw::kTextInk, 0.7);
    const double after_name = kMargin + typeface.width(exhibit.name, kNameSize) + kNameSize / 2.0;
    draw_caption(canvas, exhibit.name, {kMargin, 42.0}, kNameSize, draw::kTextInk, typeface);
    draw_caption(canvas, figures_text(exhibit.comparison), {after_name, 42.0}, kTextSize,
                 draw::kTextInk, typeface);
    draw_caption(canvas, "truth", {kMargin, 78.0}, kTextSize, soft, typeface);
    draw_caption(canvas, "result", {kMargin + pane + PairPicture::kGap, 78.0}, kTextSize, soft,
                 typeface);
    picture.draw(canvas, {kMargin, kHeader}, scale, typeface);
    write_canvas(canvas, output / image);
    return {exhibit.name,
            image,
            note,
            exhibit.comparison.predicted.size(),
            exhibit.result.rooms.doors.size(),
            exhibit.comparison};
}

Entry write_alone(const std::string& name, const std::string& note, const GridMap& map,
                  const Segmentation& rooms, const std::filesystem::path& output,
                  const std::string& image) {
    constexpr double kSide = 2400.0;
    const draw::FloorPlan plan = plan_within(map, rooms, kSide, kSide);
    draw::Canvas canvas(plan.page_width, plan.page_height, draw::kPaper);
    draw::draw_plan(canvas, plan, draw::Typeface());
    write_canvas(canvas, output / image);
    return {name, image, note, rooms.rooms.size(), rooms.doors.size(), std::nullopt};
}

void write_canvas(const draw::Canvas& canvas, const std::filesystem::path& path) {
    std::filesystem::create_directories(path.parent_path());
    io::write_file_atomically(path, canvas.encode_png());
}

}  // namespace quadcut::gallery
