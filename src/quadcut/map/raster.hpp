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
    explicit Raster(const Box& box, T fill = T{})
        : Raster(box.low, box.width(), box.height(), fill) {}

    [[nodiscard]] Box box() const {
        return {origin, {origin.x + width - 1, origin.y + height - 1}};
    }
    /// Any cell may be asked.
    [[nodiscard]] bool contains(Cell cell) const {
        // One comparison a side: what is left of the rectangle wraps around to a large number.
        const auto distance = [](std::int32_t at, std::int32_t from) {
            return static_cast<std::uint32_t>(at) - static_cast<std::uint32_t>(from);
        };
        return distance(cell.x, origin.x) < static_cast<std::uint32_t>(width) &&
               distance(cell.y, origin.y) < static_cast<std::uint32_t>(height);
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
