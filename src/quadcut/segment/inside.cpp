// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/inside.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "quadcut/map/components.hpp"

namespace quadcut {
Raster<std::uint8_t> mask_of(const GridMap& map, CellState state) {
    Raster<std::uint8_t> mask(map.states.origin, map.states.width, map.states.height);
    std::transform(
        map.states.values.begin(), map.states.values.end(), mask.values.begin(),
        [state](CellState own) { return own == state ? std::uint8_t{1} : std::uint8_t{0}; });
    return mask;
}

std::vector<Cell> visited_cells(const GridMap& map, std::span<const Point> trajectory) {
    const Pose image_from_map = inverse(map.map_from_image);
    std::vector<Cell> cells;
    for (const Point& point : trajectory) {
        const Point at = transform(image_from_map, point);
        const double x = std::floor(at.x / map.resolution_m);
        const double y = std::floor(at.y / map.resolution_m);
        if (!(std::abs(x) < 1e9 && std::abs(y) < 1e9)) continue;
        const Cell cell{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
        if (map.states.contains(cell)) cells.push_back(cell);
    }
    return cells;
}

Raster<std::uint8_t> inside(const GridMap& map, std::span<const Point> trajectory,
                            double min_area_m2, const Executor& executor) {
    const FreeComponents free = find_free_components(map.states, executor);
    const double min_cells = min_area_m2 / (map.resolution_m * map.resolution_m);
    std::vector<bool> kept;
    for (const FreeComponents::Component& component : free.components) {
        kept.push_back(static_cast<double>(component.num_cells) >= min_cells);
    }
    const auto outside = find_outside(free, static_cast<std::size_t>(std::ceil(min_cells)));
    if (outside && !components_with(free, visited_cells(map, trajectory))[*outside]) {
        kept[*outside] = false;
    }
    return mask_of(free, kept, executor);
}

}  // namespace quadcut
