// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/map/bit_raster.hpp"

namespace quadcut {

BitRaster::BitRaster(Cell low, Cell high) {
    origin_ = {low.x & ~(kTileSide - 1), low.y & ~(kTileSide - 1)};
    width_ = (high.x | (kTileSide - 1)) + 1 - origin_.x;
    height_ = (high.y | (kTileSide - 1)) + 1 - origin_.y;
    words_per_row_ = (static_cast<std::size_t>(width_) + 63) / 64;
    words_.assign(words_per_row_ * static_cast<std::size_t>(height_), 0);
}

bool BitRaster::test(Cell cell) const {
    return contains(cell) && (words_[word(cell)] & bit(cell)) != 0;
}

void BitRaster::accumulate_parity() {
    for (std::size_t row = 0; row < words_.size(); row += words_per_row_) {
        std::uint64_t carry = 0;
        for (std::size_t i = row; i < row + words_per_row_; ++i) {
            std::uint64_t parity = words_[i];
            for (int shift = 1; shift < 64; shift *= 2) parity ^= parity << shift;
            words_[i] = parity ^ carry;
            carry = std::uint64_t{0} - (words_[i] >> 63);
        }
    }
}

void BitRaster::add(const BitRaster& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
}

std::uint64_t BitRaster::tile_rows(std::int32_t tile_x, std::int32_t tile_y) const {
    const auto first = static_cast<std::size_t>(tile_y) * kTileSide * words_per_row_ +
                       (static_cast<std::size_t>(tile_x) >> 3);
    const int shift = (tile_x & 7) * kTileSide;
    std::uint64_t rows = 0;
    for (std::size_t row = 0; row < kTileSide; ++row) {
        rows |= (words_[first + row * words_per_row_] >> shift & 0xFF) << (row * kTileSide);
    }
    return rows;
}

}  // namespace quadcut
