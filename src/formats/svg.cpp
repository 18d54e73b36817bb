// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/svg.hpp"

#include "formats/format.hpp"

namespace quadcut::formats {

Format svg_format() {
    return {"svg",
            "the floor plan for browsers and drawing programs",
            Part::rooms,
            {"rooms.svg"},
            [](const Result& result) { return contents(draw::render_svg(result.plan())); }};
}

}  // namespace quadcut::formats
