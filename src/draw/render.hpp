// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "draw/canvas.hpp"
#include "draw/floor_plan.hpp"
#include "draw/typeface.hpp"

namespace quadcut::draw {

/// The plan as an 8-bit RGB PNG. About 10 ns a pixel of the page on one thread.
[[nodiscard]] std::string render_png(const FloorPlan& plan, const Executor& executor = {});

/// Draws the plan where it says it is; what is there already stays where the plan has nothing.
void draw_plan(Canvas& canvas, const FloorPlan& plan, const Typeface& typeface);

/// A line of text with a halo that keeps it legible on what is below.
void draw_text(Canvas& canvas, const TextLine& line, TextDirection direction, io::Rgb ink,
               io::Rgb halo, const Typeface& typeface);

}  // namespace quadcut::draw
