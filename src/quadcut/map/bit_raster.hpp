// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/tile.hpp"

namespace quadcut {

/// A rectangle of cells with one bit each. Its origin, width and height are multiples of a tile.
class BitRaster {
public:
    /// Covers at least the cells low .. high (inclusive), all bits clear.
    BitRaster(Cell low, Cell high);

    [[nodiscard]] Cell origin() const { return origin_; }
    [[nodiscard]] std::int32_t width() const { return width_; }
    [[nodiscard]] std::int32_t height() const { return height_; }

    /// Cells outside are ignored.
    void set(Cell cell) {
        if (contains(cell)) words_[word(cell)] |= bit(cell);
    }
    void flip(Cell cell) {
        if (contains(cell)) words_[word(cell)] ^= bit(cell);
    }
    [[nodiscard]] bool test(Cell cell) const;

    /// Every cell becomes the parity of the bits from the row's left end up to itself.
    void accumulate_parity();
    /// Sets what is set in `other`. @pre the same rectangle.
    void add(const BitRaster& other);
    /// The cells of tile (x, y) of the rectangle, counted in tiles from its origin: bit 8 y + x.
    [[nodiscard]] std::uint64_t tile_rows(std::int32_t tile_x, std::int32_t tile_y) const;

private:
    [[nodiscard]] bool contains(Cell cell) const {
        return static_cast<std::uint32_t>(cell.x - origin_.x) <
                   static_cast<std::uint32_t>(width_) &&
               static_cast<std::uint32_t>(cell.y - origin_.y) < static_cast<std::uint32_t>(height_);
    }
    [[nodiscard]] std::size_t word(Cell cell) const {
        return static_cast<std::size_t>(cell.y - origin_.y) * words_per_row_ +
               (static_cast<std::size_t>(cell.x - origin_.x) >> 6);
    }
    [[nodiscard]] std::uint64_t bit(Cell cell) const {
        return std::uint64_t{1} << ((cell.x - origin_.x) & 63);
    }

    Cell origin_;
    std::int32_t width_ = 0;
    std::int32_t height_ = 0;
    std::size_t words_per_row_ = 0;
    std::vector<std::uint64_t> words_;
};

}  // namespace quadcut
