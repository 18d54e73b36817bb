// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "eval/truth_score.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include "io/label_image.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {
namespace {

/// The centre of a cell in the map frame.
Point center_of(const GridMap& map, Cell cell) {
    return transform(map.map_from_image, {(cell.x - map.states.origin.x + 0.5) * map.resolution_m,
                                          (cell.y - map.states.origin.y + 0.5) * map.resolution_m});
}

/// The cell that holds a point of the map frame; it may lie outside of the map.
Cell cell_at(const GridMap& map, const Pose& image_from_map, const Point& point) {
    const Point in_image = transform(image_from_map, point);
    return {
        map.states.origin.x + static_cast<std::int32_t>(std::floor(in_image.x / map.resolution_m)),
        map.states.origin.y + static_cast<std::int32_t>(std::floor(in_image.y / map.resolution_m))};
}

}  // namespace

eval::RoomScore score_against_truth(const GridMap& map, const Segmentation& rooms,
                                    const sim::Building& building) {
    const GridMap& world = building.map;
    const std::int32_t width = world.states.width;
    const std::int32_t height = world.states.height;
    const std::size_t num_cells = world.states.values.size();
    std::vector<std::uint32_t> predicted(num_cells, 0);
    std::vector<std::uint32_t> truth(num_cells, 0);
    io::FreeMask free{width, height, std::vector<std::uint8_t>(num_cells, 0)};
    const Pose image_from_map = inverse(map.map_from_image);
    for (std::size_t i = 0; i < num_cells; ++i) {
        truth[i] = building.labels.values[i];
        const Cell cell = cell_at(map, image_from_map, center_of(world, world.states.cell(i)));
        if (!map.states.contains(cell)) continue;
        free.is_free[i] = map.states.at(cell) == CellState::free ? 1 : 0;
        predicted[i] = rooms.labels.at(cell);
    }
    // Upside down, all three of them, which changes no score.
    return eval::score_rooms(io::number_regions(width, height, predicted),
                             io::number_regions(width, height, truth), free);
}

}  // namespace quadcut
