// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut::draw {

/// A map that grows, at one moment.
struct Moment {
    std::string caption;
    GridMap map;
    Segmentation rooms;
    /// Where the robot has been, metres, map frame.
    std::vector<Point> way;
};

/// The moments side by side, so many in a row, at one scale and in one frame, as an 8-bit RGB PNG:
/// rooms keep their colours as they keep their ids (the paper's Fig 12). O(cells of all maps).
/// @pre there is one at least; all maps have the same resolution and are not turned; per_row > 0.
[[nodiscard]] std::string render_filmstrip(std::span<const Moment> moments,
                                           std::size_t per_row = 4);

}  // namespace quadcut::draw
