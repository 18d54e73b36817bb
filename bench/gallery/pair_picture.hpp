// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "bench/gallery/exhibit.hpp"
#include "draw/canvas.hpp"
#include "draw/floor_plan.hpp"
#include "draw/typeface.hpp"

namespace quadcut::gallery {

/// Text from `left` on along the base line at `left.y`.
void draw_caption(draw::Canvas& canvas, const std::string& text, const Point& left, double size,
                  io::Rgb ink, const draw::Typeface& typeface);

/// The plan where it belongs among pictures of one frame, whose upper left corner is at `origin`.
[[nodiscard]] draw::FloorPlan plan_in_frame(const draw::FloorPlan& plan, const Box& frame,
                                            const Point& origin, double pixels_per_cell);

/// Truth at the left, result at the right, on the same scale. Rooms that were found have the same
/// colour on both sides; the others are white, hatched in red, with a word that says what is wrong.
/// The borders of the truth run over the result as thin dark lines.
class PairPicture {
public:
    explicit PairPicture(const Exhibit& exhibit);

    /// The most pixels a cell with which both fit side by side into a rectangle.
    [[nodiscard]] double pixels_per_cell(double width, double height) const;
    /// Of one of the two, pixels.
    [[nodiscard]] double pane_width(double pixels_per_cell) const;
    [[nodiscard]] double pane_height(double pixels_per_cell) const;

    /// Draws both from `origin`, the upper left corner, on.
    void draw(draw::Canvas& canvas, const Point& origin, double pixels_per_cell,
              const draw::Typeface& typeface) const;

    /// One of the two alone.
    void draw_truth(draw::Canvas& canvas, const Point& origin, double pixels_per_cell,
                    const draw::Typeface& typeface) const;
    void draw_result(draw::Canvas& canvas, const Point& origin, double pixels_per_cell,
                     const draw::Typeface& typeface) const;

    /// Both show these cells, too: those of a picture beside them.
    void widen(const Box& frame) { frame_.include(frame); }
    /// The cells that both show.
    [[nodiscard]] const Box& frame() const { return frame_; }

    /// Between the two, pixels.
    static constexpr double kGap = 24.0;

private:
    /// A plan, and a word for each of its rooms that is wrong.
    struct Pane {
        draw::FloorPlan plan;
        std::vector<draw::LabelText> errors;
        Raster<std::uint16_t> ground;
    };
    [[nodiscard]] static Pane make_pane(const Side& side, const std::vector<io::Rgb>& colors,
                                        const std::vector<std::string>& words);
    void draw_errors(draw::Canvas& canvas, const Pane& pane, const draw::FloorPlan& plan,
                     const Point& origin, double pixels_per_cell,
                     const draw::Typeface& typeface) const;

    Pane truth_;
    Pane result_;
    Box frame_;
};

}  // namespace quadcut::gallery
