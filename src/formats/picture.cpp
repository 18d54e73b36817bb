// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/render.hpp"
#include "formats/format.hpp"

namespace quadcut::formats {

Format picture_format() {
    return {"picture",
            "the floor plan, to look at",
            Part::rooms,
            {"rooms_color.png"},
            [](const Result& result) {
                return contents(draw::render_png(result.plan(), result.executor()));
            }};
}

}  // namespace quadcut::formats
