// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/thick_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

namespace quadcut::draw {
namespace {

constexpr std::size_t kRowsPerChunk = 32;
constexpr std::size_t kColumnsPerChunk = 256;

/// Calls `body(row)` for each row of the mask.
template <typename Body>
void for_each_row(Raster<std::uint8_t>& mask, const Executor& executor, const Body& body) {
    const auto width = static_cast<std::size_t>(mask.width);
    parallel_for(executor, static_cast<std::size_t>(mask.height), kRowsPerChunk,
                 [&](std::size_t first, std::size_t last) {
                     for (std::size_t y = first; y < last; ++y) {
                         body(mask.values.data() + y * width);
                     }
                 });
}

/// The place of the next cell, from `begin` on, that is `value`, 0 or 1.
std::size_t next_of(const std::uint8_t* row, std::size_t begin, std::size_t end, int value) {
    const void* const found = std::memchr(row + begin, value, end - begin);
    return found == nullptr
               ? end
               : static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - row);
}

/// Calls `visit(begin, end)` for each run of set cells of a row, which it may change.
template <typename Visitor>
void for_each_run(const std::uint8_t* row, std::size_t width, const Visitor& visit) {
    for (std::size_t begin = next_of(row, 0, width, 1); begin < width;) {
        const std::size_t end = next_of(row, begin, width, 0);
        const std::size_t next = next_of(row, end, width, 1);
        visit(begin, end);
        begin = next;
    }
}

/// Calls `combine(first column, last, step)` for a few columns at a time: when rows of those have
/// been combined with the one `step` rows on for each of the steps, each stands for `side` rows.
template <typename Combine>
void for_each_reach(const Raster<std::uint8_t>& mask, std::int32_t side, const Executor& executor,
                    const Combine& combine) {
    parallel_for(executor, static_cast<std::size_t>(mask.width), kColumnsPerChunk,
                 [&](std::size_t first, std::size_t last) {
                     const auto whole = static_cast<std::size_t>(side);
                     for (std::size_t reach = 1; reach < whole;) {
                         const std::size_t step = std::min(reach, whole - reach);
                         combine(first, last, step);
                         reach += step;
                     }
                 });
}

/// Every cell stays set only if the `side` cells that end at it are, along the row and then up the
/// column: the upper right corners of full squares.
void keep_square_ends(Raster<std::uint8_t>& mask, std::int32_t side, const Executor& executor) {
    const auto width = static_cast<std::size_t>(mask.width);
    const auto height = static_cast<std::size_t>(mask.height);
    const auto lost = static_cast<std::size_t>(side) - 1;
    for_each_row(mask, executor, [&](std::uint8_t* row) {
        for_each_run(row, width, [&](std::size_t begin, std::size_t end) {
            if (begin == 0) return;  // As if set cells came before.
            std::fill(row + begin, row + std::min(begin + lost, end), std::uint8_t{0});
        });
    });
    // What is below the first row counts as set.
    for_each_reach(mask, side, executor,
                   [&](std::size_t first, std::size_t last, std::size_t step) {
                       for (std::size_t y = height; y-- > step;) {
                           std::uint8_t* const row = mask.values.data() + y * width;
                           const std::uint8_t* const below = row - step * width;
                           for (std::size_t x = first; x < last; ++x) row[x] &= below[x];
                       }
                   });
}

/// Every cell becomes set if one of the `side` cells from it on is, along the row and then up the
/// column.
void fill_squares(Raster<std::uint8_t>& ends, std::int32_t side, const Executor& executor) {
    const auto width = static_cast<std::size_t>(ends.width);
    const auto height = static_cast<std::size_t>(ends.height);
    const auto reach = static_cast<std::size_t>(side) - 1;
    for_each_row(ends, executor, [&](std::uint8_t* row) {
        for_each_run(row, width, [&](std::size_t begin, std::size_t) {
            std::fill(row + (begin > reach ? begin - reach : 0), row + begin, std::uint8_t{1});
        });
    });
    for_each_reach(ends, side, executor,
                   [&](std::size_t first, std::size_t last, std::size_t step) {
                       for (std::size_t y = 0; y + step < height; ++y) {
                           std::uint8_t* const row = ends.values.data() + y * width;
                           const std::uint8_t* const above = row + step * width;
                           for (std::size_t x = first; x < last; ++x) row[x] |= above[x];
                       }
                   });
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

/// The part of `wide` that begins `shift` cells above and to the right of its first cell, in place.
Raster<std::uint8_t> cropped(Raster<std::uint8_t> wide, std::int32_t width, std::int32_t height,
                             std::int32_t shift) {
    for (std::int32_t y = 0; y < height; ++y) {
        const Cell from{wide.origin.x + shift, wide.origin.y + y + shift};
        const std::size_t to = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        std::memmove(&wide.values[to], &wide.values[wide.offset(from)],
                     static_cast<std::size_t>(width));
    }
    wide.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    wide.width = width;
    wide.height = height;
    return wide;
}

}  // namespace

Raster<std::uint8_t> find_thick_parts(const Raster<std::uint8_t>& mask, std::int32_t side_cells,
                                      const Executor& executor) {
    const std::int32_t side = std::max(side_cells, 1);
    Raster<std::uint8_t> wide = widened(mask, side);
    keep_square_ends(wide, side, executor);
    fill_squares(wide, side, executor);
    return cropped(std::move(wide), mask.width, mask.height, 0);
}

Raster<std::uint8_t> find_deep_parts(const Raster<std::uint8_t>& mask, std::int32_t margin_cells,
                                     const Executor& executor) {
    const std::int32_t margin = std::max(margin_cells, 0);
    Raster<std::uint8_t> wide = widened(mask, margin);
    keep_square_ends(wide, 2 * margin + 1, executor);
    return cropped(std::move(wide), mask.width, mask.height, margin);
}

}  // namespace quadcut::draw
