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
    const ConnectedParts free = free_parts(map.states, executor);
    const double min_cells = min_area_m2 / (map.resolution_m * map.resolution_m);
    std::vector<std::uint8_t> kept;
    for (const std::size_t num_cells : free.num_cells()) {
        kept.push_back(num_cells > 0 && static_cast<double>(num_cells) >= min_cells ? 1 : 0);
    }
    const std::uint32_t outside =
        find_outside(free, static_cast<std::size_t>(std::ceil(min_cells)));
    const std::vector<Cell> visited = visited_cells(map, trajectory);
    const Cell origin = map.states.origin;
    const bool is_entered = std::any_of(visited.begin(), visited.end(), [&](Cell cell) {
        return free.part_at(static_cast<std::uint32_t>(cell.x - origin.x),
                            static_cast<std::size_t>(cell.y - origin.y)) == outside;
    });
    if (!is_entered) kept[outside] = 0;
    auto mask = Raster<std::uint8_t>::unset(map.states.box());
    free.paint(kept, mask, executor);
    return mask;
}

}  // namespace quadcut
