// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <utility>

#include "quadcut/base/geometry.hpp"
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
    [[nodiscard]] std::int32_t width() const { return is_transposed ? box.height() : box.width(); }
    [[nodiscard]] std::int32_t height() const { return is_transposed ? box.width() : box.height(); }
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
[[nodiscard]] Layout standard_layout(const Raster<std::uint8_t>& mask);

/// The raster in the layout, from cell (0, 0) on; `outside` where the box reaches beyond. O(box).
template <typename T>
[[nodiscard]] Raster<T> laid_out(const Raster<T>& raster, const Layout& layout, T outside) {
    Raster<T> out({0, 0}, layout.width(), layout.height(), outside);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
        const Cell from = layout.source(out.cell(i));
        if (raster.contains(from)) out.values[i] = raster.at(from);
    }
    return out;
}

/// The reverse: what was laid out is put back into `raster`, which keeps its cells outside the box.
template <typename T>
void put_back(const Raster<T>& laid_out, const Layout& layout, Raster<T>& raster) {
    for (std::size_t i = 0; i < laid_out.values.size(); ++i) {
        const Cell to = layout.source(laid_out.cell(i));
        if (raster.contains(to)) raster.at(to) = laid_out.values[i];
    }
}

}  // namespace quadcut
