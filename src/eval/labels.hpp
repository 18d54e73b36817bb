// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/label_image.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

// Labels of cells as scores want them.
namespace quadcut {

/// A raster as scores want it: its lowest row last.
template <typename Label>
io::LabelImage as_label_image(const Raster<Label>& labels,
                              std::size_t ignored_cells = io::kIgnoredRegionPixels) {
    std::vector<std::uint32_t> values;
    values.reserve(labels.values.size());
    for (auto y = static_cast<std::ptrdiff_t>(labels.height); y-- > 0;) {
        const auto row = labels.values.begin() + y * labels.width;
        values.insert(values.end(), row, row + labels.width);
    }
    return io::number_regions(labels.width, labels.height, values, ignored_cells);
}

/// An image of labels as a raster: its lowest row first.
[[nodiscard]] Raster<std::uint32_t> as_raster(const io::LabelImage& image);

/// The labels of a map at the free cells of another one, by the map frame; 0 beyond.
template <typename Label>
Raster<std::uint32_t> labels_at(const GridMap& labelled, const Raster<Label>& labels,
                                const GridMap& map) {
    Raster<std::uint32_t> result(map.states.origin, map.states.width, map.states.height);
    const Pose labelled_from_map = compose(inverse(labelled.map_from_image), map.map_from_image);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        if (map.states.values[i] != CellState::free) continue;
        const Cell cell = result.cell(i);
        const Point at = transform(labelled_from_map, {(cell.x + 0.5) * map.resolution_m,
                                                       (cell.y + 0.5) * map.resolution_m});
        const Cell from{static_cast<std::int32_t>(std::floor(at.x / labelled.resolution_m)),
                        static_cast<std::int32_t>(std::floor(at.y / labelled.resolution_m))};
        if (labels.contains(from)) result.values[i] = labels.at(from);
    }
    return result;
}

}  // namespace quadcut
