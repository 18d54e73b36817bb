// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"

namespace quadcut {

/// Leaves new values as they are in memory: the threads that write them first do so together.
template <typename T>
struct UnsetAllocator : std::allocator<T> {
    static_assert(std::is_trivially_copyable_v<T>);
    UnsetAllocator() = default;
    template <typename U>
    explicit UnsetAllocator(const UnsetAllocator<U>& other) : std::allocator<T>(other) {}
    template <typename U, typename... Values>
    void construct(U* at, Values&&... values) {
        if constexpr (sizeof...(Values) != 0)
            std::construct_at(at, std::forward<Values>(values)...);
    }
};

/// A dense rectangle of cells: cell (x, y) of the map is at (x - origin.x, y - origin.y) here.
/// Row 0 is the lowest. No invariant beyond values.size() == width * height. To make `values`
/// larger leaves the new ones unset.
template <typename T>
struct Raster {
    using Values = std::vector<T, UnsetAllocator<T>>;

    Cell origin;
    std::int32_t width = 0;
    std::int32_t height = 0;
    Values values;

    Raster() = default;
    Raster(Cell lower_left, std::int32_t raster_width, std::int32_t raster_height, T fill = T{},
           const Executor& executor = {})
        : origin(lower_left), width(raster_width), height(raster_height) {
        constexpr std::size_t kChunk = std::size_t{1} << 18U;
        values.resize(static_cast<std::size_t>(raster_width) *
                      static_cast<std::size_t>(raster_height));
        parallel_for(executor, values.size(), kChunk, [&](std::size_t first, std::size_t last) {
            std::fill(values.data() + first, values.data() + last, fill);
        });
    }
    explicit Raster(const Box& box, T fill = T{}, const Executor& executor = {})
        : Raster(box.low, box.width(), box.height(), fill, executor) {}

    /// For whoever writes all cells first.
    [[nodiscard]] static Raster unset(const Box& box) {
        Raster raster;
        raster.origin = box.low;
        raster.width = box.width();
        raster.height = box.height();
        raster.values.resize(static_cast<std::size_t>(raster.width) *
                             static_cast<std::size_t>(raster.height));
        return raster;
    }

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
