// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/entry_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "bench/gallery/fault_pane.hpp"
#include "bench/gallery/pair_picture.hpp"
#include "draw/render.hpp"
#include "io/file.hpp"
#include "reproduce/plan_within.hpp"

namespace quadcut::gallery {
namespace {

constexpr double kMargin = 24.0;
constexpr double kNameSize = 30.0;
constexpr double kTextSize = 20.0;

io::Rgb soft_ink() { return io::mixed(draw::kPaper, draw::kTextInk, 0.7); }

/// The exhibit's name and figures, on one line.
void draw_title(draw::Canvas& canvas, const Exhibit& exhibit, const draw::Typeface& typeface) {
    const double after_name = kMargin + typeface.width(exhibit.name, kNameSize) + kNameSize / 2.0;
    draw_caption(canvas, exhibit.name, {kMargin, 42.0}, kNameSize, draw::kTextInk, typeface);
    draw_caption(canvas, figures_text(exhibit.comparison), {after_name, 42.0}, kTextSize,
                 draw::kTextInk, typeface);
}

Entry entry_of(const Exhibit& exhibit, const std::string& note, const std::string& image) {
    return {exhibit.name,
            image,
            note,
            exhibit.comparison.predicted.size(),
            exhibit.result.rooms.doors.size(),
            exhibit.comparison};
}

/// A box of each colour and what it stands for, in a row from the left.
void draw_keys(draw::Canvas& canvas, const std::vector<FaultKey>& keys, const Point& left,
               const draw::Typeface& typeface) {
    constexpr double kBox = 18.0;
    double x = left.x;
    for (const FaultKey& key : keys) {
        draw::Shape box;
        box.add_polygon(std::array<Point, 4>{
            Point{x, left.y - kBox + 2.0}, Point{x + kBox, left.y - kBox + 2.0},
            Point{x + kBox, left.y + 2.0}, Point{x, left.y + 2.0}});
        canvas.fill(std::move(box), key.ink);
        draw_caption(canvas, key.text, {x + 1.5 * kBox, left.y}, kTextSize, draw::kTextInk,
                     typeface);
        x += 3.0 * kBox + typeface.width(key.text, kTextSize);
    }
}

/// Three pictures of a frame on one page, each with a line of text above it.
struct Triple {
    double scale = 1.0;
    bool is_column = false;
    double pane_width = 0.0;
    double pane_height = 0.0;

    static constexpr double kTitle = 60.0;
    static constexpr double kLine = 34.0;

    /// The upper left corner of picture 0, 1 or 2.
    [[nodiscard]] Point corner(int place) const {
        const double right = is_column ? 0.0 : place * (pane_width + PairPicture::kGap);
        const double down = is_column ? place * (pane_height + kLine + kMargin) : 0.0;
        return {kMargin + right, kTitle + kLine + down};
    }
};

/// In a row or in a column, as shows more.
Triple arrange(const PairPicture& picture) {
    constexpr double kRowPane = 1250.0;
    constexpr double kRowHeight = 1700.0;
    constexpr double kColumnWidth = 2600.0;
    constexpr double kColumnPane = 800.0;
    constexpr double kMostPixels = 4.0;
    const auto width = static_cast<double>(picture.frame().width());
    const auto height = static_cast<double>(picture.frame().height());
    const double in_row = std::min(kRowPane / width, kRowHeight / height);
    const double in_column = std::min(kColumnWidth / width, kColumnPane / height);
    const double scale = std::min(std::max(in_row, in_column), kMostPixels);
    return {scale, in_column > in_row, scale * width, scale * height};
}

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
    const PairPicture picture(exhibit);
    const double scale = std::max(picture.pixels_per_cell(kWidth, kHeight),
                                  picture.pixels_per_cell(kLongWidth, kLongHeight));
    const double pane = picture.pane_width(scale);
    const double width = std::max(2.0 * pane + PairPicture::kGap, kLeastWidth) + 2.0 * kMargin;
    const double height = picture.pane_height(scale) + kHeader + kMargin;
    draw::Canvas canvas(static_cast<std::int32_t>(std::ceil(width)),
                        static_cast<std::int32_t>(std::ceil(height)), draw::kPaper);
    const draw::Typeface typeface;
    draw_title(canvas, exhibit, typeface);
    draw_caption(canvas, "truth", {kMargin, 78.0}, kTextSize, soft_ink(), typeface);
    draw_caption(canvas, "result", {kMargin + pane + PairPicture::kGap, 78.0}, kTextSize,
                 soft_ink(), typeface);
    picture.draw(canvas, {kMargin, kHeader}, scale, typeface);
    write_canvas(canvas, output / image);
    return entry_of(exhibit, note, image);
}

Entry write_with_faults(const Exhibit& exhibit, const std::filesystem::path& output,
                        const std::string& image) {
    constexpr double kLeastWidth = 1500.0;  // So that the texts have space.
    const FaultPane faults(exhibit);
    PairPicture picture(exhibit);
    picture.widen(faults.frame());
    const Triple triple = arrange(picture);
    const Point last = triple.corner(2);
    const double width = std::max(last.x + triple.pane_width + kMargin, kLeastWidth);
    const double height = last.y + triple.pane_height + kMargin + Triple::kLine;
    draw::Canvas canvas(static_cast<std::int32_t>(std::ceil(width)),
                        static_cast<std::int32_t>(std::ceil(height)), draw::kPaper);
    const draw::Typeface typeface;
    draw_title(canvas, exhibit, typeface);
    constexpr std::array<const char*, 3> kTitles{"truth", "result", "what is wrong"};
    for (int place = 0; place < 3; ++place) {
        const Point corner = triple.corner(place);
        draw_caption(canvas, kTitles.at(static_cast<std::size_t>(place)),
                     {corner.x, corner.y - 12.0}, kTextSize, soft_ink(), typeface);
    }
    picture.draw_truth(canvas, triple.corner(0), triple.scale, typeface);
    picture.draw_result(canvas, triple.corner(1), triple.scale, typeface);
    faults.draw(canvas, picture.frame(), last, triple.scale, typeface);
    draw_keys(canvas, faults.keys(), {kMargin, height - kMargin}, typeface);
    write_canvas(canvas, output / image);
    return entry_of(exhibit, faults.cuts_text(), image);
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
