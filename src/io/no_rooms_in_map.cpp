// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/no_rooms_in_map.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "quadcut/map/connected_parts.hpp"
#include "quadcut/segment/inside.hpp"

namespace quadcut::io {
namespace {

std::string with_unit(double value, const char* unit) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.3g %s", value, unit);
    return text.data();
}

}  // namespace

std::string why_no_rooms(const GridMap& map, const SegmentOptions& options,
                         std::span<const Point> trajectory) {
    const std::vector<std::size_t> num_cells = free_parts(map.states).num_cells();
    if (num_cells.size() == 1) return "no room: no cell of the map is free";
    const bool is_paper = options.preset == Preset::paper;
    const double min_m2 =
        is_paper ? options.paper.min_component_m2 : options.rooms.min_component_m2;
    const std::size_t largest = *std::max_element(num_cells.begin(), num_cells.end());
    const double largest_m2 = static_cast<double>(largest) * map.resolution_m * map.resolution_m;
    const std::string prefix = is_paper ? "paper." : "rooms.";
    if (largest_m2 < min_m2) {
        return "no room: the largest free space has " + with_unit(largest_m2, "m²") +
               ", and what is smaller than " + with_unit(min_m2, "m²") + " is left out (--set " +
               prefix + "min_component=...)";
    }
    const Raster<std::uint8_t> kept = inside(map, trajectory, min_m2);
    const auto num_kept = std::count(kept.values.begin(), kept.values.end(), std::uint8_t{1});
    if (static_cast<std::size_t>(num_kept) < largest) {
        return "no room: all that is large enough is the ground outside, along the map's border "
               "(--poses FILE says where the robot was)";
    }
    if (is_paper) {
        return "no room: no free space has a leaf of " + with_unit(options.paper.min_leaf_m, "m") +
               " (--set paper.min_leaf=...), or none is where the robot was";
    }
    return "no room: no free space is as wide as " + with_unit(options.rooms.min_passable_m, "m") +
           " (--set rooms.min_passable=...)";
}

}  // namespace quadcut::io
