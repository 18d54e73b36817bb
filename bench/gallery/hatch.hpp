// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "draw/canvas.hpp"

namespace quadcut::gallery {

/// Lines that rise to the right at 45 degrees, `spacing` pixels apart, where they lie inside of the
/// polygons (even-odd: a polygon within another is a hole). O(lines * corners).
[[nodiscard]] draw::Shape hatch(const std::vector<std::vector<Point>>& polygons, double spacing,
                                double line_width);

}  // namespace quadcut::gallery
