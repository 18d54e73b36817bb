// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/inside.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "quadcut/map/flood.hpp"

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
                            double min_area_m2) {
    const Raster<std::uint8_t> free = mask_of(map, CellState::free);
    Raster<std::uint8_t> kept(free.origin, free.width, free.height);
    std::vector<bool> is_visited(free.values.size(), false);
    for (const Cell cell : visited_cells(map, trajectory)) is_visited[free.offset(cell)] = true;
    const auto min_cells = min_area_m2 / (map.resolution_m * map.resolution_m);
    const std::int64_t num_edge_cells = 2 * (std::int64_t{free.width} + free.height) - 4;
    std::vector<bool> seen(free.values.size(), false);
    std::vector<std::size_t> outside;
    bool is_empty = true;
    for (std::size_t seed = 0; seed < free.values.size(); ++seed) {
        if (free.values[seed] == 0 || seen[seed]) continue;
        std::vector<std::size_t> component =
            flood(free, seed, seen, Connectivity::four,
                  [&](std::size_t cell) { return free.values[cell] != 0; });
        if (static_cast<double>(component.size()) < min_cells) continue;
        const auto num_on_edge =
            std::count_if(component.begin(), component.end(),
                          [&](std::size_t cell) { return is_on_edge(free, cell); });
        const bool entered = std::any_of(component.begin(), component.end(),
                                         [&](std::size_t cell) { return is_visited[cell]; });
        if (2 * num_on_edge > num_edge_cells && !entered) {
            outside = std::move(component);
            continue;
        }
        is_empty = false;
        for (const std::size_t cell : component) kept.values[cell] = 1;
    }
    if (is_empty) {
        for (const std::size_t cell : outside) kept.values[cell] = 1;
    }
    return kept;
}

}  // namespace quadcut
