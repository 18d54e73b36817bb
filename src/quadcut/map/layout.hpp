// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// How a part of a raster is laid out anew: cropped, and turned by quarters or mirrored. What is
/// computed on a map in its standard layout does not depend on how the map was turned, mirrored,
/// moved or padded.
struct Layout {
    Box box;
    bool is_transposed = false;
    /// Of the new axes.
    bool is_x_reversed = false;
    bool is_y_reversed = false;

    /// Where the new cell comes from.
    [[nodiscard]] Cell source(Cell cell) const {
        if (is_x_reversed) cell.x = width() - 1 - cell.x;
        if (is_y_reversed) cell.y = height() - 1 - cell.y;
        if (is_transposed) std::swap(cell.x, cell.y);
        return {box.low.x + cell.x, box.low.y + cell.y};
    }
    /// Where such a cell goes.
    [[nodiscard]] Cell place_of(Cell source) const {
        Cell cell{source.x - box.low.x, source.y - box.low.y};
        if (is_transposed) std::swap(cell.x, cell.y);
        if (is_x_reversed) cell.x = width() - 1 - cell.x;
        if (is_y_reversed) cell.y = height() - 1 - cell.y;
        return cell;
    }
    /// The same for a point; both in cells, the new cell (0, 0) covering [0, 1) x [0, 1).
    [[nodiscard]] Point source_point(Point point) const {
        if (is_x_reversed) point.x = width() - point.x;
        if (is_y_reversed) point.y = height() - point.y;
        if (is_transposed) std::swap(point.x, point.y);
        return {box.low.x + point.x, box.low.y + point.y};
    }
    [[nodiscard]] std::int32_t width() const { return is_transposed ? box.height() : box.width(); }
    [[nodiscard]] std::int32_t height() const { return is_transposed ? box.width() : box.height(); }
};

/// The map as it lies, from cell (0, 0) on.
[[nodiscard]] inline Layout as_it_lies(const Box& box) { return {box, false, false, false}; }

/// Where what was laid out lies in the map frame.
struct LaidOutFrame {
    Layout layout;
    double resolution_m = 0.05;
    Pose map_from_image;

    /// Of a point in cells of the layout; metres.
    [[nodiscard]] Point in_map(const Point& cells) const {
        const Point at = layout.source_point(cells);
        return transform(map_from_image, {at.x * resolution_m, at.y * resolution_m});
    }
};

/// Sums over cells of the powers 0 to 3 of one coordinate.
struct AxisMoments {
    double n = 0.0;
    double s1 = 0.0;
    double s2 = 0.0;
    double s3 = 0.0;
};

/// How cells with these moments are turned: the longer spread and the longer tails along the
/// positive axes. The box is empty.
[[nodiscard]] Layout standard_orientation(const AxisMoments& x, const AxisMoments& y);

/// The standard layout of what is not 0: its box with a margin of one cell, turned by
/// standard_orientation(). An empty mask has an empty box. O(cells).
[[nodiscard]] Layout standard_layout(const Raster<std::uint8_t>& mask,
                                     const Executor& executor = {});

/// Calls `visit(offset laid out, offset in the raster)` for the cells of a layout that lie in a
/// raster, from all threads; in blocks, so that turning reads and writes memory in short rows.
template <typename T, typename Visitor>
void for_each_laid_out(const Raster<T>& raster, const Layout& layout, const Executor& executor,
                       const Visitor& visit) {
    constexpr std::int32_t kBlock = 64;
    const std::int32_t width = layout.width();
    const std::int32_t height = layout.height();
    if (width <= 0 || height <= 0) return;
    parallel_for(executor, static_cast<std::size_t>(height), kBlock,
                 [&](std::size_t first, std::size_t last) {
                     const auto low = static_cast<std::int32_t>(first);
                     const auto high = static_cast<std::int32_t>(last);
                     const std::int32_t columns = layout.is_transposed ? kBlock : width;
                     for (std::int32_t begin = 0; begin < width; begin += columns) {
                         const std::int32_t end = std::min(width, begin + columns);
                         for (std::int32_t y = low; y < high; ++y) {
                             const Cell from = layout.source({begin, y});
                             const Cell next = layout.source({begin + 1, y});
                             const Cell step{next.x - from.x, next.y - from.y};
                             // The columns whose source lies in the raster.
                             std::int32_t x = begin;
                             std::int32_t stop = end;
                             const auto source = [&](std::int32_t column) {
                                 return Cell{from.x + (column - begin) * step.x,
                                             from.y + (column - begin) * step.y};
                             };
                             while (x < stop && !raster.contains(source(x))) ++x;
                             while (x < stop && !raster.contains(source(stop - 1))) --stop;
                             if (x >= stop) continue;
                             const auto stride = static_cast<std::ptrdiff_t>(step.x) +
                                                 static_cast<std::ptrdiff_t>(step.y) * raster.width;
                             auto there = static_cast<std::ptrdiff_t>(raster.offset(source(x)));
                             const std::size_t row =
                                 static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
                             for (; x < stop; ++x, there += stride) {
                                 visit(row + static_cast<std::size_t>(x),
                                       static_cast<std::size_t>(there));
                             }
                         }
                     }
                 });
}

/// The raster in the layout, from cell (0, 0) on; `outside` where the box reaches beyond. O(box).
template <typename T>
[[nodiscard]] Raster<T> laid_out(const Raster<T>& raster, const Layout& layout, T outside,
                                 const Executor& executor = {}) {
    Raster<T> out({0, 0}, layout.width(), layout.height(), outside, executor);
    for_each_laid_out(raster, layout, executor, [&](std::size_t to, std::size_t from) {
        out.values[to] = raster.values[from];
    });
    return out;
}

/// The reverse: what was laid out is put back into `raster`, which keeps its cells outside the box.
template <typename T>
void put_back(const Raster<T>& laid_out, const Layout& layout, Raster<T>& raster,
              const Executor& executor = {}) {
    for_each_laid_out(raster, layout, executor, [&](std::size_t from, std::size_t to) {
        raster.values[to] = laid_out.values[from];
    });
}

}  // namespace quadcut
