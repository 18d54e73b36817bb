// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <vector>

#include "draw/floor_plan.hpp"
#include "io/palette.hpp"
#include "io/room_colors.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

/// The rooms' plan with names and doors, at most `width` x `height` pixels.
[[nodiscard]] inline draw::FloorPlan plan_within(const GridMap& map, const Segmentation& rooms,
                                                 double width, double height) {
    const std::vector<io::Rgb> colors = io::room_colors(rooms, io::find_near_rooms(map, rooms));
    const draw::FloorPlan plan = draw::lay_out_floor_plan(map, rooms, colors);
    const double factor = std::min({1.0, width / plan.page_width, height / plan.page_height});
    return draw::placed(plan, factor, {0.0, 0.0});
}

}  // namespace quadcut
