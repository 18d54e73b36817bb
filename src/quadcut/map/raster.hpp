// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"

namespace quadcut {

/// A dense rectangle of cells: cell (x, y) of the map is at (x - origin.x, y - origin.y) here.
/// Row 0 is the lowest. No invariant beyond values.size() == width * height.
template <typename T>
struct Raster {
    Cell origin;
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::vector<T> values;

    Raster() = default;
    Raster(Cell lower_left, std::int32_t raster_width, std::int32_t raster_height, T fill = T{})
        : origin(lower_left),
          width(raster_width),
          height(raster_height),
          values(static_cast<std::size_t>(raster_width) * static_cast<std::size_t>(raster_height),
                 fill) {}

    [[nodiscard]] bool contains(Cell cell) const {
        return cell.x >= origin.x && cell.y >= origin.y && cell.x < origin.x + width &&
               cell.y < origin.y + height;
    }
    /// Position of a cell in `values`. @pre contains(cell).
    [[nodiscard]] std::size_t offset(Cell cell) const {
        return static_cast<std::size_t>(cell.y - origin.y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(cell.x - origin.x);
    }
    [[nodiscard]] Cell cell(std::size_t offset) const {
        return {origin.x + static_cast<std::int32_t>(offset % static_cast<std::size_t>(width)),
                origin.y + static_cast<std::int32_t>(offset / static_cast<std::size_t>(width))};
    }
    [[nodiscard]] T at(Cell cell) const { return values[offset(cell)]; }
    [[nodiscard]] T& at(Cell cell) { return values[offset(cell)]; }
};

}  // namespace quadcut
