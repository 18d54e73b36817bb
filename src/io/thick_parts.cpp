// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/thick_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadcut::io {
namespace {

/// Rows from the first to the last; in each, every cell becomes set if the `side` cells that end at
/// it are set, along the row and then down the column: the upper right corners of full squares.
void keep_square_ends(Raster<std::uint8_t>& mask, std::int32_t side) {
    const auto width = static_cast<std::size_t>(mask.width);
    std::vector<std::int32_t> column_run(width, side);  // As if rows of set cells came before.
    for (std::size_t begin = 0; begin < mask.values.size(); begin += width) {
        std::int32_t row_run = side;
        for (std::size_t x = 0; x < width; ++x) {
            std::uint8_t& cell = mask.values[begin + x];
            row_run = cell != 0 ? row_run + 1 : 0;
            column_run[x] = row_run >= side ? column_run[x] + 1 : 0;
            cell = column_run[x] >= side ? 1 : 0;
        }
    }
}

/// Rows from the last to the first: every cell becomes set if one of the `side` cells from it on
/// is.
void fill_squares(Raster<std::uint8_t>& ends, std::int32_t side) {
    const auto width = static_cast<std::size_t>(ends.width);
    std::vector<std::int32_t> column_left(width, 0);
    for (std::size_t begin = ends.values.size(); begin > 0;) {
        begin -= width;
        std::int32_t row_left = 0;
        for (std::size_t x = width; x-- > 0;) {
            std::uint8_t& cell = ends.values[begin + x];
            row_left = cell != 0 ? side : std::max(row_left - 1, 0);
            column_left[x] = row_left > 0 ? side : std::max(column_left[x] - 1, 0);
            cell = column_left[x] > 0 ? 1 : 0;
        }
    }
}

/// The mask with a border of `margin` set cells above and to the right. (On the lower and left
/// border keep_square_ends does as if they were there.)
Raster<std::uint8_t> widened(const Raster<std::uint8_t>& mask, std::int32_t margin) {
    Raster<std::uint8_t> wide(mask.origin, mask.width + margin, mask.height + margin, 1);
    for (std::int32_t y = 0; y < mask.height; ++y) {
        const Cell first{mask.origin.x, mask.origin.y + y};
        std::copy_n(mask.values.begin() + static_cast<std::ptrdiff_t>(mask.offset(first)),
                    mask.width,
                    wide.values.begin() + static_cast<std::ptrdiff_t>(wide.offset(first)));
    }
    return wide;
}

/// The part of `wide` that begins `shift` cells above and to the right of its first cell.
Raster<std::uint8_t> cropped(const Raster<std::uint8_t>& wide, std::int32_t width,
                             std::int32_t height, std::int32_t shift) {
    Raster<std::uint8_t> result(wide.origin, width, height);
    for (std::int32_t y = 0; y < height; ++y) {
        const Cell from{wide.origin.x + shift, wide.origin.y + y + shift};
        const Cell to{wide.origin.x, wide.origin.y + y};
        std::copy_n(wide.values.begin() + static_cast<std::ptrdiff_t>(wide.offset(from)), width,
                    result.values.begin() + static_cast<std::ptrdiff_t>(result.offset(to)));
    }
    return result;
}

}  // namespace

Raster<std::uint8_t> find_thick_parts(const Raster<std::uint8_t>& mask, std::int32_t side_cells) {
    const std::int32_t side = std::max(side_cells, 1);
    Raster<std::uint8_t> wide = widened(mask, side);
    keep_square_ends(wide, side);
    fill_squares(wide, side);
    return cropped(wide, mask.width, mask.height, 0);
}

Raster<std::uint8_t> find_deep_parts(const Raster<std::uint8_t>& mask, std::int32_t margin_cells) {
    const std::int32_t margin = std::max(margin_cells, 0);
    Raster<std::uint8_t> wide = widened(mask, margin);
    keep_square_ends(wide, 2 * margin + 1);
    return cropped(wide, mask.width, mask.height, margin);
}

}  // namespace quadcut::io
