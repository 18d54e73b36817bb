// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/inside.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace quadcut {
namespace {

struct Component {
    std::vector<std::size_t> cells;
    std::size_t num_border_cells = 0;
};

Component grow_component(const Raster<std::uint8_t>& free, std::size_t seed,
                         std::vector<bool>& seen) {
    const auto width = static_cast<std::size_t>(free.width);
    const auto height = static_cast<std::size_t>(free.height);
    Component component;
    const auto enter = [&](std::size_t cell) {
        if (free.values[cell] == 0 || seen[cell]) return;
        seen[cell] = true;
        component.cells.push_back(cell);
    };
    enter(seed);
    for (std::size_t i = 0; i < component.cells.size(); ++i) {
        const std::size_t cell = component.cells[i];
        const std::size_t x = cell % width;
        const std::size_t y = cell / width;
        if (x == 0 || y == 0 || x + 1 == width || y + 1 == height) ++component.num_border_cells;
        if (x > 0) enter(cell - 1);
        if (x + 1 < width) enter(cell + 1);
        if (y > 0) enter(cell - width);
        if (y + 1 < height) enter(cell + width);
    }
    return component;
}

}  // namespace

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
    const std::size_t border =
        2 * static_cast<std::size_t>(free.width) + 2 * static_cast<std::size_t>(free.height);
    std::vector<bool> seen(free.values.size(), false);
    std::vector<std::size_t> outside;
    bool is_empty = true;
    for (std::size_t seed = 0; seed < free.values.size(); ++seed) {
        if (free.values[seed] == 0 || seen[seed]) continue;
        Component component = grow_component(free, seed, seen);
        if (static_cast<double>(component.cells.size()) < min_cells) continue;
        const bool entered = std::any_of(component.cells.begin(), component.cells.end(),
                                         [&](std::size_t cell) { return is_visited[cell]; });
        if (2 * component.num_border_cells > border - 4 && !entered) {
            outside = std::move(component.cells);
            continue;
        }
        is_empty = false;
        for (const std::size_t cell : component.cells) kept.values[cell] = 1;
    }
    if (is_empty) {
        for (const std::size_t cell : outside) kept.values[cell] = 1;
    }
    return kept;
}

}  // namespace quadcut
